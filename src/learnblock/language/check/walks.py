"""Follow a walk through other walks without recursion, however many functions call each other."""

from collections.abc import Iterator
from typing import Any


def flattened(walk: Iterator[Any]) -> Iterator[Any]:
    """What a walk yields; a walk that it yields is followed in its place."""
    ahead = [walk]
    while ahead:
        step = next(ahead[-1], None)
        if step is None:
            ahead.pop()
        elif isinstance(step, Iterator):
            ahead.append(step)
        else:
            yield step


def exhaust(walk: Iterator[Any]) -> None:
    """Follow a walk to its end."""
    for _ in flattened(walk):
        pass
