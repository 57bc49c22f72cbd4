"""Wrong programs get hints that fit: a sample of those in `benchmarks/lessons.py`."""

from itertools import islice

import pytest

from hint_cases import own_cases
from learnblock.evidence.evidence import evidence_of
from learnblock.language import parse
from learnblock.lessons.checks import Ends, EndsAt, Never, Printed, Prints, Reaches, Size
from learnblock.lessons.hints import gives_away, hints
from learnblock.lessons.judging import Verdict, judge
from learnblock.lessons.lesson import Step
from learnblock.lessons.mutants import mutants
from learnblock.running.result import RunResult
from places import ROOT
from runs import run_file

#: Exercises whose runs are short.
QUICK = ("corner", "counting", "distance", "heading", "loop-counter")
#: Checks that hardly any program meets.
WANTED = (
    Reaches(goals=("a lap",)),
    EndsAt(x=500, y=500),
    Ends(within=1),
    Prints(lines=("done",)),
    Never(what=Printed(what="*")),
)
CASES = [case for name in QUICK for case in own_cases(name)]


def hints_of(tmp_path, case):
    """The hints for a program, which is run in this process: that is fast."""
    step, world = case.lesson.step(1), case.lesson.described_world(1)
    file = tmp_path / "program.bt"
    file.write_text(case.program)
    robot = case.lesson.robots(1)[0]
    run = run_file(file, robot, world=step.world, seconds=step.seconds)
    tree, evidence = parse(case.program), evidence_of(RunResult(run.report, run.trace))
    return hints(step, tree, judge(step, tree, evidence, world), evidence, world=world)


@pytest.mark.parametrize("case", CASES, ids=[case.name for case in CASES])
def test_a_wrong_program_gets_a_right_hint_among_the_first_two(tmp_path, case):
    rules = [one.rule for one in hints_of(tmp_path, case)[:2]]
    assert set(rules) & set(case.wanted)


@pytest.mark.parametrize("name", ["square", "wall", "watch-out"])
def test_hints_for_mutants_are_whole_and_keep_the_solution_secret(tmp_path, name):
    source = (ROOT / "examples" / f"{name}.bt").read_text()
    step = Step(title="a", phase="make", text="b", world="line", check=WANTED)
    for mutant in islice(mutants(source), 6):
        file = tmp_path / "mutant.bt"
        file.write_text(mutant.source)
        run = run_file(file, "sim-thymio", world="line", seconds=3)
        tree, evidence = parse(mutant.source), evidence_of(RunResult(run.report, run.trace))
        found = hints(step, tree, judge(step, tree, evidence, None), evidence)
        assert found
        for one in found:
            assert 2 <= len(one.levels) <= 3
            assert all(map(str, (*one.levels, one.because)))
            assert gives_away(one, parse(source)) is None


def test_a_program_that_never_ran_gets_hints_about_how_it_is_built():
    program = parse("main:\n    x = 1\n    y = 2\nend\n")
    check = Size(blocks=1)
    step = Step(title="a", phase="make", text="b", check=(check,))
    (given, *_) = hints(step, program, [Verdict(check, 0, "failed")], None)
    assert given.rule == "hint-too-large"
