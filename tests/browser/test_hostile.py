"""Hostile pages before the real process: each is refused, and nobody else notices."""

import http.client
import socket
from contextlib import contextmanager, suppress

import pytest
from websockets.exceptions import ConnectionClosed, InvalidStatus
from websockets.sync.client import connect

from browser.conftest import Server
from browser.hostile import PROGRAM, disordered, malformed, stream
from pages import PATIENCE, Visitor

#: Messages of one connection.
BREATH = 100
MEGABYTE = 1024 * 1024
#: Of no project.
NOBODY = "nobody"
MASK = b"\0\0\0\0"
UNKNOWN_OPCODE = b"\x83\x80" + MASK
WITHOUT_MASK = b"\x81\x02{}"
#: Half a character.
NO_TEXT = b"\x81\x81" + MASK + "é".encode()[:1]


def frame_of(size):
    """The head of a websocket's frame: a text of so many bytes is to follow."""
    return b"\x81\xff" + size.to_bytes(8, "big") + MASK


@pytest.fixture(scope="module")
def own_server(tmp_path_factory):
    """A server for all of these tests."""
    with serving(tmp_path_factory.mktemp("hostile")) as server:
        yield server


@pytest.fixture
def stranger(own_server):
    """A page that means no good, in a project that others work on."""
    with visit(own_server) as stranger:
        stranger.project = stranger.open("shared", PROGRAM)["name"]
        yield stranger


# What is said.


def test_each_of_nine_thousand_malformed_messages_is_refused(own_server, stranger):
    for seed in range(89):
        with visit(own_server) as another:
            assert refusals(another, seed) == BREATH
    assert refusals(stranger, seed=89) == BREATH
    works_as_ever(own_server, stranger.project)


def test_a_thousand_messages_at_the_wrong_time_are_obeyed_or_refused(own_server, stranger):
    for seed in range(10):
        with visit(own_server) as another:
            another.say("Open", name=stranger.project)
            for said in stream(disordered, BREATH, seed):
                another.say_raw(said)
            settle(another)
    works_as_ever(own_server, stranger.project)


@pytest.mark.parametrize("size", [4, 7])
def test_a_message_that_is_too_long_is_refused(own_server, stranger, size):
    stranger.say("EditText", edit=2, notation="python", text="x" * size * MEGABYTE)
    assert "too long" in stranger.hear("Failed")["message"]
    works_as_ever(own_server, stranger.project)


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
def test_what_no_browser_sends_closes_its_connection_with_a_reason(
    own_server, stranger, data, code
):
    with visit(own_server) as another:
        another.socket.socket.sendall(data)
        assert code_of_closing(another) == code
    works_as_ever(own_server, stranger.project)


def test_a_server_ends_though_pages_have_said_more_than_it_can_do(tmp_path):
    with serving(tmp_path) as server, visit(server) as page:
        page.open()
        for edit in range(BREATH):
            page.say("EditText", edit=edit, notation="blocktext", text=long_program(edit))
            page.say("Undo")
        page.hear("Document", edit=1)
        assert server.stop() == 0


# Who says it.


def test_a_wrong_token_is_refused(server):
    with visit(server, token="guessed") as stranger:
        assert code_of_closing(stranger) == 4403
    assert status(server, "/?token=guessed") == 403
    assert status(server, f"/?token={server.token}") == 200


@pytest.mark.parametrize("headers", [{"Host": "evil.example"}, {"Origin": "https://evil.example"}])
def test_a_page_of_others_is_refused(server, headers):
    assert status(server, f"/?token={server.token}", **headers) == 403


@pytest.mark.parametrize(
    ("host", "origin"), [("evil.example", None), ("127.0.0.1", "https://evil.example")]
)
def test_a_socket_of_others_is_refused(server, host, origin):
    with pytest.raises(InvalidStatus, match="403"), visit(server, host=host, origin=origin):
        pass


# What a file says.


@pytest.mark.parametrize("key", ["world", "robot"])
def test_a_project_that_leads_out_of_its_folder_is_refused(pupil, tmp_path, key):
    before = pupil.page.url
    file = tmp_path / "outside.learnblock"
    file.write_text(f'{{"learnblock": 1, "blocktext": ["main:"], "{key}": "../../etc/passwd"}}')
    pupil.upload(file)
    pupil.told("and no path")
    pupil.picture("refused")
    assert pupil.page.url == before


def test_a_file_that_is_called_by_a_path_outside_stays_in_the_folder(own_server, stranger):
    stranger.say("Import", filename="../../outside.bt", text=PROGRAM)
    assert stranger.hear("Opened")["name"] == "outside"
    (file,) = own_server.home.parent.rglob("outside*")
    assert file.parent.parent == own_server.home


@contextmanager
def serving(folder):
    """A server that in the end has told of no error in our code."""
    home, told = folder / "home", folder / "told.txt"
    home.mkdir()
    with told.open("w") as errors:
        server = Server(home, errors=errors)
        try:
            yield server
        finally:
            status = server.stop()
    assert status == 0
    assert "/learnblock/" not in told.read_text("utf-8")


@contextmanager
def visit(server, *, token=None, host="127.0.0.1", origin=None):
    """A page with a websocket, which calls the server by the name `host`."""
    with connect(
        f"ws://{host}:{server.port}/ws",
        sock=socket.create_connection(("127.0.0.1", server.port)),
        subprotocols=["learnblock", token or server.token],
        origin=origin,
        max_size=None,
        # Some of these pages do not listen, and must not be in the way of their own farewell.
        max_queue=None,
    ) as opened:
        yield Visitor(opened)


def long_program(number):
    """It takes its time to be read."""
    return "main:\n" + f"    function.sleep({number})\n" * 2000 + "end\n"


def refusals(page, seed):
    """How many of a hundred malformed messages are refused."""
    before = page.heard["Failed"]
    for said in stream(malformed, BREATH, seed):
        page.say_raw(said)
    page.say("ListProjects")
    page.until("Projects")
    return page.heard["Failed"] - before


def settle(page):
    """Return when everything said until now has been obeyed or refused."""
    page.say("Open", name=NOBODY)
    while NOBODY not in page.next().get("message", ""):
        pass


def works_as_ever(server, project):
    """A page comes to the same project, and all of it answers."""
    with visit(server) as page:
        page.say("Open", name=project)
        page.hear("Document")
        document = page.type("main:\n    function.sleep(2)\nend\n")
        assert "sleep(2)" in document["python"]
        assert document["workspace"]["stacks"]
        assert not document.get("problems")


def code_of_closing(page):
    """Hear a page out until the server closes its connection."""
    with suppress(ConnectionClosed):
        while True:
            page.next()
    return page.socket.close_code


def status(server, path, **headers):
    """The status of the answer to a plain request."""
    connection = http.client.HTTPConnection("127.0.0.1", server.port, timeout=PATIENCE)
    connection.request("GET", path, headers=headers)
    response = connection.getresponse()
    connection.close()
    return response.status
