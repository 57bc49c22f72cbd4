"""Two runs compared: where they parted, and why."""

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import islice, zip_longest
from typing import Any

from learnblock.i18n import Phrase, Value
from learnblock.runtime.log.events import Op
from learnblock.runtime.log.noting import TICK
from learnblock.why.edits import Edit, edits, line_pairs
from learnblock.why.history import History
from learnblock.why.readings import Readings
from learnblock.why.sentences import Sentence, Telling
from learnblock.why.slicing import Slices

#: Noise changes readings in every run; what counts is the first decision that it changes.
_DECISIONS = frozenset({Op.CONDITION, Op.TURN})
#: The most that two runs are followed: minutes of a loop that decides all the time.
MOST_STEPS = 3_000_000
#: The most edits that are named.
MOST_EDITS = 3
#: What may differ about two runs, by its name in the first line of the trace.
_CAUSES = {"robot": "why-cause-robot", "world": "why-cause-world", "seed": "why-cause-seed"}
#: What a person did to the robot during a run, by the name of its line in the log.
_BY_HAND = ("placed", "handled", "keys")


@dataclass(frozen=True, slots=True)
class Parting:
    """Where two runs parted.

    Args:
        first: what the first run did then, as one sentence.
        second: what the second run did.
        together: until when they did the same, in s of the first run.
        because: both in one sentence, if they decided about the same condition; else None.
    """

    first: Sentence
    second: Sentence
    together: float
    because: Phrase | None = None


@dataclass(frozen=True, slots=True)
class Comparison:
    """Two runs.

    Args:
        parting: where they parted; None if they did the same.
        causes: what was different about them from the start.
        edits: the lines of their programs that differ.
    """

    parting: Parting | None
    causes: tuple[Phrase, ...]
    edits: tuple[Edit, ...] = ()


def compared(one: History, other: History) -> Comparison:
    """Compare two runs."""
    changed = edits(one.program, other.program)
    conditions = tuple(_conditions(one, other))
    is_exact = bool(changed) and not conditions
    causes = (*map(_edit_phrase, changed[:MOST_EDITS]), *_more(changed), *conditions)
    found = _parting(one, other, acts=is_exact)
    return Comparison(found, causes or tuple(_without_cause(one, other, found)), changed)


# Why: docs/decisions.md, "Two runs part at the first decision that differs"
def parting(one: History, other: History) -> Parting | None:
    """Find the first decision in which two runs differ; None if there is none."""
    return compared(one, other).parting


@dataclass(frozen=True, slots=True)
class _Step:
    """A decision or a command.

    Args:
        event: the event; in turns of a loop that were only counted, that of the turn before.
        ticks: when it was.
        counted: whether it is of such a turn, so that its time is not known exactly.
    """

    event: int
    ticks: int
    counted: bool = False


def _parting(one: History, other: History, *, acts: bool) -> Parting | None:
    """The first step that differs.

    Args:
        one: the first run.
        other: the second run.
        acts: whether commands to the robot and their times count too: they do if nothing but the
            program differs, because then they differ for no other reason than an edit.
    """
    kinds = _DECISIONS | {Op.COMMAND} if acts else _DECISIONS
    places = _places(one, other)
    steps = zip_longest(_steps(one, kinds), _steps(other, kinds))
    for mine, theirs in islice(steps, MOST_STEPS):
        if (
            mine
            and theirs
            and _done(one, mine, places) == _done(other, theirs, None)
            and not (acts and _apart(mine, theirs))
        ):
            continue
        together = mine.ticks * TICK if mine else one.end
        because = _because(one, mine, other, theirs)
        return Parting(_told(one, mine), _told(other, theirs), round(together, 3), because)
    return None


def _apart(mine: _Step, theirs: _Step) -> bool:
    """Whether two steps were at different times, as far as that is known exactly."""
    return mine.ticks != theirs.ticks and not (mine.counted or theirs.counted)


def _steps(history: History, kinds: frozenset[Op]) -> Iterator[_Step]:
    """The decisions of a run, those of turns that were only counted once for each of them."""
    for event, what in enumerate(history.events):
        if what[0] in kinds:
            yield _Step(event, history.ticks[event])
        elif what[0] == Op.REPEATED:
            turn = [one for one in history.turn_before(event) if history.events[one][0] in kinds]
            began = history.ticks[event] - what[3]
            for number in range(what[2] if turn else 0):
                now = began + round(what[3] * (number + 1) / what[2])
                yield from (_Step(one, now, counted=True) for one in turn)


def _places(one: History, other: History) -> dict[int, int]:
    """For each node of the first program, the node of the second one that it became."""
    lines = line_pairs(one.program, other.program)
    there = {place: number for number, place in enumerate(_marks(other))}
    became = ((kind, lines.get(line, 0), nth) for kind, line, nth in _marks(one))
    return {number: there[mark] for number, mark in enumerate(became) if mark in there}


def _marks(history: History) -> Iterator[tuple[str, int, int]]:
    """What distinguishes each node of a program: kind, line and number among those there."""
    counts: Counter[tuple[str, int]] = Counter()
    for node in history.nodes:
        counts[node.kind, node.line] += 1
        yield node.kind, node.line, counts[node.kind, node.line]


def _done(history: History, step: _Step, places: dict[int, int] | None) -> tuple[Any, ...]:
    op, *values = history.events[step.event]
    if op == Op.COMMAND:
        return op, *values
    node = values[0] if places is None else places.get(values[0], -1)
    return op, node, values[1]


def _told(history: History, step: _Step | None) -> Sentence:
    telling = Telling(history)
    if step is None:
        telling.say("why-parted-ended", time=round(history.end, 2))
        return telling.answer().sentences[0]
    event, time = step.event, round(step.ticks * TICK, 2)
    what = history.events[event]
    if what[0] == Op.TURN:
        telling.say("why-parted-turn", what[1], event, time=time)
    elif what[0] == Op.COMMAND:
        telling.say("why-parted-acted", _caller(history, event), event, time=time)
    else:
        answer, facts = "true" if what[2] else "false", _readings(history).summary(event)
        telling.say("why-parted", what[1], event, answer=answer, facts=facts, time=time)
    return replace(telling.answer().sentences[0], time=step.ticks * TICK)


def _caller(history: History, command: int) -> int:
    """The place in the program that let a command be given; -1 if the log does not know it."""
    use = history.skills.get(command)
    while use and use.within:
        use = use.within
    return use.node if use else -1


def _because(
    one: History, mine: _Step | None, other: History, theirs: _Step | None
) -> Phrase | None:
    """Two answers to one question, each with what was measured."""
    if not mine or not theirs:
        return None
    ahead, there = one.events[mine.event], other.events[theirs.event]
    if not ahead[0] == there[0] == Op.CONDITION or ahead[2] == there[2]:
        return None
    facts = [_facts(one, mine.event), _facts(other, theirs.event)]
    sentence = _told(one, mine)
    if not all(facts) or one.line(ahead[1]) != sentence.line:
        return None
    values = dict(sentence.phrase.values)
    return Phrase(
        "why-parted-because",
        time=values["time"],
        line=values["line"],
        code=values["code"],
        answer=values["answer"],
        one=facts[0],
        other=facts[1],
    )


def _facts(history: History, event: int) -> Value:
    """What was measured, in words; "" if nothing was."""
    summary = _readings(history).summary(event)
    return summary.values["facts"] if isinstance(summary, Phrase) else ""


def _readings(history: History) -> Readings:
    return Readings(Slices(history))


# What was different from the start.


def _conditions(one: History, other: History) -> Iterator[Phrase]:
    mine, theirs = one.recorded.conditions, other.recorded.conditions
    for name, code in _CAUSES.items():
        if mine.get(name) != theirs.get(name):
            yield Phrase(code, one=_name(mine.get(name)), other=_name(theirs.get(name)))
    if mine.get("world") == theirs.get("world") and _world(one) != _world(other):
        yield Phrase("why-cause-variant", world=_name(mine.get("world")))
    if mine.get("start") != theirs.get("start"):
        yield Phrase("why-cause-start")
    if _by_hand(one) != _by_hand(other):
        yield Phrase("why-cause-hand")


def _without_cause(one: History, other: History, found: Parting | None) -> Iterator[Phrase]:
    if _is_real(one) or _is_real(other):
        yield Phrase("why-cause-real")
    elif found and one.recorded.ending.get("ended") != other.recorded.ending.get("ended"):
        yield Phrase("why-cause-length")


def _world(history: History) -> object:
    world = history.recorded.robot.get("world") or {}
    return {name: value for name, value in world.items() if name != "folder"}


def _is_real(history: History) -> bool:
    return history.recorded.robot.get("world") is None


def _by_hand(history: History) -> list[object]:
    lines = history.recorded.lines
    return [(line["t"], name, line[name]) for line in lines for name in _BY_HAND if name in line]


def _name(value: object) -> str:
    return "–" if value is None else str(value)


def _edit_phrase(edit: Edit) -> Phrase:
    line = edit.line or edit.line_before
    if not edit.before:
        return Phrase("why-cause-added", line=str(line), after=edit.after)
    if not edit.after:
        return Phrase("why-cause-removed", line=str(edit.line_before), before=edit.before)
    return Phrase("why-cause-edit", line=str(line), before=edit.before, after=edit.after)


def _more(changed: tuple[Edit, ...]) -> Iterator[Phrase]:
    if len(changed) > MOST_EDITS:
        yield Phrase("why-cause-more", count=len(changed) - MOST_EDITS)
