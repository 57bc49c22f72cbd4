"""A lesson's checks in words."""

import re
from collections.abc import Callable, Mapping
from typing import Any, Literal

from learnblock.i18n import Phrase, Value, translate
from learnblock.i18n.names import goal_phrase
from learnblock.lessons.checks import (
    At,
    Called,
    Check,
    Collided,
    Drives,
    Ends,
    EndsAt,
    Event,
    Expert,
    GoalReached,
    Happens,
    InOrder,
    Never,
    Printed,
    Prints,
    Reaches,
    Said,
    Sent,
    Shown,
    Size,
    StaysOnLine,
    Stood,
    Turns,
    Uses,
)
from learnblock.lessons.texts import in_language

#: How an event is put into words: see `event_words`.
Form = Literal["clause", "sentence", "never", "missing", "past"]


def title_of(check: Check, language: str) -> str:
    """What the pupil reads: the lesson's words for a check, or the check's own."""
    if check.say is not None:
        return in_language(check.say, language)
    return translate(describe(check), language)


def describe(check: Check) -> Phrase:
    """What a check asks for, in words of its own."""
    words = _CHECKS[type(check)](check)
    if check.robot is None:
        return words
    return Phrase("lesson-check-robot", robot=check.robot, check=words)


def event_words(event: Event, form: Form = "clause") -> Phrase:
    """An event in words: ``the robot shows 'joy'``.

    Args:
        event: the event.
        form: a part of a sentence; or a ``sentence``, without its full stop; or one that says that
            the event ``never`` happens, that it did not (``missing``), or that it did (``past``).
    """
    return _EVENTS[type(event)](event, form)


def pattern_words(pattern: str) -> str:
    """A pattern of a text as people write it: with an ellipsis where any words may be."""
    return re.sub(r"\*+", "…", pattern)


def times_words(count: int) -> Phrase:
    """How often: ``once``, ``twice``, ``5 times``."""
    return Phrase("lesson-times", count=count)


def uses_words(check: Uses) -> Phrase:
    """What a program has to use."""
    if check.skill is not None:
        return Phrase("lesson-uses-skill", skill=check.skill)
    if check.function is not None:
        return Phrase("lesson-uses-function", function=check.function)
    return Phrase("lesson-construct", construct=check.construct or "")


def _within(within: float | None) -> Value:
    return "" if within is None else Phrase("lesson-within", seconds=within)


def _reaches(check: Reaches) -> Phrase:
    within = _within(check.within)
    if not check.goals:
        return Phrase("lesson-check-all-goals", within=within)
    goals = tuple(map(goal_phrase, check.goals))
    goal_words = goals[0] if len(goals) == 1 else goals
    return Phrase("lesson-check-goals", count=len(goals), goals=goal_words, within=within)


def _happens(check: Happens) -> Phrase:
    shared = {"event": event_words(check.what, "sentence"), "within": _within(check.within)}
    if check.at_most is None and check.at_least == 1:
        return Phrase("lesson-check-happens", **shared)
    least = times_words(check.at_least)
    if check.at_most is None:
        return Phrase("lesson-check-at-least", least=least, **shared)
    if check.at_most == check.at_least:
        return Phrase("lesson-check-exactly", times=least, **shared)
    most = times_words(check.at_most)
    if check.at_least == 0:
        return Phrase("lesson-check-at-most", most=most, **shared)
    return Phrase("lesson-check-between", least=least, most=most, **shared)


def _in_order(check: InOrder) -> Phrase:
    events = tuple(map(event_words, check.events))
    if check.within is None:
        return Phrase("lesson-check-order", events=events)
    return Phrase("lesson-check-order-within", events=events, seconds=check.within)


def _on_line(check: StaysOnLine) -> Phrase:
    share = round(check.share * 100)
    return Phrase("lesson-check-line", share=share, line=check.line)


def _drives(check: Drives) -> Phrase:
    if check.at_most is None:
        return Phrase("lesson-check-drives", least=check.at_least)
    if check.at_least == 0:
        return Phrase("lesson-check-drives-most", most=check.at_most)
    return Phrase("lesson-check-drives-between", least=check.at_least, most=check.at_most)


def _ends_at(check: EndsAt) -> Phrase:
    place = {"x": check.x, "y": check.y, "radius": check.radius}
    if check.heading is None:
        return Phrase("lesson-check-ends-at", **place)
    return Phrase("lesson-check-ends-facing", **place, heading=check.heading)


def _uses(check: Uses) -> Phrase:
    what = uses_words(check)
    if check.at_most == 0:
        return Phrase("lesson-check-uses-no", what=what)
    if check.at_most is not None:
        return Phrase("lesson-check-uses-most", what=what, most=times_words(check.at_most))
    if check.at_least == 1:
        return Phrase("lesson-check-uses", what=what)
    return Phrase("lesson-check-uses-least", what=what, least=times_words(check.at_least))


def _shown(event: Shown, form: Form) -> Phrase:
    if _is_anything(event.what):
        return Phrase("lesson-event-shows-any", form=form)
    return Phrase("lesson-event-shows", form=form, what=pattern_words(event.what))


def _said(event: Said, form: Form) -> Phrase:
    if _is_anything(event.what):
        return Phrase("lesson-event-says-any", form=form)
    return Phrase("lesson-event-says", form=form, what=pattern_words(event.what))


def _printed(event: Printed, form: Form) -> Phrase:
    if _is_anything(event.what):
        return Phrase("lesson-event-prints-any", form=form)
    return Phrase("lesson-event-prints", form=form, what=pattern_words(event.what))


def _collided(event: Collided, form: Form) -> Phrase:
    if _is_anything(event.thing):
        return Phrase("lesson-event-collision", form=form)
    return Phrase("lesson-event-collision-with", form=form, thing=event.thing)


def _at(event: At, form: Form) -> Phrase:
    return Phrase("lesson-event-at", form=form, x=event.x, y=event.y, radius=event.radius)


def _is_anything(pattern: str) -> bool:
    return pattern.strip("* ") == ""


_EVENTS: Mapping[type, Callable[[Any, Form], Phrase]] = {
    GoalReached: lambda event, form: Phrase(
        "lesson-event-goal", form=form, name=goal_phrase(event.name)
    ),
    Shown: _shown,
    Said: _said,
    Printed: _printed,
    Called: lambda event, form: Phrase("lesson-event-calls", form=form, skill=event.skill),
    Sent: lambda event, form: Phrase("lesson-event-sends", form=form, message=event.message),
    Collided: _collided,
    At: _at,
    Stood: lambda event, form: Phrase("lesson-event-stands", form=form, seconds=event.seconds),
}
_CHECKS: Mapping[type, Callable[[Any], Phrase]] = {
    Reaches: _reaches,
    Happens: _happens,
    Never: lambda check: Phrase("lesson-check-never", event=event_words(check.what, "never")),
    InOrder: _in_order,
    StaysOnLine: _on_line,
    Drives: _drives,
    EndsAt: _ends_at,
    Turns: lambda check: Phrase("lesson-check-turns", by=check.by),
    Ends: lambda check: Phrase("lesson-check-ends", within=_within(check.within)),
    Prints: lambda check: Phrase(
        "lesson-check-prints", lines=tuple(map(pattern_words, check.lines))
    ),
    Uses: _uses,
    Size: lambda check: Phrase("lesson-check-size", blocks=check.blocks),
    Expert: lambda check: Phrase("lesson-check-python", function=check.function),
}
