"""Values as the log keeps them: plain, small, and as they were at that moment."""

from itertools import islice
from typing import Any

#: The most characters of a text, items of a list and levels of lists in it.
LONGEST, MOST, DEEPEST = 100, 20, 2
_LARGEST = 2**63
_KEYS = frozenset({str, int, float, bool})
_PLAIN = frozenset({type(None), bool, float})


def snapshot(value: Any, levels: int = DEEPEST) -> Any:
    """A value as plain data; omissions are marked by ``{"more": number}`` or ``{"is": type}``.

    It runs no code of the program.
    """
    kind = type(value)
    if kind in _PLAIN:
        return value
    if kind is int:
        return value if -_LARGEST <= value < _LARGEST else {"is": "int"}
    if kind is str:
        return _text(value)
    if kind in (list, tuple):
        return _items(value, levels)
    if kind is dict:
        return _pairs(value, levels)
    return {"is": kind.__name__}


def _text(value: str) -> str:
    short = value if len(value) <= LONGEST else value[: LONGEST - 3] + "..."
    return short if short.isascii() else short.encode("utf-8", "backslashreplace").decode()


def _items(value: Any, levels: int) -> Any:
    if not levels:
        return {"is": type(value).__name__}
    # Most items are numbers, for which a call would take far longer than the question.
    items = [item if type(item) in _PLAIN else snapshot(item, levels - 1) for item in value[:MOST]]
    if len(value) > MOST:
        items.append({"more": len(value) - MOST})
    return items


def _pairs(value: dict[Any, Any], levels: int) -> Any:
    if not levels:
        return {"is": "dict"}
    few = islice(value.items(), MOST)
    return {
        "pairs": [
            [snapshot(key), snapshot(item, levels - 1)] for key, item in few if type(key) in _KEYS
        ]
    }
