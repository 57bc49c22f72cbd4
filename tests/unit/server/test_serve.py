"""`learnblock` from start to end, in its own process."""

import http.client
import os
import signal
import socket
import subprocess
import sys
from contextlib import contextmanager
from pathlib import Path

import pytest
from click.testing import CliRunner
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import connect, unix_connect

from learnblock.cli import main
from learnblock.errors import LearnBlockError
from learnblock.project.files.folder import ProjectFolder
from learnblock.project.files.project import Project
from learnblock.server.http.protection import Protection
from learnblock.server.serve import Service, _bound, _listening, _person, _warn, serve
from pages import TIMEOUT, TOKEN, Visitor
from waiting import wait_for

# Most of them start a server.
pytestmark = [pytest.mark.slow, pytest.mark.realtime]

RUNNING = "main:\n    while True:\n        function.sleep(0.1)\n    end\nend\n"


@contextmanager
def learnblock(*options, stop=signal.SIGTERM):
    """Start the process; return it and the address it printed."""
    command = [sys.executable, "-m", "learnblock", "--no-browser", *options]
    environment = {**os.environ, "LEARNBLOCK_TOKEN": TOKEN}
    process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=environment)
    try:
        yield process, process.stdout.readline().split()[-1]
    finally:
        process.send_signal(stop)
        process.wait(TIMEOUT)
        process.stdout.close()


@contextmanager
def visit(address):
    place = address.split("/")[2]
    with connect(f"ws://{place}/ws", subprotocols=["learnblock", TOKEN]) as opened:
        yield Visitor(opened)


def status(address, cookie):
    connection = http.client.HTTPConnection(address.split("/")[2], timeout=TIMEOUT)
    connection.request("GET", "/palette/en.json", headers={"Cookie": cookie})
    answer = connection.getresponse().status
    connection.close()
    return answer


def children(process):
    found = subprocess.run(
        ["ps", "-o", "pid=", "--ppid", str(process.pid)],
        capture_output=True,
        text=True,
        check=False,
    )
    return found.stdout.split()


@pytest.fixture(scope="module")
def address(tmp_path_factory):
    """The address that a server prints, for tests that change nothing."""
    projects = tmp_path_factory.mktemp("projects")
    with learnblock("--port", "0", "--projects", str(projects)) as (_, printed):
        yield printed


def test_the_address_contains_the_token(address):
    assert address.startswith("http://127.0.0.1:")
    assert address.endswith(f"/?token={TOKEN}")


@pytest.mark.parametrize(
    ("choices", "directly"),
    [
        ({}, False),
        ({"host": "192.168.1.20"}, True),
        ({"host": "192.168.1.20", "allowed_hosts": ("school.example",)}, False),
        ({"unix_socket": Path("socket")}, False),
        ({"proxy_sends_token": True}, False),
    ],
)
def test_connections_are_counted_only_where_others_connect_themselves(tmp_path, choices, directly):
    assert Service(tmp_path, **choices).is_reached_directly == directly


@pytest.mark.parametrize(
    ("headers", "person"),
    [
        ([], ""),
        ([(b"cookie", b"learnblock_token_80=" + TOKEN.encode())], "with the token"),
        ([(b"cookie", b"learnblock_token_80=other")], ""),
        ([(b"sec-websocket-protocol", b"learnblock, " + TOKEN.encode())], "with the token"),
        ([(b"sec-websocket-protocol", b"learnblock, other")], ""),
        ([(b"cookie", b"\xff=\xff")], ""),
    ],
)
def test_whoever_has_the_token_is_known(headers, person):
    assert _person(Protection.of(TOKEN), headers) == person


@pytest.mark.certain
@pytest.mark.parametrize("stop", [signal.SIGTERM, signal.SIGINT])
def test_at_the_end_every_program_ends_and_every_project_is_saved(tmp_path, stop):
    with learnblock("--port", "0", "--projects", str(tmp_path)) as (process, address):
        with visit(address) as page:
            page.open(text=RUNNING)
            page.say("Run")
            page.hear("RunState", state="running")
            page.type(RUNNING + "# edited\n")
            programs = children(process)
            assert len(programs) == 1
            process.send_signal(stop)
            assert process.wait(TIMEOUT) == 0
        with pytest.raises(ProcessLookupError):
            os.kill(int(programs[0]), 0)
    assert "# edited" in (tmp_path / "program.learnblock").read_text("utf-8")


@pytest.mark.certain
@pytest.mark.skipif(sys.platform == "win32", reason="there are no named pipes in folders")
def test_a_second_ctrl_c_ends_a_server_that_hangs_with_everything_saved(tmp_path):
    options = ("--port", "0", "--projects", str(tmp_path))
    with (
        learnblock(*options) as (process, address),
        visit(address) as page,
        visit(address) as other,
    ):
        page.open("mine")
        other.open("hanging")
        file = tmp_path / "hanging.learnblock"
        wait_for(file.exists, "the project is saved")
        # The thread that keeps what another program has written there waits for ever.
        file.unlink()
        os.mkfifo(file)
        other.type("main:\n    print(1)\nend\n")
        page.type(RUNNING + "# edited\n")
        process.send_signal(signal.SIGINT)
        # The server begins to end: it closes its connections.
        with pytest.raises(ConnectionClosed):
            page.until("never")
        process.send_signal(signal.SIGINT)
        process.wait(TIMEOUT)
    assert "# edited" in (tmp_path / "mine.learnblock").read_text("utf-8")
    assert file.is_file()
    assert "print(1)" in file.read_text("utf-8")


@pytest.mark.certain
def test_a_killed_server_leaves_no_program_and_loses_at_most_a_second(tmp_path):
    with learnblock("--port", "0", "--projects", str(tmp_path)) as (process, address):
        with visit(address) as page:
            page.open(text=RUNNING)
            page.hear("Saved", edit=1)
            page.say("Run")
            page.hear("RunState", state="running")
            programs = children(process)
            process.kill()
            process.wait(TIMEOUT)
        wait_for(lambda: not Path("/proc", programs[0]).exists(), "the program ends")
    assert "while True" in (tmp_path / "program.learnblock").read_text("utf-8")


def test_a_file_is_opened_as_a_project(tmp_path):
    file = tmp_path / "my square.bt"
    file.write_text(RUNNING, "utf-8")
    folder = tmp_path / "projects"
    with learnblock("open", str(file), "--port", "0", "--projects", str(folder)) as (_, address):
        assert address.endswith("#project=my%20square")
    assert (folder / "my square.learnblock").is_file()


def test_a_project_of_the_folder_is_opened_in_place(tmp_path):
    ProjectFolder(tmp_path).add(Project("mine", RUNNING))
    file = tmp_path / "mine.learnblock"
    options = ("open", str(file), "--port", "0", "--projects", str(tmp_path))
    with learnblock(*options) as (_, address):
        assert address.endswith("#project=mine")
    assert [path.name for path in tmp_path.glob("*.learnblock")] == ["mine.learnblock"]


def test_it_listens_on_a_unix_socket(tmp_path):
    path = tmp_path / "socket"
    options = (
        "--unix-socket",
        str(path),
        "--allow-host",
        "robots.school",
        "--base-url",
        "/robots/",
    )
    with learnblock(*options, "--projects", str(tmp_path)) as (_, address):
        assert address == f"http://robots.school/robots/?token={TOKEN}"
        with unix_connect(
            str(path),
            "ws://robots.school/robots/ws",
            subprotocols=["learnblock", TOKEN],
            origin="https://robots.school",
        ) as opened:
            assert Visitor(opened).next()["kind"] == "Welcome"
    assert not path.exists()


def test_the_address_has_no_token_if_a_proxy_sends_it(tmp_path):
    options = ("--port", "0", "--proxy-sends-token", "--projects", str(tmp_path))
    with learnblock(*options) as (_, address):
        assert address.endswith("/")
        assert [status(address, cookie) for cookie in ("", f"learnblock_token={TOKEN}")] == [
            403,
            200,
        ]


def test_the_socket_of_a_killed_server_is_taken_over(tmp_path):
    path = tmp_path / "socket"
    with socket.socket(socket.AF_UNIX) as abandoned:
        abandoned.bind(str(path))
    with _listening(Service(tmp_path, unix_socket=path)) as listening:
        assert listening.getsockname() == str(path)
        with (
            pytest.raises(LearnBlockError, match="Another LearnBlock is listening"),
            _listening(Service(tmp_path, unix_socket=path)),
        ):
            pass


def test_a_port_that_is_taken_is_refused_if_it_was_requested(tmp_path):
    with _bound("127.0.0.1", 0) as taken:
        port = taken.getsockname()[1]
        with pytest.raises(LearnBlockError, match=f"port {port}.*--port"):
            serve(Service(tmp_path, port=port))


def test_if_the_default_port_is_taken_another_one_is_used(tmp_path, monkeypatch):
    with _bound("127.0.0.1", 0) as taken:
        port = taken.getsockname()[1]
        monkeypatch.setattr("learnblock.server.serve.DEFAULT_PORT", port)
        with _listening(Service(tmp_path)) as listening:
            assert listening.getsockname()[1] not in {0, port}


@pytest.mark.parametrize(
    "options",
    [{"host": "10.0.0.5"}, {"allowed_hosts": ("robots.school",)}, {"unix_socket": Path("socket")}],
    ids=["host", "allowed-host", "unix-socket"],
)
def test_what_does_not_contain_programs_is_printed_if_others_can_connect(
    tmp_path, monkeypatch, options
):
    service = Service(tmp_path, announce=(said := []).append, **options)
    assert service.is_for_others
    monkeypatch.setattr("learnblock.runtime.containment.survey._refused", frozenset)
    _warn(service)
    assert "Use the network, Start other programs" in str(said[0])


def test_nothing_is_printed_if_all_is_contained(tmp_path, monkeypatch):
    monkeypatch.setattr("learnblock.runtime.containment.survey.survey", tuple)
    _warn(Service(tmp_path, announce=pytest.fail))


def test_by_default_no_other_computer_can_connect(tmp_path):
    assert not Service(tmp_path).is_for_others


def test_a_token_that_no_browser_can_send_is_refused(tmp_path, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_TOKEN", "not a token")
    with pytest.raises(LearnBlockError, match="LEARNBLOCK_TOKEN"):
        serve(Service(tmp_path, port=0))


def test_without_pywebview_a_window_reports_what_it_needs(monkeypatch):
    monkeypatch.setitem(sys.modules, "webview", None)
    ran = CliRunner().invoke(main, ["--language", "en", "--window"])
    assert ran.exit_code == 2
    assert "A window needs an add-on that is not installed." in ran.stderr


def test_a_page_is_answered_by_plain_http(address):
    connection = http.client.HTTPConnection(address.split("/")[2], timeout=TIMEOUT)
    connection.request("GET", f"/?token={TOKEN}")
    assert connection.getresponse().headers["Content-Type"].startswith("text/html")
    connection.close()


@pytest.mark.parametrize(
    ("options", "is_for_one"),
    [({}, False), ({"for_one": True}, True), ({"proxy_sends_token": True}, True)],
)
def test_a_server_behind_a_hub_or_in_a_class_is_one_persons(tmp_path, options, is_for_one):
    assert Service(tmp_path, **options).is_for_one == is_for_one
