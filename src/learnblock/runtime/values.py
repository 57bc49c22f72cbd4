"""A program's values for messages, traces and the debugger: plain, short and reproducible."""

import re
from typing import Any

#: The maximum length of a value's text.
LONGEST_VALUE = 200
#: The maximum number of nested levels, and of items per list.
DEEPEST_LIST, LONGEST_LIST = 3, 100
#: A text of fewer characters is small.
SHORT = 100

_PLAIN = frozenset({type(None), bool, float})
_LARGEST = 2**63
# The address of an object differs between two runs of a program.
_ADDRESS = re.compile(r" at 0x[0-9a-fA-F]+")
# An object that says no more than its class.
_BARE = re.compile(r"<(?:[\w<>]+\.)*(\w+) object>")


def is_small(value: Any) -> bool:
    """Whether a value takes few bytes in a message, and surely arrives as it is."""
    kind = type(value)
    if kind is int:
        return bool(-_LARGEST <= value < _LARGEST)
    return kind in _PLAIN or (kind is str and value.isascii() and len(value) < SHORT)


def plain(value: Any, levels: int = DEEPEST_LIST) -> Any:
    """`value` as None, bool, int, float, str or a list of these: itself, or a description.

    A plain value stays as it is, so doing this twice changes nothing.
    """
    kind = type(value)
    if kind in _PLAIN or (kind is int and -_LARGEST <= value < _LARGEST):
        return value
    if isinstance(value, str):
        return shortened(encodable(str(value)))
    if kind in (list, tuple) and levels:
        return [plain(item, levels - 1) for item in value[:LONGEST_LIST]]
    if hasattr(value, "dtype"):
        return _of_numpy(value)
    return described(value)


def described(value: object) -> str:
    """The `repr` of a value, shortened and without its address."""
    try:
        text = repr(value)
    except Exception as error:  # noqa: BLE001 - a pupil's __repr__ may raise anything
        return f"<{type(error).__name__} in its own description>"
    return shortened(encodable(_ADDRESS.sub("", text)))


def without_module(text: str) -> str:
    """A description in which an object that has none of its own is named by its class.

    >>> without_module("[<__main__.Driver object>, 3]")
    '[Driver, 3]'
    """
    return _BARE.sub(r"\1", text)


def shortened(text: str, longest: int = LONGEST_VALUE) -> str:
    return text if len(text) <= longest else text[:longest] + "..."


def encodable(text: str) -> str:
    r"""`text` with lone surrogates, which UTF-8 cannot encode, replaced by ``\udc80``."""
    return text if text.isascii() else text.encode("utf-8", "backslashreplace").decode()


def _of_numpy(value: Any) -> Any:
    """A numpy number as a Python number; for an array, which may be a frame, only its shape."""
    return value.item() if value.shape == () else f"<array of shape {value.shape}>"
