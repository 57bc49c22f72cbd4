"""What takes the lines of a trace: a file, or what looks at the run in the same process."""

from collections.abc import Mapping, Sequence
from functools import lru_cache
from typing import Any, Protocol

import msgspec

#: The longest step that is kept once for all its lines, in characters.
_LONGEST_STEP = 200


class TraceSink(Protocol):
    """Takes the lines of a trace as they are written: a file."""

    def write(self, lines: bytes, /) -> object: ...


class LineSink(Protocol):
    """Takes the lines of a trace themselves, in the process that records them."""

    def keep(self, line: Mapping[str, Any], /) -> object:
        """Take a line."""

    def keep_steps(self, time: float, steps: Sequence[Mapping[str, Any]], /) -> object:
        """Take lines of one time about the program's steps; those that are alike are the same."""


def about(step: str, after: str) -> Mapping[str, Any]:
    """What a line is about, from the JSON of its step and what comes after it.

    Most steps happen at many times, and those that are alike are the same object.
    """
    return _known(step, after) if len(step) <= _LONGEST_STEP else _read(step, after)


def _read(step: str, after: str) -> Mapping[str, Any]:
    line: Mapping[str, Any] = msgspec.json.decode(f"{{{step}{after}")
    return line


_known = lru_cache(maxsize=10_000)(_read)
