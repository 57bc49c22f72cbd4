"""The lines of JSON between a client and the agent, or `serve` over rpyc; see agent.py."""

import hashlib
import hmac
from typing import TypeVar

import msgspec

from learnblock.errors import RobotBusyError, RobotConnectionError
from learnblock.robots.ev3.brick import Drive, Look, Say, Show, State, Tone, Word
from learnblock.robots.ev3.settings import Settings

#: The maximum number of bytes of a line.
LONGEST_LINE = 4096
#: The codes of the agent's errors.
_ERRORS = frozenset(
    {
        "ev3-motor-lost",
        "ev3-no-motor",
        "ev3-no-sensor",
        "ev3-not-understood",
        "ev3-taken",
        "ev3-timed-out",
        "ev3-unknown-token",
    }
)


class Greeting(msgspec.Struct, frozen=True):
    """The first line of an agent."""

    learnblock: int
    nonce: str


class Answer(msgspec.Struct, frozen=True):
    """The answer to a command: the brick's state, or an error."""

    state: State | None = None
    #: A code, or a sentence from an agent older than LearnBlock 0.2.
    error: str | None = None
    values: dict[str, str] = {}
    speaks: bool = False
    #: Whether the reason is another client.
    taken: bool = False


_Line = TypeVar("_Line", Greeting, Answer)
_GREETING, _ANSWER = msgspec.json.Decoder(Greeting), msgspec.json.Decoder(Answer)
_ENCODER = msgspec.json.Encoder()


def greeting(line: bytes) -> Greeting:
    """Read the first line.

    Raises:
        ValueError: it does not come from an agent.
    """
    return _read(line, _GREETING)


def answer(line: bytes | str, place: str) -> Answer:
    """Read the answer to a command.

    Args:
        line: the line.
        place: the brick's address, for errors.

    Raises:
        ValueError: it does not come from an agent.
        RobotConnectionError: the brick reports an error.
        RobotBusyError: it has another client.
    """
    read = _read(line, _ANSWER)
    if read.error is not None:
        raise _error(read, read.error, place)
    if read.state is None:
        raise ValueError("an answer without a state")
    return read


def _error(read: Answer, code: str, place: str) -> RobotConnectionError:
    if read.taken:
        return RobotBusyError("ev3-taken", place=place)
    if code not in _ERRORS:
        return RobotConnectionError("ev3-complaint", place=place, reason=code[:200])
    values = {"port": "?", "sensor": "", **read.values}
    match code:
        case "ev3-no-motor":
            return RobotConnectionError(code, place=place, port=values["port"][:9])
        case "ev3-no-sensor":
            return RobotConnectionError(
                code, place=place, port=values["port"][:9], sensor=values["sensor"][:20]
            )
    return RobotConnectionError(code, place=place)


def spoken(word: Word) -> bytes:
    """A command as a line, without its end."""
    match word:
        case Drive(left, right):
            return _ENCODER.encode({"drive": [left, right]})
        case Tone(hertz, milliseconds):
            return _ENCODER.encode({"tone": [hertz, milliseconds]})
        case Say(text):
            return _ENCODER.encode({"say": text[:500]})
        case Look() | Show():
            # The brick's own menu has the screen: links with the agent do not show.
            return b"{}"


def introduction(settings: Settings, nonce: str) -> bytes:
    """The client's first line: proof of the secret, and the ports of motors and sensors."""
    proof = hmac.new(settings.token.encode(), nonce.encode(), hashlib.sha256).hexdigest()
    return msgspec.json.encode(
        {
            "proof": proof,
            "motors": [settings.left, settings.right],
            "sensors": settings.sensors,
        }
    )


def _read(line: bytes | str, decoder: msgspec.json.Decoder[_Line]) -> _Line:
    try:
        return decoder.decode(line)
    except msgspec.MsgspecError as error:
        raise ValueError(str(error)) from error
