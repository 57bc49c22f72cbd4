"""Judges programs by a lesson's checks, as early as possible, and gives the reason."""

import math
from bisect import bisect_left
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal

from learnblock.evidence.evidence import Evidence, Moment, Placed, length_of
from learnblock.evidence.gaps import heading_between, is_on_line, turned_along
from learnblock.evidence.missed_goals import Miss
from learnblock.i18n import Phrase
from learnblock.i18n.names import goal_phrase
from learnblock.language.tree.nodes import Program
from learnblock.lessons import structure
from learnblock.lessons.checks import (
    Check,
    Drives,
    Ends,
    EndsAt,
    Expert,
    Happens,
    InOrder,
    Never,
    Prints,
    Reaches,
    Size,
    StaysOnLine,
    Turns,
    Uses,
)
from learnblock.lessons.describing import event_words, pattern_words, times_words, uses_words
from learnblock.lessons.happening import fits, moments
from learnblock.lessons.lesson import Step
from learnblock.lessons.misses import missed
from learnblock.runtime.ending import How
from learnblock.simulator import WorldDescription

State = Literal["open", "met", "failed"]


@dataclass(frozen=True, slots=True)
class Verdict:
    """What a check says about a program and its run.

    Args:
        check: the check.
        index: its place among the step's checks, from 0.
        state: ``met`` or ``failed`` once it is decided, ``open`` before.
        at: when it was decided, in seconds of the robot's time; None if that is not known.
        reason: why it failed.
        miss: by how much, and where, if that is known.
    """

    check: Check
    index: int
    state: State
    at: float | None = None
    reason: Phrase | None = None
    miss: Miss | None = None

    @property
    def explanation(self) -> Phrase | None:
        """What a person reads of why it failed: by how much, if that is known."""
        return self.miss.words if self.miss else self.reason


@dataclass(frozen=True, slots=True)
class Finding:
    """What a check has found: see `Verdict`."""

    state: State
    at: float | None = None
    reason: Phrase | None = None


#: Says what an expert's check has found in a run that is over.
ExpertJudge = Callable[[Expert, Evidence], Finding]

_OPEN = Finding("open")
#: Seconds by which a rounded time may be late.
_ROUNDING = 1e-6


def judge(
    step: Step,
    program: Program | None,
    evidence: Evidence | None,
    world: WorldDescription | None,
    experts: ExpertJudge | None = None,
) -> tuple[Verdict, ...]:
    """Judge a program and its run by the checks of a step.

    Args:
        step: the step.
        program: the program; None if it can't be read.
        evidence: what is known of the run; None if there was none yet.
        world: the world of the run.
        experts: judges by the lesson's Python; without it, such checks stay open.
    """
    judgement = _Judgement(step, program, evidence, world, experts)
    return tuple(judgement.verdict(check, index) for index, check in enumerate(step.check))


def is_done(verdicts: Sequence[Verdict]) -> bool:
    """Whether a step is done: all checks that are not optional are met."""
    return all(verdict.state == "met" for verdict in verdicts if not verdict.check.optional)


@dataclass(frozen=True)
class _Judgement:
    step: Step
    program: Program | None
    evidence: Evidence | None
    world: WorldDescription | None
    experts: ExpertJudge | None

    def verdict(self, check: Check, index: int) -> Verdict:
        evidence = self.evidence
        if evidence is not None and check.robot is not None:
            evidence = evidence.of(check.robot)
        found = self._finding(check, evidence)
        miss = None
        if found.state == "failed" and evidence is not None:
            miss = missed(check, evidence, self.world)
        return Verdict(check, index, found.state, found.at, found.reason, miss)

    def _finding(self, check: Check, evidence: Evidence | None) -> Finding:
        if isinstance(check, Uses | Size):
            return _OPEN if self.program is None else _STRUCTURE[type(check)](check, self.program)
        if evidence is None:
            return _OPEN
        if isinstance(check, Expert):
            return self._expert(check, evidence)
        return _BEHAVIOUR[type(check)](check, _Run(evidence, self.world, self.step.seconds))

    def _expert(self, check: Expert, evidence: Evidence) -> Finding:
        if self.experts is None or not evidence.has_ended:
            return _OPEN
        return self.experts(check, evidence)


@dataclass(frozen=True)
class _Run:
    """A run, or its part so far.

    Args:
        evidence: what is known of it.
        world: its world.
        seconds: the most seconds that it takes.
    """

    evidence: Evidence
    world: WorldDescription | None
    seconds: float

    @property
    def has_ended(self) -> bool:
        return self.evidence.has_ended

    @property
    def now(self) -> float:
        return self.evidence.now

    def is_over(self, within: float | None) -> bool:
        """Whether nothing counts any more that happens from now on."""
        return self.has_ended or (within is not None and self.now > within)

    def in_time(self, occurrences: Sequence[Moment], within: float | None) -> Sequence[Moment]:
        return (
            occurrences
            if within is None
            else [moment for moment in occurrences if moment.time <= within + _ROUNDING]
        )


def _met(at: float | None) -> Finding:
    return Finding("met", at)


def _failed(at: float | None, code: str, /, **values: Any) -> Finding:
    return Finding("failed", at, Phrase(code, **values))


def _reaches(check: Reaches, run: _Run) -> Finding:
    wanted = check.goals or _goals(run)
    for name in wanted:
        if lost := _lost(name, check, run):
            return lost
    missing = [name for name in wanted if name not in run.evidence.reached]
    if wanted and not missing:
        return _met(max(run.evidence.reached[name].time for name in wanted))
    if not run.has_ended:
        return _OPEN
    if not wanted:
        return _failed(run.now, "lesson-no-goals")
    return _failed(run.now, "lesson-goal-open", goal=goal_phrase(missing[0]))


def _lost(name: str, check: Reaches, run: _Run) -> Finding | None:
    """Why a goal can't be reached any more, or not in time."""
    reached, failed = run.evidence.reached.get(name), run.evidence.failed.get(name)
    if failed is not None:
        return _failed(failed.time, "lesson-goal-failed", goal=goal_phrase(name))
    if check.within is None:
        return None
    within = _seconds(check.within)
    if reached is not None:
        if reached.time <= check.within + _ROUNDING:
            return None
        at = _seconds(reached.time)
        return _failed(
            reached.time, "lesson-goal-late", goal=goal_phrase(name), at=at, within=within
        )
    if run.now <= check.within:
        return None
    return _failed(run.now, "lesson-goal-open-within", goal=goal_phrase(name), within=within)


def _goals(run: _Run) -> Sequence[str]:
    """The names of all goals of the world."""
    if run.world is not None:
        return [goal.name for _, _, goal in run.world.goal.all()]
    return [goal.name for goal in run.evidence.report.goals] if run.evidence.report else ()


def _happens(check: Happens, run: _Run) -> Finding:
    occurrences = run.in_time(moments(check.what, run.evidence), check.within)
    if check.at_most is not None and len(occurrences) > check.at_most:
        at, most = occurrences[check.at_most].time, times_words(check.at_most)
        return _failed(at, "lesson-too-often", event=event_words(check.what, "past"), most=most)
    if len(occurrences) >= check.at_least and check.at_most is None:
        return _met(occurrences[check.at_least - 1].time if check.at_least else 0.0)
    if not run.is_over(check.within):
        return _OPEN
    if len(occurrences) >= check.at_least:
        return _met(run.now)
    return _too_seldom(check, run, len(occurrences))


def _too_seldom(check: Happens, run: _Run, count: int) -> Finding:
    event = event_words(check.what, "past")
    late = moments(check.what, run.evidence)[count:]
    if check.within is not None and late and count + 1 == check.at_least:
        at, within = late[0].time, _seconds(check.within)
        return _failed(at, "lesson-too-late", event=event, at=_seconds(at), within=within)
    if count == 0:
        return _failed(run.now, "lesson-not-happened", event=event_words(check.what, "missing"))
    least = times_words(check.at_least)
    return _failed(run.now, "lesson-too-seldom", event=event, times=times_words(count), least=least)


def _never(check: Never, run: _Run) -> Finding:
    occurrences = moments(check.what, run.evidence)
    if occurrences:
        at = occurrences[0].time
        event = event_words(check.what, "past")
        return _failed(at, "lesson-happened", event=event, at=_seconds(at))
    return _met(run.now) if run.has_ended else _OPEN


def _in_order(check: InOrder, run: _Run) -> Finding:
    #: When the events so far can have happened one after the other.
    so_far: Sequence[Moment] = ()
    for number, event in enumerate(check.events):
        occurrences = moments(event, run.evidence)
        fitting = [
            moment for moment in occurrences if not number or _follows(moment, so_far, check.within)
        ]
        if not fitting:
            # The events before it may happen again.
            return _out_of_order(check, run, number, so_far) if run.has_ended else _OPEN
        so_far = fitting
    return _met(so_far[0].time)


def _follows(moment: Moment, before: Sequence[Moment], within: float | None) -> bool:
    """Whether a moment comes after one of those before, and soon enough."""
    waited = _waited(moment, before)
    return waited is not None and (within is None or waited <= within + _ROUNDING)


def _waited(moment: Moment, before: Sequence[Moment]) -> float | None:
    """The seconds since the last of the moments before, which are in order; None without one."""
    index = bisect_left(before, moment)
    return moment.time - before[index - 1].time if index else None


def _out_of_order(check: InOrder, run: _Run, number: int, before: Sequence[Moment]) -> Finding:
    """Why an event is not there where it should be."""
    event = check.events[number]
    missing = event_words(event, "missing")
    if number == 0:
        return _failed(run.now, "lesson-not-happened", event=missing)
    last = event_words(check.events[number - 1])
    occurrences = moments(event, run.evidence)
    waits = [
        (waited, moment.time)
        for moment in occurrences
        if (waited := _waited(moment, before)) is not None
    ]
    if waits and check.within is not None:
        waited, at = min(waits)
        times = {"waited": _seconds(waited), "within": _seconds(check.within)}
        return _failed(at, "lesson-order-late", event=event_words(event), before=last, **times)
    if not occurrences:
        return _failed(run.now, "lesson-order-missing", event=missing, before=last)
    return _failed(run.now, "lesson-order-before", event=event_words(event), before=last)


def _on_line(check: StaysOnLine, run: _Run) -> Finding:
    line = run.world.line_named(check.line) if run.world else None
    if line is None:
        return _failed(None, "lesson-no-line", line=check.line) if run.has_ended else _OPEN
    path = run.evidence.path
    is_on = is_on_line(path, line.polyline(), check.distance)
    if True not in is_on:
        return _failed(run.now, "miss-line-never") if run.has_ended else _OPEN
    first = is_on.index(True)
    on, total = is_on.count(True), len(path) - first
    # Even if it stays on the line from now on.
    left = 0.0 if run.has_ended else max(0.0, run.seconds - run.now) * _POSES_PER_SECOND
    if on + left < check.share * (total + left):
        code = "lesson-line-share" if run.has_ended else "lesson-line-lost"
        return _failed(run.now, code, **_shares(on / total, check.share))
    if not run.has_ended:
        return _OPEN
    return _long_enough(check, run, path[first:])


def _long_enough(check: StaysOnLine, run: _Run, path: Sequence[Placed]) -> Finding:
    driven = length_of(path)
    if driven >= check.least:
        return _met(run.now)
    return _failed(run.now, "lesson-line-short", driven=_mm(driven), least=_mm(check.least))


_POSES_PER_SECOND = 10


def _shares(share: float, asked: float) -> dict[str, int]:
    # Down, so that a share that is too small never reads like the one that is asked.
    return {"share": math.floor(share * 100), "asked": round(asked * 100)}


def _drives(check: Drives, run: _Run) -> Finding:
    driven = run.evidence.distance
    if check.at_most is not None and driven > check.at_most:
        return _failed(run.now, "lesson-drove-far", driven=_mm(driven), most=_mm(check.at_most))
    if driven >= check.at_least and (check.at_most is None or run.has_ended):
        return _met(run.now)
    if not run.has_ended:
        return _OPEN
    return _failed(run.now, "lesson-drove-short", driven=_mm(driven), least=_mm(check.at_least))


def _ends_at(check: EndsAt, run: _Run) -> Finding:
    path = run.evidence.path
    if not run.has_ended:
        return _OPEN
    if not path:
        return _failed(run.now, "lesson-no-pose")
    last = path[-1]
    away = math.hypot(last.x - check.x, last.y - check.y)
    if away > check.radius:
        return _failed(run.now, "lesson-ended-away", away=_mm(away), radius=_mm(check.radius))
    if check.heading is not None:
        off = heading_between(check.heading, last.heading)
        if abs(off) > check.angle:
            return _failed(
                run.now, "lesson-ended-facing", off=round(abs(off)), angle=round(check.angle)
            )
    return _met(run.now)


def _turns(check: Turns, run: _Run) -> Finding:
    if not run.has_ended:
        return _OPEN
    turned = turned_along(run.evidence.path)
    if abs(turned - check.by) <= check.tolerance:
        return _met(run.now)
    return _failed(run.now, "lesson-turned", turned=round(turned), by=round(check.by))


def _ends(check: Ends, run: _Run) -> Finding:
    report = run.evidence.report
    if report is None:
        if run.is_over(check.within):
            return _failed(run.now, "lesson-still-running", within=_seconds(check.within or 0))
        return _OPEN
    if report.ended != How.FINISHED:
        code = _ENDINGS.get(report.ended, "lesson-ended-otherwise")
        return _failed(run.now, code)
    if check.within is not None and report.time > check.within:
        return _failed(
            run.now,
            "lesson-ended-late",
            at=_seconds(report.time),
            within=_seconds(check.within),
        )
    return _met(report.time)


_ENDINGS: Mapping[str, str] = {
    How.ERROR: "lesson-ended-error",
    How.TIME_LIMIT: "lesson-ended-time",
}


def _prints(check: Prints, run: _Run) -> Finding:
    left = iter(run.evidence.prints)
    for number, pattern in enumerate(check.lines):
        at = next((moment.time for moment, text in left if fits(text, pattern)), None)
        if at is None:
            if not run.has_ended:
                return _OPEN
            happened = any(fits(text, pattern) for _, text in run.evidence.prints)
            code = "lesson-printed-order" if happened and number else "lesson-not-printed"
            before = pattern_words(check.lines[number - 1]) if number else ""
            return _failed(run.now, code, line=pattern_words(pattern), before=before)
    return _met(at)


def _uses(check: Uses, program: Program) -> Finding:
    count = structure.count(program, check)
    what = uses_words(check)
    if count < check.at_least:
        if count == 0:
            return _failed(None, "lesson-uses-none", what=what)
        least = times_words(check.at_least)
        return _failed(None, "lesson-uses-few", what=what, times=times_words(count), least=least)
    if check.at_most == 0 and count:
        return _failed(None, "lesson-uses-not", what=what)
    if check.at_most is not None and count > check.at_most:
        most = times_words(check.at_most)
        return _failed(None, "lesson-uses-many", what=what, times=times_words(count), most=most)
    return _met(None)


def _size(check: Size, program: Program) -> Finding:
    blocks = structure.size(program)
    if blocks <= check.blocks:
        return _met(None)
    return _failed(None, "lesson-too-large", blocks=blocks, most=check.blocks)


def _seconds(value: float) -> float:
    return round(value, 1)


def _mm(value: float) -> int:
    return round(value)


_BEHAVIOUR: Mapping[type, Callable[[Any, _Run], Finding]] = {
    Reaches: _reaches,
    Happens: _happens,
    Never: _never,
    InOrder: _in_order,
    StaysOnLine: _on_line,
    Drives: _drives,
    EndsAt: _ends_at,
    Turns: _turns,
    Ends: _ends,
    Prints: _prints,
}
_STRUCTURE: Mapping[type, Callable[[Any, Program], Finding]] = {Uses: _uses, Size: _size}
