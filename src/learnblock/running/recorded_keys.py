"""Keys that were recorded in a trace, or written by hand, to be pressed again in a run."""

from bisect import bisect_right
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from operator import itemgetter
from pathlib import Path

import msgspec

from learnblock.client.keyboard import KEYS
from learnblock.errors import Diagnostic, ProgramError, UnknownNameError
from learnblock.i18n import Phrase

#: Seconds by which a time in a trace may have been rounded.
ROUNDING = 1e-6


class _Line(msgspec.Struct):
    """What matters in a line of a trace.

    Args:
        t: seconds of the robot's time.
        keys: the keys held from then on; None in a line about something else.
        robot: the robot whose program found them held; None for every robot.
    """

    t: float = 0.0
    keys: tuple[str, ...] | None = None
    robot: str | None = None


@dataclass(frozen=True, slots=True)
class RecordedKeys:
    """The keys that are held down in the course of a run.

    Args:
        changes: (seconds of the robot's time, the keys held from then on), in order of time.
    """

    changes: tuple[tuple[float, tuple[str, ...]], ...]

    def held(self, time: float) -> tuple[str, ...]:
        """The keys that are held at this time of the robot."""
        at = bisect_right(self.changes, time + ROUNDING, key=itemgetter(0))
        return self.changes[at - 1][1] if at else ()


def read_keys(path: Path) -> RecordedKeys:
    """Read the keys in a trace, or in a file of lines such as ``{"t": 1.5, "keys": ["up"]}``.

    Raises:
        ProgramError: a line is invalid, or names a key that does not exist.
        OSError: it cannot be read.
    """
    return _recorded(line for _, line in _read(path))


def read_keys_of(path: Path, robots: Sequence[str]) -> dict[str, RecordedKeys]:
    """Read the keys of a run with several robots, by the robot's name.

    A line with ``"robot": "one"`` is for this robot only, any other for all of them.

    Raises:
        ProgramError: a line is invalid, or names a key or a robot that does not exist.
        OSError: it cannot be read.
    """
    lines = []
    for number, line in _read(path):
        if line.robot is not None and line.robot not in robots:
            raise _invalid(path, number, UnknownNameError("robot", line.robot, robots).phrase)
        lines.append(line)
    return {
        name: _recorded(line for line in lines if line.robot in {None, name}) for name in robots
    }


def _recorded(lines: Iterable[_Line]) -> RecordedKeys:
    changes = ((line.t, line.keys or ()) for line in lines)
    return RecordedKeys(tuple(sorted(changes, key=itemgetter(0))))


def _read(path: Path) -> Iterator[tuple[int, _Line]]:
    """The lines about keys, each with its number."""
    decode = msgspec.json.Decoder(_Line).decode
    with path.open("rb") as lines:
        for number, text in enumerate(lines, 1):
            # A trace has millions of other lines.
            if b'"keys"' not in text:
                continue
            try:
                line = decode(text.decode())
            except UnicodeDecodeError as error:
                not_utf_8 = Phrase("run-not-utf-8", byte=f"{error.object[error.start]:#x}")
                raise _invalid(path, number, not_utf_8) from error
            except msgspec.DecodeError as error:
                raise _invalid(path, number, Phrase("report-keys-line")) from error
            for key in line.keys or ():
                if key not in KEYS:
                    raise _invalid(path, number, UnknownNameError("key", key, KEYS).phrase)
            if line.keys is not None:
                yield number, line


def _invalid(path: Path, line: int, message: Phrase) -> ProgramError:
    return ProgramError(str(path), [Diagnostic("invalid-keys", message, line)])
