"""Rules about what came of a run: its end, its times, its texts, and other attempts."""

from collections.abc import Callable, Iterator, Sequence
from difflib import SequenceMatcher
from typing import Any

from learnblock.i18n import Phrase
from learnblock.language.tree.flow import is_counted, is_endless
from learnblock.language.tree.nodes import (
    Call,
    SkillCall,
    String,
)
from learnblock.language.tree.traversal import all_expressions
from learnblock.lessons.checks import (
    At,
    Called,
    Collided,
    Drives,
    Ends,
    Event,
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
    Uses,
)
from learnblock.lessons.happening import fits, moments
from learnblock.lessons.hints.conditions import number_of
from learnblock.lessons.hints.guess import Guess
from learnblock.lessons.hints.situation import Situation, calls_in
from learnblock.lessons.hints.vocabulary import LASTING, asks_line, sensors, side
from learnblock.lessons.judging import Verdict
from learnblock.runtime.ending import How
from learnblock.simulator.goal_description import Show

#: Texts that are so much alike are the same one, misspelt.
_ALIKE = 0.65
#: So many texts are compared with the one asked for, and so many characters of each.
_MOST_COMPARED, _LONGEST = 200, 200
#: Faster than this, mm/s, robots lose lines.
_FAST = 100.0

_KINDS: dict[type, tuple[str, str]] = {
    Printed: ("print", "what"),
    Said: ("say", "what"),
    Shown: ("show", "what"),
}


def error(situation: Situation, _: Verdict) -> Iterator[Guess]:
    """An error ended the program."""
    report = situation.evidence.report if situation.evidence else None
    if report is None or not report.error:
        return
    line = report.error.get("line")
    lines = (line,) if isinstance(line, int) and line else ()
    message: Any = report.error.get("message")
    yield Guess("error", lines, frozenset({"error"}), {"message": message or ""}, "error")


# Ends and times.


def never_ends(situation: Situation, verdict: Verdict) -> Iterator[Guess]:
    """The program goes on until its time is over, and should have ended."""
    if not isinstance(verdict.check, Ends) or situation.ended != How.TIME_LIMIT:
        return
    endless = [loop for loop in situation.loops if not is_counted(loop) and situation.ran(loop)]
    lines = (endless[-1].span.line,) if endless else ()
    yield Guess("never-ends", lines, frozenset({"forever", "loop"}), {}, "too_late")


def too_early(situation: Situation, verdict: Verdict) -> Iterator[Guess]:
    """The program ends by itself before what is asked for can happen."""
    is_missing = isinstance(
        verdict.check, Reaches | Happens | InOrder | StaysOnLine | Drives | Prints
    )
    if is_missing and situation.ended == How.FINISHED and not _is_too_much(verdict):
        yield Guess("too-early", sign="too_early")


def _is_too_much(verdict: Verdict) -> bool:
    return verdict.reason is not None and verdict.reason.code in {
        "lesson-too-often",
        "lesson-drove-far",
        "lesson-goal-late",
        "lesson-too-late",
    }


def too_late(situation: Situation, verdict: Verdict) -> Iterator[Guess]:
    """It happens, but later than asked for."""
    code = verdict.reason.code if verdict.reason else ""
    if code in _LATE:
        yield Guess("too-late", (), frozenset(), {}, "too_late", 30)
    elif _is_under_way(situation) and not isinstance(verdict.check, Never | Ends):
        yield Guess("too-late", (), frozenset(), {}, "too_late", -10)


def _is_under_way(situation: Situation) -> bool:
    """Whether time was over while nothing had gone wrong so far."""
    hit = situation.evidence.collisions if situation.evidence else ()
    return situation.ended == How.TIME_LIMIT and not hit


_LATE = frozenset(("lesson-goal-late", "lesson-too-late", "lesson-order-late", "lesson-ended-late"))


def how_often(situation: Situation, verdict: Verdict) -> Iterator[Guess]:
    """It happens, but not as often as asked for."""
    check = verdict.check
    if not isinstance(check, Happens) or situation.evidence is None:
        return
    times = len(moments(check.what, situation.evidence))
    lines = _counted(situation)
    about = frozenset({"repeat", "loop", getattr(check.what, "skill", "")}) - {""}
    if 0 < times < check.at_least:
        yield Guess("too-few-times", lines, about, {}, "value_too_small", 10)
    elif check.at_most is not None and times > check.at_most:
        yield Guess("too-many-times", lines, about, {}, "value_too_large", 10)


def _counted(situation: Situation) -> tuple[int, ...]:
    """The line of a loop that counts its rounds."""
    for loop in situation.loops:
        if not is_endless(loop):
            return (loop.span.line,)
    return ()


# Texts and faces.


def texts(situation: Situation, verdict: Verdict) -> Iterator[Guess]:
    """Something else was printed, said or shown than asked for, or nothing."""
    for kind, pattern in _wanted(situation, verdict):
        outputs = [output for output in situation.texts if output.kind == kind]
        if any(fits(output.text, pattern) for output in outputs):
            continue
        about = frozenset({kind, pattern})
        some = outputs[:_MOST_COMPARED]
        nearest = max(some, key=lambda output: _likeness(output.text, pattern), default=None)
        if nearest and _likeness(nearest.text, pattern) >= _ALIKE and not _is_face(pattern):
            yield Guess("text-almost", (nearest.line,) if nearest.line else (), about)
        elif outputs:
            lines = tuple(dict.fromkeys(output.line for output in outputs if output.line))[:3]
            yield Guess("wrong-text", lines, about, {"kind": kind})
        elif lines := _unreached(situation, kind):
            yield Guess("never-runs", lines, about, {}, "never_runs", 12)
        else:
            yield Guess("not-shown", (), about, {"kind": kind})
        return


def _wanted(situation: Situation, verdict: Verdict) -> Iterator[tuple[str, str]]:
    match verdict.check:
        case Prints(lines=lines):
            yield from (("print", line) for line in lines)
        case Happens(what=event):
            yield from _text_of(event)
        case InOrder(events=events):
            for event in events:
                yield from _text_of(event)
        case Reaches(goals=names) if situation.world is not None:
            for _, _, goal in situation.world.goal.all():
                if isinstance(goal, Show) and (not names or goal.name in names):
                    yield "show", goal.emotion


def _text_of(event: Event) -> Iterator[tuple[str, str]]:
    if type(event) in _KINDS:
        kind, name = _KINDS[type(event)]
        yield kind, getattr(event, name)


def _likeness(text: str, pattern: str) -> float:
    plain = pattern.replace("*", "")
    if not plain:
        return 0.0
    output, pattern_text = text[:_LONGEST].casefold().strip(), plain.casefold().strip()
    if "*" in pattern and len(output) > len(pattern_text):
        parts = [
            output[start : start + len(pattern_text)]
            for start in range(len(output) - len(pattern_text) + 1)
        ]
        return max(SequenceMatcher(None, part, pattern_text).ratio() for part in parts)
    return SequenceMatcher(None, output, pattern_text).ratio()


_FACES = frozenset(("joy", "sadness", "anger", "fear", "disgust", "surprise", "neutral"))


def _is_face(pattern: str) -> bool:
    return pattern.casefold() in _FACES


_SKILLS = {"say": ("say_Text",), "show": ("show_text", "show_number", "express")}


def _unreached(situation: Situation, kind: str) -> tuple[int, ...]:
    """The statements that would print, say or show something, and did not run."""
    lines = []
    for node in situation.statements:
        calls = [*calls_in(node, SkillCall), *calls_in(node, Call)]
        names = _SKILLS.get(kind, ("print",))
        if any(call.name.startswith(names) for call in calls) and not situation.ran(node):
            lines.append(node.span.line)
    return tuple(lines[:3])


def wrong_order(situation: Situation, verdict: Verdict) -> Iterator[Guess]:
    """Everything happens, in another order."""
    if situation.evidence is None:
        return
    match verdict.check:
        case InOrder(events=events) if all(isinstance(event, At | GoalReached) for event in events):
            # The robot drove another way; the order of its statements may be right.
            return
        case InOrder(events=events):
            code = verdict.reason.code if verdict.reason else ""
            if code != "lesson-order-late" and _all_happen(events, situation):
                lines = _lines_of(situation, [p for event in events for p in _text_of(event)])
                yield Guess("wrong-order", lines, frozenset({"order"}))
        case Prints(lines=patterns):
            printed = [output.text for output in situation.texts if output.kind == "print"]
            if all(any(fits(text, pattern) for text in printed) for pattern in patterns):
                lines = _lines_of(situation, [("print", pattern) for pattern in patterns])
                yield Guess("wrong-order", lines, frozenset({"order"}))


def _all_happen(events: Sequence[Event], situation: Situation) -> bool:
    evidence = situation.evidence
    return evidence is not None and all(moments(event, evidence) for event in events)


def _lines_of(situation: Situation, pairs: Sequence[tuple[str, str]]) -> tuple[int, ...]:
    lines = [
        output.line
        for kind, pattern in pairs
        for output in situation.texts
        if output.kind == kind and fits(output.text, pattern) and output.line
    ]
    return tuple(sorted(set(lines)))[:4]


def event_missing(situation: Situation, verdict: Verdict) -> Iterator[Guess]:
    """A skill is never called, or a message never sent, that has to be."""
    required_events: Sequence[Event] = ()
    match verdict.check:
        case Happens(what=event):
            required_events = (event,)
        case InOrder(events=events):
            required_events = events
    for event in required_events:
        name = getattr(event, "skill", "") or getattr(event, "message", "")
        if not isinstance(event, Called | Sent) or situation.evidence is None:
            continue
        if moments(event, situation.evidence):
            continue
        about = frozenset({name})
        lines = _lines_with(situation, name)
        if lines:
            yield Guess("never-runs", lines, about, {}, "never_runs", 12)
        elif isinstance(event, Sent) and "send" in situation.skills:
            lines = _lines_with(situation, "send")
            yield Guess("text-almost", lines, about)
        elif name in sensors():
            what = Phrase("hint-a-sensor")
            yield Guess("never-asks", (), about, {"what": what}, "never_asks", 15)
        else:
            yield Guess("event-missing", (), about, {}, "never_runs")
        return


def _lines_with(situation: Situation, name: str) -> tuple[int, ...]:
    """The lines that call a skill, or have a text."""
    return tuple(
        node.span.line
        for node in situation.statements
        for inner in all_expressions(node)
        if (isinstance(inner, SkillCall) and inner.name == name)
        or (isinstance(inner, String) and inner.value == name)
    )[:3]


def forbidden(situation: Situation, verdict: Verdict) -> Iterator[Guess]:
    """Something happened that must not."""
    check = verdict.check
    if not isinstance(check, Never) or isinstance(check.what, Collided | At):
        return
    lines = _lines_of(situation, list(_text_of(check.what)))
    name = getattr(check.what, "skill", "") or getattr(check.what, "message", "")
    lines = lines or (_lines_with(situation, name) if name else ())
    yield Guess("forbidden", lines, frozenset({name} - {""}))


def never_stands(situation: Situation, verdict: Verdict) -> Iterator[Guess]:
    """The robot has to stand still for a while and never does."""
    required_events: Sequence[Event] = ()
    match verdict.check:
        case Happens(what=event):
            required_events = (event,)
        case InOrder(events=events):
            required_events = events
    for event in required_events:
        evidence = situation.evidence
        if isinstance(event, Stood) and evidence is not None and not moments(event, evidence):
            yield Guess("never-stands", (), frozenset({"sleep"}))


def lost_line(situation: Situation, verdict: Verdict) -> Iterator[Guess]:
    """The robot asks for a line and loses it."""
    if not isinstance(verdict.check, StaysOnLine):
        return
    skills = {name for name in situation.skills if asks_line(name)}
    if not skills:
        return
    for node in situation.statements:
        for call in calls_in(node, SkillCall):
            speed = number_of(call.arguments[0]) if call.arguments else None
            if call.name in LASTING - {"turn_left", "turn_right"} and (speed or 0) > _FAST:
                about = frozenset({call.name})
                yield Guess("value-too-large", (node.span.line,), about, {}, "value_too_large", 5)
    sides = {side(name) for name in skills} - {""}
    if len(sides) == 1:
        what = Phrase("hint-the-other-side")
        yield Guess("never-asks", (), frozenset(skills), {"what": what}, "never_asks", 5)
    yield Guess("lost-line", (), frozenset(skills))


# Other attempts.


def only_here(situation: Situation, verdict: Verdict) -> Iterator[Guess]:
    """The program works in the world as it is drawn, and not in a variant, or on another robot."""
    if isinstance(verdict.check, Uses | Size) or not situation.elsewhere.passes_usually:
        return
    if situation.elsewhere.is_other_robot:
        yield Guess("other-robot", _numbers(situation), frozenset({"robot"}))
    elif situation.elsewhere.is_variant:
        surely = 0 if situation.skills & sensors() else 5
        yield Guess("only-here", _numbers(situation), frozenset({"variant"}), {}, None, surely)


def _numbers(situation: Situation) -> tuple[int, ...]:
    """The lines that wait for a time or drive a distance: numbers in place of sensors."""
    skills = {"sleep", "drive_distance", "turn"}
    main = situation.statements
    lines = [
        node.span.line
        for node in main
        for call in calls_in(node, SkillCall)
        if call.name in skills and call.arguments and number_of(call.arguments[0])
    ]
    return tuple(dict.fromkeys(lines))[:3]


def look_again(situation: Situation, verdict: Verdict) -> Iterator[Guess]:
    """Nothing else is known: what the check says."""
    del situation
    reason = verdict.reason or Phrase("hint-no-reason")
    yield Guess("look-again", (), frozenset(), {"reason": reason})


RULES: tuple[Callable[[Situation, Verdict], Iterator[Guess]], ...] = (
    error,
    never_ends,
    too_early,
    too_late,
    how_often,
    texts,
    wrong_order,
    event_missing,
    forbidden,
    never_stands,
    lost_line,
    only_here,
    look_again,
)
