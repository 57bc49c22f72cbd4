"""A program's printed text, handed on line by line."""

import io
from collections.abc import Callable

#: A line longer than this is handed on in parts.
LONGEST_LINE = 8192


class LineWriter(io.TextIOBase):
    """A text stream that hands on whole lines, each with its line end.

    Args:
        on_line: is called with every line; `flush` alone hands on an unfinished one.
        on_flush: is called when the program wants what it has printed to be seen now.
    """

    def __init__(
        self, on_line: Callable[[str], object], on_flush: Callable[[], object] = bool
    ) -> None:
        super().__init__()
        self._on_line = on_line
        self._on_flush = on_flush
        self._unfinished = ""
        self._unseen = False

    def writable(self) -> bool:
        return True

    def write(self, text: str, /) -> int:
        if not isinstance(text, str):
            raise TypeError(f"write() argument must be str, not {type(text).__name__}")
        self._unseen = True
        *lines, rest = (self._unfinished + text).split("\n")
        for line in lines:
            self._hand_on(line + "\n")
        while len(rest) > LONGEST_LINE:
            self._hand_on(rest[:LONGEST_LINE])
            rest = rest[LONGEST_LINE:]
        self._unfinished = rest
        return len(text)

    def flush(self) -> None:
        """Hand on everything at once, as a program does by ``print(..., flush=True)``."""
        # Python itself flushes a stream that it throws away, when nobody listens any more.
        if self._unseen:
            self.finish()
            self._on_flush()

    def finish(self) -> None:
        """Hand on what has no line end yet."""
        self._unseen = False
        if self._unfinished:
            self._on_line(self._unfinished)
            self._unfinished = ""

    def _hand_on(self, line: str) -> None:
        for start in range(0, len(line), LONGEST_LINE):
            self._on_line(line[start : start + LONGEST_LINE])
