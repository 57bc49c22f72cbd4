"""The agent of an EV3's brick, on its own: its requirements, its answers, and invalid input."""

import ast
import contextlib
import json
import socket
import sys

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from bricks import brick
from learnblock.emulators.ev3 import AGENT
from learnblock.errors import RobotConnectionError
from learnblock.robots.ev3 import agent, lines
from learnblock.robots.ev3.brick import Drive, Look, Say, Tone
from learnblock.robots.ev3.settings import Settings

SOURCE = AGENT.read_text()


def test_it_is_python_3_5_with_only_the_standard_library():
    tree = ast.parse(SOURCE, feature_version=(3, 5))
    newer = (ast.JoinedStr, ast.AnnAssign, ast.NamedExpr, ast.AsyncFor, ast.Match)
    assert [node for node in ast.walk(tree) if isinstance(node, newer)] == []
    imported = {
        name.name.partition(".")[0]
        for node in ast.walk(tree)
        if isinstance(node, ast.Import | ast.ImportFrom)
        for name in node.names
        if isinstance(node, ast.Import)
    }
    assert imported <= sys.stdlib_module_names
    # New in 3.6 and later.
    for name in ("secrets", "capture_output", "text=", "removeprefix", "dataclass", "_000"):
        assert name not in SOURCE


class FakeBrick:
    """Records its calls."""

    def __init__(self):
        self.told = []

    def state(self):
        return {"left": 0, "right": 0}

    def drive(self, speeds):
        self.told.append(speeds)

    tone = say = drive

    def hush(self):
        self.told.append("hushed")


def test_the_brick_executes_the_clients_commands():
    brick = FakeBrick()
    guard = agent.Guard(brick, lambda: None, agent.BrickClock())
    for word in (Drive(10.5, -20), Tone(440, 100), Say("é 名"), Look()):
        assert lines.answer(guard.answer(lines.spoken(word).decode()), "there").state is not None
    guard.close()
    assert brick.told == [[10.5, -20], [440, 100], "é 名", [0, 0], "hushed"]


@settings(max_examples=150)
@given(
    st.one_of(
        st.text(),
        st.recursive(
            st.none() | st.booleans() | st.floats() | st.integers() | st.text(),
            lambda inner: st.lists(inner) | st.dictionaries(st.text(), inner),
        ).map(json.dumps),
        st.dictionaries(
            st.sampled_from(["drive", "tone", "motors", "sensors", "proof"]),
            st.one_of(st.text(), st.lists(st.floats() | st.text()), st.integers()),
        ).map(json.dumps),
    )
)
def test_the_agent_answers_every_line_with_a_state_or_an_error(line):
    guard = agent.Guard(FakeBrick(), lambda: None, agent.BrickClock())
    try:
        assert set(json.loads(guard.answer(line))) in (
            {"error", "values"},
            {"state", "speaks"},
        )
    finally:
        guard.close()
    with contextlib.suppress(agent.BrickError):
        agent.wished(agent.parsed(line))


@settings(max_examples=150)
@given(
    st.one_of(
        st.binary(),
        st.text().map(str.encode),
        st.from_regex(rb'\{"(state|error|nonce)": ?(\{"left": -?\d{1,400}e?\d*\}|"[^"]*"|null)\}'),
    )
)
def test_every_line_from_an_agent_is_read_or_rejected(line):
    for read in (lines.greeting, lambda line: lines.answer(line, "there")):
        try:
            read(line)
        except (ValueError, RobotConnectionError):
            continue


# Over the wire.


@pytest.fixture(scope="module")
def emulated():
    with brick("agent") as emulation:
        yield emulation.settings


@pytest.fixture
def stranger(emulated):
    """A client that connects; yields a socket and its lines."""
    connection = socket.create_connection(("127.0.0.1", emulated["agent_port"]), 5)
    with connection, connection.makefile("rb") as heard:
        yield connection, heard


def introduction(heard, token, **others):
    nonce = lines.greeting(heard.readline()).nonce
    return lines.introduction(Settings(token=token, **others), nonce) + b"\n"


def test_a_client_is_answered_with_the_bricks_state(emulated, stranger):
    connection, heard = stranger
    connection.sendall(introduction(heard, emulated["token"]) + b"{}\n")
    assert [sorted(json.loads(heard.readline())["state"]) for _ in range(2)] == [
        ["battery", "colour", "gyroscope", "left", "right", "touch", "ultrasonic"]
    ] * 2


def test_a_nonce_is_never_sent_twice(emulated):
    nonces = set()
    for _ in range(5):
        with socket.create_connection(("127.0.0.1", emulated["agent_port"]), 5) as connection:
            nonces.add(connection.recv(4096))
    assert len(nonces) == 5


@pytest.mark.parametrize("said", [b"\n", b"nonsense\n", b'{"drive": [500, 500]}\n', b"[]\n"])
def test_a_client_without_the_secret_gets_an_error_and_is_disconnected(stranger, said):
    connection, heard = stranger
    heard.readline()
    connection.sendall(said)
    assert "error" in json.loads(heard.readline())
    assert heard.readline() == b""


def test_an_endless_line_ends_the_connection(stranger):
    connection, heard = stranger
    heard.readline()
    with contextlib.suppress(OSError):
        # It may be closed before everything is sent.
        connection.sendall(b"x" * 20_000)
    with pytest.raises(OSError, match=r"reset|pipe|abort"):
        heard.read() or connection.sendall(b"x")


def test_idle_clients_do_not_block_others(emulated, stranger):
    connection, heard = stranger
    connection.sendall(introduction(heard, emulated["token"]))
    assert "state" in json.loads(heard.readline())
    with contextlib.ExitStack() as waiting:
        for _ in range(20):
            address = ("127.0.0.1", emulated["agent_port"])
            waiting_one = waiting.enter_context(socket.create_connection(address, 5))
            assert waiting_one.recv(4096)
    connection.sendall(b"{}\n")
    assert "state" in json.loads(heard.readline())


def test_a_client_that_sends_invalid_data_gets_an_error_and_stays_connected(emulated, stranger):
    connection, heard = stranger
    connection.sendall(introduction(heard, emulated["token"]))
    assert "state" in json.loads(heard.readline())
    connection.sendall(b'{"drive": ["fast", null]}\n{}\n')
    assert json.loads(heard.readline()) == {"error": "ev3-not-understood", "values": {}}
    assert "state" in json.loads(heard.readline())
