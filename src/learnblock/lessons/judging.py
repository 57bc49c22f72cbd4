"""Judges programs by a lesson's checks, as early as possible, and gives the reason."""

from bisect import bisect_left
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from learnblock.evidence.evidence import Evidence, Moment
from learnblock.evidence.gaps import rounded_seconds
from learnblock.evidence.missed_goals import Miss
from learnblock.i18n import Phrase
from learnblock.i18n.names import goal_phrase
from learnblock.language.tree.nodes import Program
from learnblock.lessons import driven_way, structure
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
from learnblock.lessons.finding import OPEN, ROUNDING, Finding, RunSoFar, State, failed_at, met_at
from learnblock.lessons.happening import fits, moments
from learnblock.lessons.lesson import Step
from learnblock.lessons.misses import missed
from learnblock.runtime.ending import How
from learnblock.simulator import WorldDescription


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


#: Says what an expert's check has found in a run that is over.
ExpertJudge = Callable[[Expert, Evidence], Finding]


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
        finding = self._finding(check, evidence)
        miss = None
        if finding.state == "failed" and evidence is not None:
            miss = missed(check, evidence, self.world)
        return Verdict(check, index, finding.state, finding.at, finding.reason, miss)

    def _finding(self, check: Check, evidence: Evidence | None) -> Finding:
        if isinstance(check, Uses | Size):
            return OPEN if self.program is None else _STRUCTURE[type(check)](check, self.program)
        if evidence is None:
            return OPEN
        if isinstance(check, Expert):
            return self._expert(check, evidence)
        return _BEHAVIOUR[type(check)](check, RunSoFar(evidence, self.world, self.step.seconds))

    def _expert(self, check: Expert, evidence: Evidence) -> Finding:
        if self.experts is None or not evidence.has_ended:
            return OPEN
        return self.experts(check, evidence)


def _reaches(check: Reaches, run: RunSoFar) -> Finding:
    goals = check.goals or _goals(run)
    for name in goals:
        if lost := _lost(name, check, run):
            return lost
    missing = [name for name in goals if name not in run.evidence.reached]
    if goals and not missing:
        return met_at(max(run.evidence.reached[name].time for name in goals))
    if not run.has_ended:
        return OPEN
    if not goals:
        return failed_at(run.now, "lesson-no-goals")
    return failed_at(run.now, "lesson-goal-open", goal=goal_phrase(missing[0]))


def _lost(name: str, check: Reaches, run: RunSoFar) -> Finding | None:
    """Why a goal can't be reached any more, or not in time."""
    reached, failed = run.evidence.reached.get(name), run.evidence.failed.get(name)
    if failed is not None:
        return failed_at(failed.time, "lesson-goal-failed", goal=goal_phrase(name))
    if check.within is None:
        return None
    within = rounded_seconds(check.within)
    if reached is not None:
        if reached.time <= check.within + ROUNDING:
            return None
        at = rounded_seconds(reached.time)
        return failed_at(
            reached.time, "lesson-goal-late", goal=goal_phrase(name), at=at, within=within
        )
    if run.now <= check.within:
        return None
    return failed_at(run.now, "lesson-goal-open-within", goal=goal_phrase(name), within=within)


def _goals(run: RunSoFar) -> Sequence[str]:
    """The names of all goals of the world."""
    if run.world is not None:
        return [goal.name for _, _, goal in run.world.goal.all()]
    return [goal.name for goal in run.evidence.report.goals] if run.evidence.report else ()


def _happens(check: Happens, run: RunSoFar) -> Finding:
    occurrences = run.in_time(moments(check.what, run.evidence), check.within)
    if check.at_most is not None and len(occurrences) > check.at_most:
        at, most = occurrences[check.at_most].time, times_words(check.at_most)
        return failed_at(at, "lesson-too-often", event=event_words(check.what, "past"), most=most)
    if len(occurrences) >= check.at_least and check.at_most is None:
        return met_at(occurrences[check.at_least - 1].time if check.at_least else 0.0)
    if not run.is_over(check.within):
        return OPEN
    if len(occurrences) >= check.at_least:
        return met_at(run.now)
    return _too_seldom(check, run, len(occurrences))


def _too_seldom(check: Happens, run: RunSoFar, count: int) -> Finding:
    event = event_words(check.what, "past")
    late = moments(check.what, run.evidence)[count:]
    if check.within is not None and late and count + 1 == check.at_least:
        at, within = late[0].time, rounded_seconds(check.within)
        return failed_at(at, "lesson-too-late", event=event, at=rounded_seconds(at), within=within)
    if count == 0:
        return failed_at(run.now, "lesson-not-happened", event=event_words(check.what, "missing"))
    least = times_words(check.at_least)
    return failed_at(
        run.now, "lesson-too-seldom", event=event, times=times_words(count), least=least
    )


def _never(check: Never, run: RunSoFar) -> Finding:
    occurrences = moments(check.what, run.evidence)
    if occurrences:
        at = occurrences[0].time
        event = event_words(check.what, "past")
        return failed_at(at, "lesson-happened", event=event, at=rounded_seconds(at))
    return met_at(run.now) if run.has_ended else OPEN


def _in_order(check: InOrder, run: RunSoFar) -> Finding:
    #: When the events so far can have happened one after the other.
    so_far: Sequence[Moment] = ()
    for number, event in enumerate(check.events):
        occurrences = moments(event, run.evidence)
        fitting = [
            moment for moment in occurrences if not number or _follows(moment, so_far, check.within)
        ]
        if not fitting:
            # The events before it may happen again.
            return _out_of_order(check, run, number, so_far) if run.has_ended else OPEN
        so_far = fitting
    return met_at(so_far[0].time)


def _follows(moment: Moment, before: Sequence[Moment], within: float | None) -> bool:
    """Whether a moment comes after one of those before, and soon enough."""
    waited = _waited(moment, before)
    return waited is not None and (within is None or waited <= within + ROUNDING)


def _waited(moment: Moment, before: Sequence[Moment]) -> float | None:
    """The seconds since the last of the moments before, which are in order; None without one."""
    index = bisect_left(before, moment)
    return moment.time - before[index - 1].time if index else None


def _out_of_order(check: InOrder, run: RunSoFar, number: int, before: Sequence[Moment]) -> Finding:
    """Why an event is not there where it should be."""
    event = check.events[number]
    missing = event_words(event, "missing")
    if number == 0:
        return failed_at(run.now, "lesson-not-happened", event=missing)
    last = event_words(check.events[number - 1])
    occurrences = moments(event, run.evidence)
    waits = [
        (waited, moment.time)
        for moment in occurrences
        if (waited := _waited(moment, before)) is not None
    ]
    if waits and check.within is not None:
        waited, at = min(waits)
        times = {"waited": rounded_seconds(waited), "within": rounded_seconds(check.within)}
        return failed_at(at, "lesson-order-late", event=event_words(event), before=last, **times)
    if not occurrences:
        return failed_at(run.now, "lesson-order-missing", event=missing, before=last)
    return failed_at(run.now, "lesson-order-before", event=event_words(event), before=last)


def _ends(check: Ends, run: RunSoFar) -> Finding:
    report = run.evidence.report
    if report is None:
        if run.is_over(check.within):
            return failed_at(
                run.now, "lesson-still-running", within=rounded_seconds(check.within or 0)
            )
        return OPEN
    if report.ended != How.FINISHED:
        code = _ENDINGS.get(report.ended, "lesson-ended-otherwise")
        return failed_at(run.now, code)
    if check.within is not None and report.time > check.within:
        return failed_at(
            run.now,
            "lesson-ended-late",
            at=rounded_seconds(report.time),
            within=rounded_seconds(check.within),
        )
    return met_at(report.time)


_ENDINGS: Mapping[str, str] = {
    How.ERROR: "lesson-ended-error",
    How.TIME_LIMIT: "lesson-ended-time",
}


def _prints(check: Prints, run: RunSoFar) -> Finding:
    rest = iter(run.evidence.prints)
    for number, pattern in enumerate(check.lines):
        at = next((moment.time for moment, text in rest if fits(text, pattern)), None)
        if at is None:
            if not run.has_ended:
                return OPEN
            happened = any(fits(text, pattern) for _, text in run.evidence.prints)
            code = "lesson-printed-order" if happened and number else "lesson-not-printed"
            before = pattern_words(check.lines[number - 1]) if number else ""
            return failed_at(run.now, code, line=pattern_words(pattern), before=before)
    return met_at(at)


def _uses(check: Uses, program: Program) -> Finding:
    count = structure.count(program, check)
    what = uses_words(check)
    if count < check.at_least:
        if count == 0:
            return failed_at(None, "lesson-uses-none", what=what)
        least = times_words(check.at_least)
        return failed_at(None, "lesson-uses-few", what=what, times=times_words(count), least=least)
    if check.at_most == 0 and count:
        return failed_at(None, "lesson-uses-not", what=what)
    if check.at_most is not None and count > check.at_most:
        most = times_words(check.at_most)
        return failed_at(None, "lesson-uses-many", what=what, times=times_words(count), most=most)
    return met_at(None)


def _size(check: Size, program: Program) -> Finding:
    blocks = structure.size(program)
    if blocks <= check.blocks:
        return met_at(None)
    return failed_at(None, "lesson-too-large", blocks=blocks, most=check.blocks)


_BEHAVIOUR: Mapping[type, Callable[[Any, RunSoFar], Finding]] = {
    Reaches: _reaches,
    Happens: _happens,
    Never: _never,
    InOrder: _in_order,
    StaysOnLine: driven_way.on_line,
    Drives: driven_way.drives,
    EndsAt: driven_way.ends_at,
    Turns: driven_way.turns,
    Ends: _ends,
    Prints: _prints,
}
_STRUCTURE: Mapping[type, Callable[[Any, Program], Finding]] = {Uses: _uses, Size: _size}
