"""What jupyter-server-proxy learns about LearnBlock; the rest is in tests/wire/hub."""

import socket
import subprocess
import sys
from importlib.metadata import entry_points
from pathlib import Path

import pytest

from learnblock import hub
from learnblock.server.http import address, protection


def test_the_proxy_finds_it_by_its_entry_point():
    (found,) = [
        one for one in entry_points(group="jupyter_serverproxy_servers") if one.name == "learnblock"
    ]
    assert found.load() is hub.proxied_server


def test_it_names_the_token_as_the_server_does():
    assert hub.TOKEN_VARIABLE == address.VARIABLE
    assert hub.TOKEN_COOKIE == protection.COOKIE


def test_the_proxy_sends_the_token_that_learnblock_expects():
    server = hub.proxied_server()
    secret = server["environment"][hub.TOKEN_VARIABLE]
    assert server["request_headers_override"] == {"Cookie": f"{hub.TOKEN_COOKIE}={secret}"}
    assert "--proxy-sends-token" in server["command"]
    # A command can be seen by all users of the computer.
    assert secret not in " ".join(server["command"])


def test_each_jupyter_server_has_a_new_token():
    one, other = (hub.proxied_server()["environment"] for _ in range(2))
    assert one != other


@pytest.mark.skipif(not hasattr(socket, "AF_UNIX"), reason="Windows")
def test_it_listens_on_a_socket_that_only_its_user_can_open():
    server = hub.proxied_server()
    assert server["unix_socket"] is True
    assert server["command"][-2:] == ["--unix-socket", "{unix_socket}"]


def test_where_there_are_no_unix_sockets_it_listens_on_a_port(monkeypatch):
    monkeypatch.delattr(socket, "AF_UNIX", raising=False)
    server = hub.proxied_server()
    assert server["unix_socket"] is False
    assert server["command"][-2:] == ["--port", "{port}"]


def test_its_icon_is_the_one_of_the_page():
    icon = Path(hub.proxied_server()["launcher_entry"]["icon_path"])
    assert icon.read_text("utf-8").startswith("<svg")


def imported(modules):
    """Return the names of all modules that are imported with these."""
    script = f"import sys, {modules}; print(*sys.modules)"
    done = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, check=True
    )
    return set(done.stdout.split())


def test_the_page_on_a_laptop_imports_nothing_of_it():
    names = imported("learnblock.cli.page, learnblock.server.serve, learnblock.server.pages.lobby")
    assert not {"learnblock.hub", "jupyterhub", "jupyter_server_proxy", "tornado"} & names


def test_jupyter_imports_nothing_of_the_page():
    assert {one for one in imported("learnblock.hub") if one.startswith("learnblock")} == {
        "learnblock",
        "learnblock.hub",
    }
