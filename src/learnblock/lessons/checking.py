"""A lesson tried out: its solutions have to pass, and its wrong programs to fail as they should."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import Literal

from learnblock.errors import ProgramError
from learnblock.i18n import Phrase
from learnblock.language.tree.nodes import Program
from learnblock.lessons.describing import describe
from learnblock.lessons.hints import Elsewhere, Hint, hints
from learnblock.lessons.judging import Verdict
from learnblock.lessons.lesson import Wrong
from learnblock.lessons.opened import OpenLesson
from learnblock.lessons.trying import (
    Attempt,
    JudgedRun,
    StopSwitch,
    attempts,
    read_program,
    try_step,
)

#: The most problems reported of one program.
_MOST_PROBLEMS = 5


@dataclass(frozen=True, slots=True)
class Follow:
    """How a check is followed and ended.

    Args:
        watch: called after each attempt.
        switch: ends the check.
    """

    watch: Callable[[JudgedRun], object] = lambda _: None
    switch: StopSwitch = field(default_factory=StopSwitch)


@dataclass(frozen=True, slots=True)
class ProgramCheck:
    """What has been found out about one of the teacher's programs.

    Args:
        kind: whether it is a solution, or a wrong program.
        step: the number of its step.
        file: its file.
        right: in how many attempts it did what it should.
        attempts: how many attempts were made.
        problems: what is wrong.
    """

    kind: Literal["solution", "wrong", "none"]
    step: int
    file: str
    right: int = 0
    attempts: int = 0
    problems: tuple[Phrase, ...] = ()

    @property
    def is_right(self) -> bool:
        """Whether nothing is wrong."""
        return not self.problems


def check_lesson(
    opened: OpenLesson,
    *,
    robots: Sequence[str] | None = None,
    variants: int | None = None,
    follow: Follow | None = None,
) -> Iterator[ProgramCheck]:
    """Try the teacher's programs; yield what is found as it comes.

    Args:
        opened: the lesson.
        robots: the robots; without them those that a step is meant for.
        variants: how many variants of the world; without it those of the step.
        follow: how it is followed and ended; once it is ended, nothing more is yielded.
    """
    follow = follow or Follow()
    for result in _results(opened, robots, variants, follow):
        if follow.switch.is_stopped:
            return
        yield result


def _results(
    opened: OpenLesson,
    robots: Sequence[str] | None,
    variants: int | None,
    follow: Follow,
) -> Iterator[ProgramCheck]:
    def attempts_here(step: int) -> tuple[Attempt, ...]:
        return attempts(opened, step, robots=robots, variants=variants)

    teacher = opened.teacher
    for number, step in enumerate(opened.lesson.step, start=1):
        file = teacher.solutions.get(str(number)) if teacher else None
        if file is not None:
            yield _solution(opened, number, file, attempts_here(number), follow)
        elif step.check:
            yield ProgramCheck("none", number, "")
    for wrong in teacher.wrong if teacher else ():
        yield _wrong(opened, wrong, attempts_here(wrong.step), follow)


def count_attempts(opened: OpenLesson) -> int:
    """How many attempts `check_lesson` makes."""
    if opened.teacher is None:
        return 0
    solved = (attempts(opened, int(number)) for number in opened.teacher.solutions)
    wrong = (_usual(attempts(opened, program.step)) for program in opened.teacher.wrong)
    return sum(map(len, solved)) + sum(map(len, wrong))


def _solution(
    opened: OpenLesson, step: int, file: str, plan: Sequence[Attempt], follow: Follow
) -> ProgramCheck:
    source = opened.text(f"teacher/solutions/{file}")
    try:
        runs = _tried(opened, step, (source, file), plan, follow)
    except ProgramError as error:
        return ProgramCheck("solution", step, file, 0, len(plan), (error.phrase,))
    runs.sort(key=lambda run: plan.index(run.attempt))
    failed = [(run, verdict) for run in runs for verdict in run.verdicts if not _is_met(verdict)]
    right = sum(all(map(_is_met, run.verdicts)) for run in runs)
    problems = tuple(_not_met(run, verdict) for run, verdict in failed[:_MOST_PROBLEMS])
    return ProgramCheck("solution", step, file, right, len(plan), problems)


def _tried(
    opened: OpenLesson,
    step: int,
    program: tuple[str, str],
    plan: Sequence[Attempt],
    follow: Follow,
) -> list[JudgedRun]:
    """Try a program, given by its text and its file's name."""
    source, file = program
    runs = []
    for run in try_step(opened, step, source, plan, filename=file, switch=follow.switch):
        follow.watch(run)
        runs.append(run)
    return runs


def _usual(plan: Sequence[Attempt]) -> list[Attempt]:
    """The attempts with the usual robot."""
    return [attempt for attempt in plan if attempt.robot == plan[0].robot]


def _is_met(verdict: Verdict) -> bool:
    return verdict.state == "met"


def _not_met(run: JudgedRun, verdict: Verdict) -> Phrase:
    return Phrase(
        "lesson-cli-not-met",
        robot=run.attempt.robot,
        variant=str(run.attempt.variant),
        check=describe(verdict.check),
        reason=verdict.explanation or "",
    )


def _wrong(
    opened: OpenLesson, wrong: Wrong, plan: Sequence[Attempt], follow: Follow
) -> ProgramCheck:
    """Try a wrong program with its usual robot: in the world as it is, and where that passes."""
    usual = _usual(plan)
    source = opened.text(f"teacher/wrong/{wrong.program}")
    try:
        runs = _tried(opened, wrong.step, (source, wrong.program), usual, follow)
    except ProgramError as error:
        return ProgramCheck("wrong", wrong.step, wrong.program, 0, len(usual), (error.phrase,))
    failing = sorted(
        (run for run in runs if _fails(run, wrong.check)), key=lambda run: run.attempt.variant
    )
    if not failing:
        problem = Phrase("lesson-cli-not-caught", check=wrong.check)
        return ProgramCheck("wrong", wrong.step, wrong.program, 0, len(usual), (problem,))
    problems = _hint_problems(opened, wrong, source, failing[0])
    return ProgramCheck("wrong", wrong.step, wrong.program, len(failing), len(usual), problems)


def _fails(run: JudgedRun, name: str) -> bool:
    return any(
        verdict.state == "failed"
        and name in (verdict.check.name, verdict.check.__struct_config__.tag)
        for verdict in run.verdicts
    )


def _hint_problems(
    opened: OpenLesson, wrong: Wrong, source: str, run: JudgedRun
) -> tuple[Phrase, ...]:
    tree = read_program(source, wrong.program).tree
    rules = tuple(hint.rule for hint in hints_for(opened, wrong.step, tree, run))
    if rules[:1] == (wrong.hint,):
        return ()
    hinted = rules or (Phrase("lesson-cli-no-hint"),)
    return (Phrase("lesson-cli-other-hint", wanted=wrong.hint, found=hinted),)


def hints_for(
    opened: OpenLesson, number: int, program: Program, run: JudgedRun
) -> tuple[Hint, ...]:
    """The hints for the first attempt of a program that fails, the best first.

    Args:
        opened: the lesson.
        number: the number of the step.
        program: the program.
        run: the attempt; the attempts before it have passed.
    """
    # A variant counts only if the world as it is passes.
    is_variant = run.attempt.variant > 0
    elsewhere = Elsewhere(is_variant=is_variant, passes_usually=is_variant)
    world = opened.described_world(number)
    return hints(
        opened.step(number),
        program,
        run.verdicts,
        run.evidence,
        world=world,
        elsewhere=elsewhere,
    )
