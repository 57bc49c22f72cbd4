"""The keys that a person presses in a terminal of Windows."""

from collections.abc import Iterator
from contextlib import AbstractContextManager, nullcontext
from importlib import import_module

from learnblock.client.keyboard import KEYS

#: What precedes the code of a key that isn't a character; the second is "à" in some code pages.
_SPECIAL = frozenset({b"\x00", b"\xe0"})
_ARROWS = {b"H": "up", b"P": "down", b"K": "left", b"M": "right"}
_NAMED = {b" ": "space", b"\r": "enter", b"\n": "enter"}


class WindowsTerminal:
    """A console whose keys can be read one by one; Ctrl-C still ends a run."""

    def __init__(self) -> None:
        # By name, since type checkers on other systems know none of its functions.
        self._console = import_module("msvcrt")

    def listening(self) -> AbstractContextManager[None]:
        """Receive every key at once; the console always does."""
        return nullcontext()

    def typing(self) -> AbstractContextManager[None]:
        """Let the person type a line; the console is always ready for one."""
        return nullcontext()

    def typed(self) -> list[str]:
        """The keys typed since the last call, in order."""
        return [key for key in self._waiting() if key in KEYS]

    def _waiting(self) -> Iterator[str]:
        while self._console.kbhit():
            code = self._console.getch()
            if code not in _SPECIAL:
                yield _NAMED.get(code, code.decode("ascii", "replace").lower())
            elif self._console.kbhit():
                yield _ARROWS.get(self._console.getch(), "")
