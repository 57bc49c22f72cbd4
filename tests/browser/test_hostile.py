"""Hostile pages against the real process: each is refused without affecting other pages."""

import http.client
import socket
from contextlib import contextmanager, suppress

import pytest
from websockets.exceptions import ConnectionClosed, InvalidStatus
from websockets.sync.client import connect

from browser.conftest import Server
from browser.hostile import disordered, malformed, stream
from example_messages import PROGRAM
from pages import TIMEOUT, Visitor, english

pytestmark = pytest.mark.certain

#: The number of messages sent over one connection.
BREATH = 100
MEGABYTE = 1024 * 1024
#: The name of a project that does not exist.
UNKNOWN = "no-such-project"
MASK = b"\0\0\0\0"
UNKNOWN_OPCODE = b"\x83\x80" + MASK
WITHOUT_MASK = b"\x81\x02{}"
#: Half a character.
NO_TEXT = b"\x81\x81" + MASK + "é".encode()[:1]


def frame_of(size):
    """Return the header of a websocket frame for a text of `size` bytes."""
    return b"\x81\xff" + size.to_bytes(8, "big") + MASK


@pytest.fixture(scope="module")
def own_server(tmp_path_factory):
    """A server for all of these tests."""
    with serving(tmp_path_factory.mktemp("hostile")) as server:
        yield server


@pytest.fixture
def stranger(own_server):
    """A hostile page in a project that others use."""
    with visit(own_server) as stranger:
        stranger.project = stranger.open("shared", PROGRAM)["name"]
        yield stranger


# Messages.


def test_each_of_nine_thousand_malformed_messages_is_refused(own_server, stranger):
    for seed in range(89):
        with visit(own_server) as another:
            assert refusals(another, seed) == BREATH
    assert refusals(stranger, seed=89) == BREATH
    check_that_editing_works(own_server, stranger.project)


def test_a_thousand_messages_at_the_wrong_time_are_handled_or_refused(own_server, stranger):
    for seed in range(10):
        with visit(own_server) as another:
            another.say("Open", name=name_of_project(stranger))
            for message in stream(disordered, BREATH, seed):
                another.say_raw(message)
            settle(another)
    check_that_editing_works(own_server, name_of_project(stranger))


@pytest.mark.parametrize("size", [4, 7])
def test_a_message_that_is_too_long_is_refused(own_server, stranger, size):
    stranger.say("EditText", edit=2, notation="python", text="x" * size * MEGABYTE)
    assert "too long" in english(stranger.hear("Failed")["message"])
    check_that_editing_works(own_server, stranger.project)


@pytest.mark.parametrize(
    ("data", "code"),
    [
        (frame_of(9 * MEGABYTE), 1009),
        (frame_of(2**62), 1009),
        (UNKNOWN_OPCODE, 1002),
        (WITHOUT_MASK, 1002),
        (NO_TEXT, 1007),
    ],
)
def test_an_invalid_websocket_frame_closes_the_connection_with_its_status_code(
    own_server, stranger, data, code
):
    with visit(own_server) as another:
        another.socket.socket.sendall(data)
        assert close_code(another) == code
    check_that_editing_works(own_server, stranger.project)


def test_a_server_stops_with_unfinished_messages_in_its_queue(tmp_path):
    with serving(tmp_path) as server, visit(server) as page:
        page.open()
        for edit in range(BREATH):
            page.say("EditText", edit=edit, notation="blocktext", text=long_program(edit))
            page.say("Undo")
        page.hear("Document", edit=1)
        assert server.stop() == 0


# Senders.


def test_a_wrong_token_is_refused(server):
    with visit(server, token="guessed") as stranger:
        assert close_code(stranger) == 4403
    assert status(server, "/?token=guessed") == 403
    assert status(server, f"/?token={server.token}") == 200


@pytest.mark.parametrize("headers", [{"Host": "evil.example"}, {"Origin": "https://evil.example"}])
def test_a_request_for_another_host_or_origin_is_refused(server, headers):
    assert status(server, f"/?token={server.token}", **headers) == 403


@pytest.mark.parametrize(
    ("host", "origin"), [("evil.example", None), ("127.0.0.1", "https://evil.example")]
)
def test_a_websocket_for_another_host_or_origin_is_refused(server, host, origin):
    with pytest.raises(InvalidStatus, match="403"), visit(server, host=host, origin=origin):
        pass


# Files.


@pytest.mark.parametrize("key", ["world", "robot"])
def test_a_project_with_a_path_outside_its_folder_is_refused(pupil, tmp_path, key):
    before = pupil.page.url
    file = tmp_path / "outside.learnblock"
    file.write_text(f'{{"learnblock": 1, "blocktext": ["main:"], "{key}": "../../etc/passwd"}}')
    pupil.upload(file)
    pupil.expect_note("can only name a")
    pupil.picture("refused")
    assert pupil.page.url == before


def test_an_upload_with_a_path_as_its_name_stays_in_the_folder(own_server, stranger):
    stranger.say("Import", filename="../../outside.bt", text=PROGRAM)
    assert stranger.hear("Opened")["name"] == "outside"
    (file,) = own_server.home.parent.rglob("outside*")
    assert file.parent.parent == own_server.home


@contextmanager
def serving(folder):
    """Start a server, and check at the end that our code logged no error."""
    home, log = folder / "home", folder / "log.txt"
    home.mkdir()
    with log.open("w") as errors:
        server = Server(home, errors=errors)
        try:
            yield server
        finally:
            status = server.stop()
    assert status == 0
    assert "/learnblock/" not in log.read_text("utf-8")


@contextmanager
def visit(server, *, token=None, host="127.0.0.1", origin=None):
    """Open a websocket as a page that uses the host name `host`."""
    with connect(
        f"ws://{host}:{server.port}/ws",
        sock=socket.create_connection(("127.0.0.1", server.port)),
        subprotocols=["learnblock", token or server.token],
        origin=origin,
        max_size=None,
        # Some of these pages do not read, which must not delay the end of the connection.
        max_queue=None,
    ) as opened:
        yield Visitor(opened)


def long_program(number):
    """Return a program that takes a while to parse."""
    return "main:\n" + f"    function.sleep({number})\n" * 2000 + "end\n"


def refusals(page, seed):
    """Send a hundred malformed messages; return how many are refused."""
    before = page.heard["Failed"]
    for message in stream(malformed, BREATH, seed):
        page.say_raw(message)
    page.say("ListProjects")
    page.until("Projects")
    return page.heard["Failed"] - before


def settle(page):
    """Wait until all messages sent so far have been handled or refused."""
    page.say("Open", name=UNKNOWN)
    while UNKNOWN not in english(page.hear("Failed")["message"]):
        pass


def name_of_project(stranger):
    """Return the current name of the stranger's project, which another page may have renamed."""
    stranger.pulse()
    renamed = stranger.last.get("ProjectRenamed")
    return renamed["name"] if renamed else stranger.project


def check_that_editing_works(server, project):
    """Open the project in a new page, and check that editing works."""
    with visit(server) as page:
        page.say("Open", name=project)
        page.hear("Document")
        # The first edit keeps another page's text that can't be parsed; the next replaces it.
        page.type("main:\n    function.sleep(3)\nend\n")
        document = page.type("main:\n    function.sleep(2)\nend\n")
        assert "sleep(2)" in document["python"]
        assert document["workspace"]["stacks"]
        assert not document.get("problems")


def close_code(page):
    """Read until the server closes the connection; return the status code."""
    with suppress(ConnectionClosed):
        while True:
            page.next()
    return page.socket.close_code


def status(server, path, **headers):
    """Send an HTTP request; return the status of the answer."""
    connection = http.client.HTTPConnection("127.0.0.1", server.port, timeout=TIMEOUT)
    connection.request("GET", path, headers=headers)
    response = connection.getresponse()
    connection.close()
    return response.status
