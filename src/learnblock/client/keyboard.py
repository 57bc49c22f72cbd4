"""The keys of the keyboard that a person holds down while a program runs."""

from collections.abc import Callable, Collection
from typing import Literal, get_args

from learnblock.errors import UnknownNameError

#: A key that programs can ask for; letters are lower-case, whether or not Shift is held.
# fmt: off
Key = Literal[
    "up", "down", "left", "right", "space", "enter",
    "a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k", "l", "m",
    "n", "o", "p", "q", "r", "s", "t", "u", "v", "w", "x", "y", "z",
    "0", "1", "2", "3", "4", "5", "6", "7", "8", "9",
]
# fmt: on
KEYS: tuple[Key, ...] = get_args(Key)


class Keyboard:
    """The keyboard that a program reads; without an argument, one without pressed keys.

    Args:
        pressed: returns the keys that are held down now.
    """

    def __init__(self, pressed: Callable[[], Collection[str]] = frozenset) -> None:
        self._pressed = pressed

    def is_pressed(self, key: str) -> bool:
        """Whether a key is held down.

        Raises:
            UnknownNameError: there is no such key.
        """
        if key not in KEYS:
            raise UnknownNameError("key", str(key), KEYS)
        return key in self._pressed()
