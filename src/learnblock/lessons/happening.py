"""When the events that checks ask about happened in a run."""

import math
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import lru_cache
from typing import Any

from learnblock.evidence.evidence import Evidence, Moment, Noted, TimedPose
from learnblock.evidence.gaps import STILL, heading_between
from learnblock.lessons.checks import (
    At,
    Called,
    Collided,
    Event,
    GoalReached,
    Printed,
    Said,
    Sent,
    Shown,
    Stood,
)

#: Seconds by which the difference of two rounded times may be too short.
_ROUNDING = 0.001


def moments(event: Event, evidence: Evidence) -> Sequence[Moment]:
    """When an event happened, in order."""
    return sorted(_FINDERS[type(event)](event, evidence))


def fits(text: str, pattern: str) -> bool:
    """Whether a text is as a check's pattern says."""
    return _expression(pattern).fullmatch(_plain(text)) is not None


def _plain(text: str) -> str:
    return " ".join(text.split()).casefold()


@lru_cache(maxsize=200)
def _expression(pattern: str) -> re.Pattern[str]:
    # Runs of `*` would take exponential time; no part is tried twice at one place.
    parts = [re.escape(part) for part in re.split(r"\*+", _plain(pattern))]
    first, *others = parts
    if not others:
        return re.compile(first)
    *middle, last = others
    skipping = "".join(f"(?>.*?{part})" for part in middle)
    return re.compile(f"{first}{skipping}.*{last}", re.DOTALL)


def _goal(event: GoalReached, evidence: Evidence) -> Iterable[Moment]:
    return [moment for name, moment in evidence.reached.items() if name == event.name]


def _text(
    get: Callable[[Evidence], Sequence[Noted]], key: str
) -> Callable[[Any, Evidence], Iterable[Moment]]:
    def find(event: Any, evidence: Evidence) -> Iterable[Moment]:
        pattern = getattr(event, key)
        return [moment for moment, text in get(evidence) if fits(text, pattern)]

    return find


def _name(
    get: Callable[[Evidence], Sequence[Noted]], key: str
) -> Callable[[Any, Evidence], Iterable[Moment]]:
    def find(event: Any, evidence: Evidence) -> Iterable[Moment]:
        return [moment for moment, text in get(evidence) if text == getattr(event, key)]

    return find


def _at(event: At, evidence: Evidence) -> Iterator[Moment]:
    was_in = False
    for placed in evidence.path:
        is_in = math.hypot(placed.x - event.x, placed.y - event.y) <= event.radius
        if is_in and not was_in:
            yield placed.moment
        was_in = is_in


def _stood(event: Stood, evidence: Evidence) -> Iterator[Moment]:
    since: TimedPose | None = None
    is_told = False
    for placed in evidence.path:
        if since is None or _has_moved(since, placed):
            since, is_told = placed, False
        elif not is_told and placed.moment.time - since.moment.time + _ROUNDING >= event.seconds:
            is_told = True
            yield placed.moment


def _has_moved(before: TimedPose, now: TimedPose) -> bool:
    moved, turned = STILL
    is_near = math.hypot(now.x - before.x, now.y - before.y) <= moved
    return not is_near or abs(heading_between(before.heading, now.heading)) > turned


_FINDERS: Mapping[type, Callable[[Any, Evidence], Iterable[Moment]]] = {
    GoalReached: _goal,
    Shown: _text(lambda evidence: evidence.shows, "what"),
    Said: _text(lambda evidence: evidence.says, "what"),
    Printed: _text(lambda evidence: evidence.prints, "what"),
    Called: _name(lambda evidence: evidence.calls, "skill"),
    Sent: _name(lambda evidence: evidence.sends, "message"),
    Collided: _text(lambda evidence: evidence.collisions, "thing"),
    At: _at,
    Stood: _stood,
}
