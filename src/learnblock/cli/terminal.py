"""The keys that a person presses in a terminal of Linux or macOS."""

import os
import re
import select
import termios
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from learnblock.client.keyboard import KEYS

#: Bytes read from the terminal at once.
CHUNK = 1024

#: What a terminal sends for a key, apart from letters and digits.
_SENT = {
    "\x1b[A": "up",
    "\x1b[B": "down",
    "\x1b[C": "right",
    "\x1b[D": "left",
    # In the terminal's other mode for arrows.
    "\x1bOA": "up",
    "\x1bOB": "down",
    "\x1bOC": "right",
    "\x1bOD": "left",
    " ": "space",
    "\r": "enter",
    "\n": "enter",
}
_ONE_KEY = re.compile(r"\x1b[\[O][0-9;]*.?|.", re.DOTALL)


class PosixTerminal:
    """A terminal that reports every key at once.

    Args:
        file: the number of the terminal's file.
    """

    def __init__(self, file: int) -> None:
        self._file = file
        self._by_line = termios.tcgetattr(file)
        self._by_key = termios.tcgetattr(file)
        # Signals stay on, so that Ctrl-C ends a run.
        self._by_key[3] &= ~(termios.ICANON | termios.ECHO)

    @contextmanager
    def listening(self) -> Iterator[None]:
        """Receive every key at once while the context is open."""
        self._set(self._by_key)
        try:
            yield
        finally:
            self._set(self._by_line)

    @contextmanager
    def typing(self) -> Iterator[None]:
        """Let the person type a line while the context is open."""
        self._set(self._by_line)
        try:
            yield
        finally:
            self._set(self._by_key)

    def typed(self) -> list[str]:
        """The keys typed since the last call, in order."""
        if not select.select([self._file], [], [], 0)[0]:
            return []
        return keys_in(os.read(self._file, CHUNK).decode(errors="replace"))

    def _set(self, modes: list[Any]) -> None:
        # Keys that were held must become neither an answer nor a command of the shell.
        termios.tcsetattr(self._file, termios.TCSAFLUSH, modes)


def keys_in(text: str) -> list[str]:
    r"""The keys in what a terminal has sent that programs can ask for.

    >>> keys_in("a\x1b[AW\x1b[5~")
    ['a', 'up', 'w']
    """
    keys = [_SENT.get(key, key.lower()) for key in _ONE_KEY.findall(text)]
    return [key for key in keys if key in KEYS]
