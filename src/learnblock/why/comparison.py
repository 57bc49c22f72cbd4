"""Compares two runs: where they parted, and why."""

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import islice, zip_longest
from typing import Any

from learnblock.i18n import Phrase, Value
from learnblock.runtime.log.events import Op
from learnblock.runtime.log.noting import TICK
from learnblock.why.edits import ChangedLine, edits, line_pairs
from learnblock.why.history import EventHistory
from learnblock.why.readings import Readings
from learnblock.why.sentences import Draft, Sentence
from learnblock.why.slices import Slices

#: Noise changes readings in every run; what counts is the first decision that it changes.
_DECISIONS = frozenset({Op.CONDITION, Op.TURN})
#: The most steps for which two runs are followed: minutes of a loop that decides all the time.
MOST_STEPS = 3_000_000
#: The most edits that are named.
MOST_EDITS = 3
#: The causes of a difference between two runs, by their names in the first line of the trace.
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
    edits: tuple[ChangedLine, ...] = ()


def compared(first: EventHistory, second: EventHistory) -> Comparison:
    """Compare two runs."""
    changes = edits(first.program, second.program)
    conditions = tuple(_conditions(first, second))
    is_exact = bool(changes) and not conditions
    causes = (*map(_edit_phrase, changes[:MOST_EDITS]), *_more(changes), *conditions)
    parted = _parting(first, second, acts=is_exact)
    return Comparison(parted, causes or tuple(_without_cause(first, second, parted)), changes)


# Why: docs/decisions.md, "Two runs part at the first decision that differs"
def parting(first: EventHistory, second: EventHistory) -> Parting | None:
    """Find the first decision in which two runs differ; None if there is none."""
    return compared(first, second).parting


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


def _parting(first: EventHistory, second: EventHistory, *, acts: bool) -> Parting | None:
    """The first step that differs.

    Args:
        first: the first run.
        second: the second run.
        acts: whether commands to the robot and their times count too: they do if nothing but the
            program differs, because then they differ for no other reason than an edit.
    """
    kinds = _DECISIONS | {Op.COMMAND} if acts else _DECISIONS
    places = _places(first, second)
    steps = zip_longest(_steps(first, kinds), _steps(second, kinds))
    for mine, theirs in islice(steps, MOST_STEPS):
        if (
            mine
            and theirs
            and _done(first, mine, places) == _done(second, theirs, None)
            and not (acts and _apart(mine, theirs))
        ):
            continue
        together = mine.ticks * TICK if mine else first.end
        because = _because(first, mine, second, theirs)
        return Parting(
            _sentence(first, mine), _sentence(second, theirs), round(together, 3), because
        )
    return None


def _apart(mine: _Step, theirs: _Step) -> bool:
    """Whether two steps were at different times, as far as these are known exactly."""
    return mine.ticks != theirs.ticks and not (mine.counted or theirs.counted)


def _steps(history: EventHistory, kinds: frozenset[Op]) -> Iterator[_Step]:
    """The decisions of a run, those of turns that were only counted once for each of them."""
    for event, what in enumerate(history.events):
        if what[0] in kinds:
            yield _Step(event, history.ticks[event])
        elif what[0] == Op.REPEATED:
            turn = [index for index in history.turn_before(event) if history.op(index) in kinds]
            began = history.ticks[event] - what[3]
            for number in range(what[2] if turn else 0):
                now = began + round(what[3] * (number + 1) / what[2])
                yield from (_Step(decision, now, counted=True) for decision in turn)


def _places(first: EventHistory, second: EventHistory) -> dict[int, int]:
    """For each node of the first program, the node of the second one that it became."""
    lines = line_pairs(first.program, second.program)
    there = {place: number for number, place in enumerate(_marks(second))}
    became = ((kind, lines.get(line, 0), nth) for kind, line, nth in _marks(first))
    return {number: there[mark] for number, mark in enumerate(became) if mark in there}


def _marks(history: EventHistory) -> Iterator[tuple[str, int, int]]:
    """What distinguishes each node of a program: kind, line and number among those there."""
    counts: Counter[tuple[str, int]] = Counter()
    for node in history.nodes:
        counts[node.kind, node.line] += 1
        yield node.kind, node.line, counts[node.kind, node.line]


def _done(history: EventHistory, step: _Step, places: dict[int, int] | None) -> tuple[Any, ...]:
    op, *values = history.events[step.event]
    if op == Op.COMMAND:
        return op, *values
    node = values[0] if places is None else places.get(values[0], -1)
    return op, node, values[1]


def _sentence(history: EventHistory, step: _Step | None) -> Sentence:
    draft = Draft(history)
    if step is None:
        draft.say("why-parted-ended", time=round(history.end, 2))
        return draft.answer().sentences[0]
    event, time = step.event, round(step.ticks * TICK, 2)
    what = history.events[event]
    if what[0] == Op.TURN:
        draft.say("why-parted-turn", what[1], event, time=time)
    elif what[0] == Op.COMMAND:
        draft.say("why-parted-acted", _caller(history, event), event, time=time)
    else:
        answer, facts = "true" if what[2] else "false", _readings(history).summary(event)
        draft.say("why-parted", what[1], event, answer=answer, facts=facts, time=time)
    return replace(draft.answer().sentences[0], time=step.ticks * TICK)


def _caller(history: EventHistory, command: int) -> int:
    """The place in the program that let a command be given; -1 if the log does not know it."""
    use = history.own_use(command)
    return use.node if use else -1


def _because(
    first: EventHistory, mine: _Step | None, second: EventHistory, theirs: _Step | None
) -> Phrase | None:
    """Two answers to one question, each with what was measured."""
    if not mine or not theirs:
        return None
    ahead, there = first.events[mine.event], second.events[theirs.event]
    if not ahead[0] == there[0] == Op.CONDITION or ahead[2] == there[2]:
        return None
    facts = [_facts(first, mine.event), _facts(second, theirs.event)]
    sentence = _sentence(first, mine)
    if not all(facts) or first.line(ahead[1]) != sentence.line:
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


def _facts(history: EventHistory, event: int) -> Value:
    """What was measured, in words; "" if nothing was."""
    summary = _readings(history).summary(event)
    return summary.values["facts"] if isinstance(summary, Phrase) else ""


def _readings(history: EventHistory) -> Readings:
    return Readings(Slices(history))


# What was different from the start.


def _conditions(first: EventHistory, second: EventHistory) -> Iterator[Phrase]:
    mine, theirs = first.recorded.conditions, second.recorded.conditions
    for name, code in _CAUSES.items():
        if mine.get(name) != theirs.get(name):
            yield Phrase(code, one=_name(mine.get(name)), other=_name(theirs.get(name)))
    if mine.get("world") == theirs.get("world") and _world(first) != _world(second):
        yield Phrase("why-cause-variant", world=_name(mine.get("world")))
    if mine.get("start") != theirs.get("start"):
        yield Phrase("why-cause-start")
    if _by_hand(first) != _by_hand(second):
        yield Phrase("why-cause-hand")


def _without_cause(
    first: EventHistory, second: EventHistory, parted: Parting | None
) -> Iterator[Phrase]:
    if _is_real(first) or _is_real(second):
        yield Phrase("why-cause-real")
    elif parted and first.recorded.ending.get("ended") != second.recorded.ending.get("ended"):
        yield Phrase("why-cause-length")


def _world(history: EventHistory) -> object:
    world = history.recorded.robot.get("world") or {}
    return {name: value for name, value in world.items() if name != "folder"}


def _is_real(history: EventHistory) -> bool:
    return history.recorded.robot.get("world") is None


def _by_hand(history: EventHistory) -> list[object]:
    lines = history.recorded.lines
    return [(line["t"], name, line[name]) for line in lines for name in _BY_HAND if name in line]


def _name(value: object) -> str:
    return "–" if value is None else str(value)


def _edit_phrase(edit: ChangedLine) -> Phrase:
    line = edit.line or edit.line_before
    if not edit.before:
        return Phrase("why-cause-added", line=str(line), after=edit.after)
    if not edit.after:
        return Phrase("why-cause-removed", line=str(edit.line_before), before=edit.before)
    return Phrase("why-cause-edit", line=str(line), before=edit.before, after=edit.after)


def _more(changes: tuple[ChangedLine, ...]) -> Iterator[Phrase]:
    if len(changes) > MOST_EDITS:
        yield Phrase("why-cause-more", count=len(changes) - MOST_EDITS)
