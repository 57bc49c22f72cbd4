"""A program's printed text, handed on line by line."""

import io
from collections.abc import Callable

#: A line longer than this is handed on in parts.
LONGEST_LINE = 8192


class LineWriter(io.TextIOBase):
    """A text stream that hands on whole lines, each with its line end.

    Args:
        on_line: is called with every line; `flush` alone hands on an unfinished one.
    """

    def __init__(self, on_line: Callable[[str], object]) -> None:
        super().__init__()
        self._on_line = on_line
        self._unfinished = ""

    def writable(self) -> bool:
        return True

    def write(self, text: str, /) -> int:
        if not isinstance(text, str):
            raise TypeError(f"write() argument must be str, not {type(text).__name__}")
        *lines, rest = (self._unfinished + text).split("\n")
        for line in lines:
            self._hand_on(line + "\n")
        while len(rest) > LONGEST_LINE:
            self._hand_on(rest[:LONGEST_LINE])
            rest = rest[LONGEST_LINE:]
        self._unfinished = rest
        return len(text)

    def finish(self) -> None:
        """Hand on what has no line end yet."""
        if self._unfinished:
            self._on_line(self._unfinished)
            self._unfinished = ""

    def _hand_on(self, line: str) -> None:
        for start in range(0, len(line), LONGEST_LINE):
            self._on_line(line[start : start + LONGEST_LINE])
