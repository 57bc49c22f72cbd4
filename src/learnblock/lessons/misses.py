"""By how much, and where, a run missed what a check asks for.

The page, `lesson try`, `lesson check` and grading say the same.
"""

import math
from collections.abc import Callable, Mapping
from typing import Any

from learnblock.evidence.evidence import Evidence
from learnblock.evidence.gaps import (
    gap_words,
    heading_between,
    is_on_line,
    length_words,
    longest_stand,
    nearest_point,
    place_at,
    rounded_seconds,
    turn_words,
    turned_along,
    xy,
)
from learnblock.evidence.missed_goals import Miss, RunInWorld, first_bump, missed_goal
from learnblock.i18n import Phrase
from learnblock.lessons.checks import (
    At,
    Check,
    Collided,
    Drives,
    EndsAt,
    Event,
    GoalReached,
    Happens,
    InOrder,
    Never,
    Reaches,
    StaysOnLine,
    Stood,
    Turns,
)
from learnblock.lessons.happening import moments
from learnblock.simulator import WorldDescription


def missed(check: Check, evidence: Evidence, world: WorldDescription | None) -> Miss | None:
    """By how much a run missed a check that it failed; None if its reason says all.

    Args:
        check: the check.
        evidence: what is known of the run.
        world: the world of the run.
    """
    run = RunInWorld(evidence, world)
    if isinstance(check, Reaches):
        return missed_goal(run, check.goals or tuple(run.goals))
    if isinstance(check, Happens):
        return _event(check.what, run) if _is_missing(check, run) else None
    if isinstance(check, InOrder):
        return next((_event(event, run) for event in check.events if not _has(event, run)), None)
    find = _CHECKS.get(type(check))
    return find(check, run) if find else None


def _has(event: Event, run: RunInWorld) -> bool:
    return bool(moments(event, run.evidence))


def _is_missing(check: Happens, run: RunInWorld) -> bool:
    return len(moments(check.what, run.evidence)) < check.at_least


def _event(event: Event, run: RunInWorld) -> Miss | None:
    """By how much an event was missed."""
    if isinstance(event, GoalReached):
        return missed_goal(run, (event.name,))
    if isinstance(event, At):
        return _at(event, run)
    return _stood(event, run) if isinstance(event, Stood) else None


def _at(event: At, run: RunInWorld) -> Miss | None:
    if not run.path:
        return None
    place = (event.x, event.y)
    nearest = nearest_point(run.path, place)
    gap = gap_words(xy(run.path[0]), nearest, place)
    return Miss(Phrase("miss-near", gap=gap), place, nearest)


def _stood(event: Stood, run: RunInWorld) -> Miss | None:
    if not run.path:
        return None
    longest, at = longest_stand(run.path)
    words = Phrase(
        "miss-stood", stood=rounded_seconds(longest), asked=rounded_seconds(event.seconds)
    )
    return Miss(words, None, at)


def _never(check: Never, run: RunInWorld) -> Miss | None:
    if isinstance(check.what, Collided):
        hits = moments(check.what, run.evidence)
        return first_bump(run, hits)
    if isinstance(check.what, At) and _has(check.what, run):
        first, *_ = moments(check.what, run.evidence)
        words = Phrase("miss-was-there", at=rounded_seconds(first.time))
        return Miss(words, (check.what.x, check.what.y), place_at(run.path, first))
    return None


def _ends_at(check: EndsAt, run: RunInWorld) -> Miss | None:
    if not run.path:
        return None
    place, last = (check.x, check.y), run.path[-1]
    if math.dist(xy(last), place) > check.radius:
        gap = gap_words(xy(run.path[0]), xy(last), place)
        return Miss(Phrase("miss-stopped", gap=gap), place, xy(last))
    if check.heading is None:
        return None
    turn = turn_words(heading_between(check.heading, last.heading))
    return Miss(Phrase("miss-stopped-facing", turn=turn), place, xy(last))


def _drives(check: Drives, run: RunInWorld) -> Miss | None:
    driven = run.evidence.distance
    if driven < check.at_least:
        gap = length_words("short", check.at_least - driven)
    elif check.at_most is not None and driven > check.at_most:
        gap = length_words("past", driven - check.at_most)
    else:
        return None
    return Miss(Phrase("miss-driven", driven=round(driven), gap=gap))


def _turns(check: Turns, run: RunInWorld) -> Miss | None:
    turned = turned_along(run.path)
    # A turn to the left is negative: what counts is how much of the wanted turn was made.
    over = (turned - check.by) * (1 if check.by >= 0 else -1)
    code = "miss-gap-over" if over > 0 else "miss-gap-under"
    gap = Phrase(code, degrees=round(abs(over)))
    return Miss(Phrase("miss-turned", turned=round(turned), gap=gap))


def _on_line(check: StaysOnLine, run: RunInWorld) -> Miss | None:
    line = run.world.line_named(check.line) if run.world else None
    if line is None:
        return None
    is_on = is_on_line(run.path, line.polyline(), check.distance)
    if True not in is_on:
        return None
    first = is_on.index(True)
    lost = next((index for index in range(first, len(is_on)) if not is_on[index]), None)
    if lost is None:
        return None
    last, at = run.path[lost - 1], run.path[lost]
    words = Phrase("miss-left-line", at=rounded_seconds(at.moment.time))
    return Miss(words, xy(last), xy(at))


_CHECKS: Mapping[type, Callable[[Any, RunInWorld], Miss | None]] = {
    Never: _never,
    EndsAt: _ends_at,
    Drives: _drives,
    Turns: _turns,
    StaysOnLine: _on_line,
}
