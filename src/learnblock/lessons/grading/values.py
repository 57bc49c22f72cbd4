"""What is graded and what is found: plain values, the same on every computer."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

import msgspec

from learnblock.i18n import Phrase

#: How the program of a piece is run: with its simulator in one process if it is plain; like that
#: and isolated, to compare the two; or isolated.
Manner = Literal["shared", "compared", "isolated"]
#: How a result was checked: the program shared its simulator's process; it did and was run again
#: in isolation with the same trace, or with another one; or it was isolated from the start.
Checked = Literal["shared", "shared, same isolated", "isolated, differs shared", "isolated"]
#: The results of a run that was isolated because the shared process could not be trusted.
DIFFERS: Checked = "isolated, differs shared"
#: Why there is no program: none is in what was handed in; or the pupil of a class has not handed
#: the step in, or not reached it.
Absence = Literal["nothing handed in", "not handed in", "not begun"]
#: A text by language.
Texts = Mapping[str, str]


@dataclass(frozen=True, slots=True)
class HandedIn:
    """What a pupil has handed in.

    Args:
        pupil: the name of the file or of the folder that it was in.
        file: the file, as the teacher named it.
        text: the program.
        is_python: whether it is Python.
        tags: the numbers of tags, by name, that its project uses.
        reason: why it can't be graded; None if it can.
        absence: what the table says of a pupil without a program; "" for one with a program.
    """

    pupil: str
    file: str
    text: str = ""
    is_python: bool = False
    tags: Mapping[str, int] = field(default_factory=dict)
    reason: Phrase | None = None
    absence: Absence | Literal[""] = ""


class CheckResult(msgspec.Struct, frozen=True, array_like=True):
    """What a check said of a run.

    Args:
        state: ``met``, ``failed`` or ``open``.
        at: when it was decided, in seconds of the robot's time.
        reason: why it failed.
    """

    state: str
    at: float | None = None
    reason: Texts = {}


class HintResult(msgspec.Struct, frozen=True, array_like=True):
    """A hint that fits.

    Args:
        rule: the code of its rule.
        levels: its levels, from where to look to how in general.
        because: why it was chosen.
    """

    rule: str
    levels: tuple[Texts, ...]
    because: Texts = {}


class Result(msgspec.Struct, frozen=True, kw_only=True):
    """The result of a piece: of a program, in a variant of the step's world, on a robot.

    Args:
        checks: the results of the step's checks, in their order.
        ended: how the run ended; ``refused`` if the program can't be run on the robot.
        seconds: the robot's time at the end.
        trace_sha256: the hash of the trace; empty if the run was ended at no exact moment.
        checked: how the result was checked.
        path: where the robot drove, mm, thinned.
        hints: the hints that fit, best first.
        reason: why the program was refused, or its error.
    """

    checks: tuple[CheckResult, ...] = ()
    ended: str
    seconds: float = 0.0
    trace_sha256: str = ""
    checked: Checked | Literal[""] = ""
    path: tuple[tuple[int, int], ...] = ()
    hints: tuple[HintResult, ...] = ()
    reason: Texts = {}


_decode = msgspec.json.Decoder(Result).decode


def packed(result: Result) -> bytes:
    """A result as JSON: the same bytes for the same result."""
    return msgspec.json.encode(result)


def unpacked(data: bytes) -> Result:
    """The result of JSON.

    Raises:
        msgspec.MsgspecError: it is not one.
    """
    return _decode(data)
