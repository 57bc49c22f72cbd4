"""What our agent and its like on rpyc are told and say: lines of JSON, as agent.py describes."""

import hashlib
import hmac
from typing import TypeVar

import msgspec

from learnblock.errors import RobotConnectionError
from learnblock.robots.ev3.brick import Drive, Look, Say, State, TakenError, Tone, Word
from learnblock.robots.ev3.settings import Settings

#: Bytes of the longest line that is read.
LONGEST_LINE = 4096


class Greeting(msgspec.Struct, frozen=True):
    """The first line of an agent."""

    learnblock: int
    nonce: str


class Answer(msgspec.Struct, frozen=True):
    """The answer to a word: how the brick is, or what is wrong."""

    state: State | None = None
    error: str | None = None
    speaks: bool = False
    #: Whether another client is the reason.
    taken: bool = False


_Line = TypeVar("_Line", Greeting, Answer)
_GREETING, _ANSWER = msgspec.json.Decoder(Greeting), msgspec.json.Decoder(Answer)
_ENCODER = msgspec.json.Encoder()


def greeting(line: bytes) -> Greeting:
    """Read the first line.

    Raises:
        ValueError: no agent says that.
    """
    return _read(line, _GREETING)


def answer(line: bytes | str, where: str) -> Answer:
    """Read the answer to a word.

    Args:
        line: as it came.
        where: the brick's place, for sentences.

    Raises:
        ValueError: no agent says that.
        RobotConnectionError: the brick complains.
        TakenError: it has another client.
    """
    said = _read(line, _ANSWER)
    if said.error is not None:
        kind = TakenError if said.taken else RobotConnectionError
        raise kind(f"the EV3 at {where} {said.error[:200]}")
    if said.state is None:
        raise ValueError("an answer without a state")
    return said


def spoken(word: Word) -> bytes:
    """A word as a line, without its end."""
    match word:
        case Drive(left, right):
            return _ENCODER.encode({"drive": [left, right]})
        case Tone(hertz, milliseconds):
            return _ENCODER.encode({"tone": [hertz, milliseconds]})
        case Say(text):
            return _ENCODER.encode({"say": text[:500]})
        case Look():
            return b"{}"


def introduction(settings: Settings, nonce: str) -> bytes:
    """What a client says first: that it knows the secret, and what is plugged in where."""
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
