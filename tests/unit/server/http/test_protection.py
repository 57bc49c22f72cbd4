"""Requests without the right token, Host header or Origin header are refused."""

import pytest
from hypothesis import given
from hypothesis import strategies as st
from starlette.requests import HTTPConnection
from websockets.exceptions import ConnectionClosed, InvalidStatus

from learnblock.server.http.protection import (
    LOCAL_HOSTS,
    Protection,
    is_loopback,
    offered_token,
)
from pages import TOKEN, serving

PROTECTION = Protection.of(TOKEN, ["robots.school", "*"], ["robots.school"])


def request(*raw, client=None, kind="http"):
    return HTTPConnection({"type": kind, "client": client, "headers": raw, "query_string": b""})


def admits(protection, **headers):
    raw = [(name.encode(), value.encode()) for name, value in headers.items()]
    return protection.admits(request(*raw))


@pytest.mark.parametrize(
    "host", ["127.0.0.1:8421", "localhost", "LocalHost:80", "[::1]:8421", "robots.school"]
)
def test_the_machines_own_names_and_the_given_ones_are_hosts(host):
    assert admits(PROTECTION, host=host)


@pytest.mark.parametrize(
    "host",
    [
        "",
        "evil.example",
        "localhost.evil.example",
        "evil.example:8421",
        "[::1",
        "a b",
        "localhost@x",
    ],
)
def test_other_hosts_are_refused(host):
    assert not admits(PROTECTION, host=host)


def test_a_numeric_address_is_a_host_if_the_server_listens_on_all_addresses():
    assert admits(PROTECTION, host="192.168.1.20:8421")
    assert not admits(Protection.of(TOKEN), host="192.168.1.20:8421")


@pytest.mark.parametrize("origin", ["http://localhost:8421", "HTTP://LOCALHOST:8421"])
def test_our_own_page_is_an_origin(origin):
    assert admits(PROTECTION, host="localhost:8421", origin=origin)


def test_a_page_behind_a_proxy_is_an_origin():
    assert admits(PROTECTION, host="localhost:8421", origin="https://robots.school")


@pytest.mark.parametrize(
    "origin",
    ["null", "", "https://evil.example", "http://localhost:3000", "http://localhost", "file://"],
)
def test_pages_of_other_servers_are_refused(origin):
    assert not admits(PROTECTION, host="localhost:8421", origin=origin)


@given(st.text())
def test_only_the_token_is_the_token(token):
    assert PROTECTION.knows(token) == (token == TOKEN)


@given(st.lists(st.text(), max_size=4))
def test_a_token_comes_as_the_second_subprotocol(offered):
    assert offered_token(["learnblock", TOKEN]) == TOKEN
    right = len(offered) == 2 and offered[0] == "learnblock"
    assert offered_token(offered) == (offered[1] if right else None)


@given(st.text(), st.text() | st.none())
def test_any_headers_are_accepted_or_refused(host, origin):
    raw = [(b"host", host.encode())] + ([(b"origin", origin.encode())] if origin else [])
    admitted = PROTECTION.admits(request(*raw))
    assert not admitted or any(name in host.lower() for name in (*LOCAL_HOSTS, ".", ":"))


# Over the wire.


def test_a_wrong_token_closes_the_socket_with_its_own_code(server):
    with server.visit(token="wrong") as visitor:
        with pytest.raises(ConnectionClosed):
            visitor.next()
        assert visitor.socket.close_code == 4403


def test_a_socket_without_a_token_is_closed(server):
    with server.visit(token="learnblock") as visitor, pytest.raises(ConnectionClosed):
        visitor.next()


def test_a_socket_of_another_page_is_refused(server):
    with pytest.raises(InvalidStatus, match="403"), server.visit(origin="https://evil.example"):
        pass


def test_a_socket_by_a_rebound_name_is_refused(server):
    with pytest.raises(InvalidStatus, match="403"), server.visit(host="evil.example"):
        pass


def test_a_request_by_a_rebound_name_is_refused(server):
    assert server.get(f"/?token={TOKEN}", Host="evil.example").status == 403


def test_a_request_of_another_page_is_refused(server):
    assert server.get(f"/?token={TOKEN}", Origin="https://evil.example").status == 403


@pytest.mark.parametrize("path", ["/", "/palette/en.json", "/textures/tag/1.png", "/?token=wrong"])
def test_private_files_need_the_token(server, path):
    assert server.get(path).status == 403


def test_the_cookie_of_the_page_serves_as_its_token(server):
    cookie = server.get(f"/?token={TOKEN}").headers["Set-Cookie"]
    assert {"HttpOnly", "SameSite=strict", "Path=/"} <= set(cookie.split("; "))
    assert server.get("/palette/en.json", Cookie=cookie.split(";")[0]).status == 200


def test_the_cookies_of_two_servers_do_not_conflict(server):
    cookies = "learnblock_token_1=other; learnblock_token_2=" + TOKEN
    assert server.get("/palette/en.json", Cookie=cookies).status == 200


def test_nothing_may_be_fetched_from_other_servers(server):
    headers = server.get(f"/?token={TOKEN}").headers
    assert "default-src 'self'" in headers["Content-Security-Policy"]
    assert "http" not in headers["Content-Security-Policy"]
    assert headers["X-Content-Type-Options"] == "nosniff"
    assert headers["Referrer-Policy"] == "no-referrer"


# Behind a proxy that logs users in, and sends the token for them.

PROXIED = Protection.of(TOKEN, proxy_sends_token=True)
SENT = f"learnblock_token={TOKEN}"


@pytest.fixture(scope="module")
def proxied(tmp_path_factory):
    with serving(tmp_path_factory.mktemp("proxied"), proxy_sends_token=True) as running:
        yield running


def test_the_proxy_may_have_any_name():
    assert admits(PROXIED, host="school.example", cookie=SENT)
    assert admits(PROXIED, host="school.example", cookie=SENT, origin="https://school.example")


@pytest.mark.parametrize("cookie", ["", "learnblock_token=wrong", f"other={TOKEN}"])
def test_without_the_token_no_name_is_admitted(cookie):
    assert not admits(PROXIED, host="localhost", cookie=cookie)


def test_a_page_of_another_site_is_refused_even_if_the_proxy_lets_it_in():
    assert not admits(PROXIED, host="school.example", cookie=SENT, origin="https://evil.example")


@pytest.mark.parametrize("path", ["/", "/palette/en.json", "/assets/x.js", "/manifest.webmanifest"])
def test_not_even_a_file_is_sent_without_the_token_of_the_proxy(proxied, path):
    assert proxied.get(path).status == 403


def test_the_page_gets_no_token(proxied):
    assert proxied.get("/palette/en.json", Cookie=SENT).status == 200
    assert proxied.get("/", Cookie=SENT).headers["Set-Cookie"] is None


def test_the_socket_needs_only_the_token_of_the_proxy(proxied):
    with proxied.visit(token="stale", additional_headers={"Cookie": SENT}) as visitor:
        assert visitor.next()["kind"] == "Welcome"


def test_the_socket_of_a_page_that_comes_past_the_proxy_is_refused(proxied):
    with pytest.raises(InvalidStatus, match="403"), proxied.visit():
        pass


# Users at this computer.

ALONE = Protection.of(TOKEN)


def is_local(protection, client, **headers):
    encoded = [(name.encode(), value.encode()) for name, value in headers.items()]
    return protection.is_local(request(*encoded, client=client, kind="websocket"))


@pytest.mark.parametrize("address", ["127.0.0.1", "127.3.2.1", "::1"])
def test_a_request_from_the_computer_itself_is_local(address):
    assert is_local(ALONE, (address, 4711))


@pytest.mark.parametrize(
    "client", [("192.168.1.20", 80), ("10.0.0.1", 80), ("fe80::1", 80), ("", 0), ("x", 0), None]
)
def test_all_other_requests_are_not(client):
    assert not is_local(ALONE, client)


@pytest.mark.parametrize("header", ["forwarded", "via", "x-forwarded-for", "x-real-ip"])
def test_nor_is_one_that_a_proxy_passes_on(header):
    assert not is_local(ALONE, ("127.0.0.1", 4711), **{header: "127.0.0.1"})


def test_no_request_is_local_to_a_server_that_has_names_for_a_proxy():
    assert not is_local(PROTECTION, ("127.0.0.1", 4711))


def test_no_request_is_local_to_a_server_whose_proxy_sends_the_token():
    assert not is_local(PROXIED, ("127.0.0.1", 4711))


@pytest.mark.parametrize("host", ["localhost", "127.0.0.1", "::1"])
def test_only_this_computer_reaches_its_own_addresses(host):
    assert is_loopback(host)


@pytest.mark.parametrize("host", ["::", "192.168.1.5", "robots.school", ""])
def test_others_reach_the_rest(host):
    assert not is_loopback(host)
