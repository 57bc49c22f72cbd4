"""A program's printed text, passed on line by line."""

import io
from collections.abc import Callable

#: A longer line is passed on in parts.
LONGEST_LINE = 8192


class LineStream(io.TextIOBase):
    """A text stream that passes on whole lines, each with its line end.

    Args:
        on_line: called with every line; only `flush` passes on an unfinished one.
        on_flush: called when the program flushes its output.
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
            self._pass_on(line + "\n")
        while len(rest) > LONGEST_LINE:
            self._pass_on(rest[:LONGEST_LINE])
            rest = rest[LONGEST_LINE:]
        self._unfinished = rest
        return len(text)

    def flush(self) -> None:
        """Pass on everything at once, as ``print(..., flush=True)`` does."""
        # Python also flushes a stream that it discards, when its receiver is gone.
        if self._unseen:
            self.finish()
            self._on_flush()

    def finish(self) -> None:
        """Pass on an unfinished line."""
        self._unseen = False
        if self._unfinished:
            self._on_line(self._unfinished)
            self._unfinished = ""

    def _pass_on(self, line: str) -> None:
        for start in range(0, len(line), LONGEST_LINE):
            self._on_line(line[start : start + LONGEST_LINE])
