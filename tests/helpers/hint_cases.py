"""Wrong programs with the hints that they should get: `tests/cases/hints`, and lessons."""

import tomllib
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from learnblock.lessons.hints import Elsewhere, Hint, hints
from learnblock.lessons.judging import is_done
from learnblock.lessons.reading import OpenLesson, read_files
from learnblock.lessons.trying import JudgedRun, attempts, read_program, try_step
from places import ROOT

CASES = ROOT / "tests" / "cases" / "hints"
#: What a lesson's file needs besides the step of a case.
HEAD = """lesson = 1
title = "{name}"
level = 1
minutes = 10
aims = ["to be wrong"]
robots = ["{robot}"]

[[step]]
title = "{name}"
phase = "make"
text = "Solve it."
"""


@dataclass(frozen=True)
class Case:
    """A wrong program.

    Args:
        lesson: the lesson.
        step: the number of the step.
        name: a name for reports.
        program: the program.
        wanted: the rules of which one is right, the best first.
    """

    lesson: OpenLesson
    step: int
    name: str
    program: str
    wanted: tuple[str, ...]


def exercise(path: Path) -> tuple[OpenLesson, str]:
    """A lesson of one step from a file of cases, and its solution."""
    text = path.read_text("utf-8")
    read = tomllib.loads(text)
    step = text.partition("\nsolution =")[0].replace(f'robot = "{read["robot"]}"\n', "")
    head = HEAD.format(name=path.stem, robot=read["robot"])
    return read_files(path.stem, {"lesson.toml": (head + step).encode()}), read["solution"]


def own_cases(name: str = "*") -> Iterator[Case]:
    """The cases of `tests/cases/hints`."""
    for path in sorted(CASES.glob(f"{name}.toml")):
        lesson, _ = exercise(path)
        for number, wrong in enumerate(tomllib.loads(path.read_text("utf-8"))["wrong"], 1):
            codes = tuple(f"hint-{rule}" for rule in wrong["hint"])
            yield Case(lesson, 1, f"{path.stem} {number}", wrong["program"], codes)


def lesson_cases(lesson: OpenLesson) -> Iterator[Case]:
    """The typical wrong programs that the teacher's part of a lesson names."""
    for wrong in lesson.teacher.wrong if lesson.teacher else ():
        program = lesson.files[f"teacher/wrong/{wrong.program}"].decode()
        yield Case(lesson, wrong.step, f"{lesson.name} {wrong.program}", program, (wrong.hint,))


def failing(case: Case) -> tuple[JudgedRun | None, Elsewhere]:
    """The first attempt in which a program fails; None if it never does."""
    plan = attempts(case.lesson, case.step)
    usual = next(try_step(case.lesson, case.step, case.program, plan[:1]))
    if not is_done(usual.verdicts):
        return usual, Elsewhere()
    runs = try_step(case.lesson, case.step, case.program, plan[1:])
    others = {run.attempt: run for run in runs}
    for attempt in plan[1:]:
        if attempt in others and not is_done(others[attempt].verdicts):
            is_other = attempt.robot != plan[0].robot
            return others[attempt], Elsewhere(attempt.variant > 0, is_other, passes_usually=True)
    return None, Elsewhere()


def hints_for(case: Case) -> tuple[Hint, ...]:
    """The hints that a case gets."""
    run, elsewhere = failing(case)
    if run is None:
        return ()
    tree = read_program(case.program).tree
    step, world = case.lesson.step(case.step), case.lesson.described_world(case.step)
    return hints(step, tree, run.verdicts, run.evidence, world=world, elsewhere=elsewhere)
