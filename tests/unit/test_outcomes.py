"""The check predicts what becomes of any program on any robot."""

import random

import pytest

from learnblock import robots, running
from learnblock.blocks import builtin
from learnblock.running import Options, ProgramRun
from learnblock.runtime.process import ThreadWorker
from runs import TWINS

pytestmark = pytest.mark.spread

#: Values for parameters without a default, by their type.
VALUES = {"angle": "20", "float": "40", "int": "3", "string": '"CAMERA"', "apriltext": "1"}
#: Skills that only work together with other robots or a person.
LEFT_OUT = frozenset(("received", "message_value"))


def call(rng: random.Random) -> str:
    """A call of a random skill, with values where it needs some."""
    skill = builtin()[rng.choice(sorted(builtin().keys() - LEFT_OUT))]
    given = ", ".join(VALUES[one.type] for one in skill.parameters if one.required)
    called = f"function.{skill.name}({given})"
    return f"x = {called}" if skill.returns_value else called


def pair(seed: int) -> tuple[str, str]:
    """A random program of one to four skills, and a twin."""
    rng = random.Random(seed)  # noqa: S311 - not a secret
    lines = [call(rng) for _ in range(rng.randint(1, 4))]
    body = "\n".join(f"    {line}" for line in lines)
    return f"main:\n{body}\n    function.sleep(0.1)\nend\n", rng.choice(TWINS)


@pytest.mark.parametrize("seed", range(30))
def test_a_run_has_no_effect_where_the_check_said_so_and_nowhere_else(seed, tmp_path):
    text, robot = pair(seed)
    source = running.source_of(tmp_path / "program.bt", text, is_python=False)
    entry = robots.find(robot)
    verdict = running.runs_on(source)[robot]
    options = Options(world="empty", seconds=60)
    report = ProgramRun(running.program(source, entry), entry, options, worker=ThreadWorker).run()

    assert report.error is None, (text, report.error)
    foretold = {lack.skill.name for lack in (*verdict.missed, *verdict.refused)}
    assert {one["skill"] for one in report.no_effect} == foretold, text
