"""The keys that a step of a lesson presses when its checks run without a player."""

from collections import Counter
from collections.abc import Iterator, Sequence
from itertools import groupby
from operator import itemgetter
from typing import Annotated

from msgspec import Meta, Struct

from learnblock.client.keyboard import KEYS, Key
from learnblock.running.recorded_keys import RecordedKeys


class KeyPress(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """A key that is pressed once or repeatedly.

    Args:
        key: the key.
        at: when it is pressed first, in seconds of the robot's time.
        seconds: how long it is held each time.
        times: how many times it is pressed.
        every: the seconds from one time to the next.
    """

    key: Key
    at: Annotated[float, Meta(ge=0, le=3600)]
    seconds: Annotated[float, Meta(ge=0.05, le=600)] = 0.2
    times: Annotated[int, Meta(ge=1, le=100)] = 1
    every: Annotated[float, Meta(ge=0.1, le=60)] = 1.0


def recorded_keys(presses: Sequence[KeyPress]) -> RecordedKeys | None:
    """The keys as they are held in the course of a run; None if none is pressed."""
    if not presses:
        return None
    edges = sorted((edge for press in presses for edge in _edges(press)), key=itemgetter(0))
    return RecordedKeys(tuple(_changes(edges)))


def _edges(press: KeyPress) -> Iterator[tuple[float, Key, int]]:
    """When a key goes down (1) and up (-1)."""
    for number in range(press.times):
        down = press.at + number * press.every
        yield round(down, 6), press.key, 1
        yield round(down + press.seconds, 6), press.key, -1


def _changes(edges: Sequence[tuple[float, Key, int]]) -> Iterator[tuple[float, tuple[str, ...]]]:
    # A key may be pressed again before it is released: it is held until the last release.
    down = Counter[str]()
    for time, together in groupby(edges, key=itemgetter(0)):
        for _, key, change in together:
            down[key] += change
        yield time, tuple(key for key in KEYS if down[key])
