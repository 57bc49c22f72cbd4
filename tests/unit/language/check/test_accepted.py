"""What the check passes does not end with an error of Python about names and types."""

import contextlib
import io
import random

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gate import examples
from learnblock.client.events import Events
from learnblock.language import check, from_python, from_workspace, parse, to_python, to_workspace
from learnblock.testing import VirtualClock
from ordered_programs import Ordered

MANY = settings(max_examples=examples(120, gate=60), database=None)
seeds = st.integers(min_value=0, max_value=2**32)


class Robot(Events):
    """A robot whose events end after some cycles."""

    def __init__(self):
        super().__init__()
        self.clock = VirtualClock()
        self.left = 4

    @property
    def stopped(self):
        return self.left <= 0

    def _cycle(self):
        super()._cycle()
        self.left -= 1


def run(python):
    """Run a program; print nothing, and stop what never ends."""
    code = compile(
        python.replace("from learnblock.robots.sim_ebo import Robot", ""), "p.py", "exec"
    )
    with contextlib.redirect_stdout(io.StringIO()):
        exec(code, {"Robot": Robot, "__name__": "__main__"})  # noqa: S102 - a program of this test


def accepted(program, python=None):
    found = check(program, {}, python=python)
    return not any(one.severity == "error" for one in found)


def drawn_anyhow(program, seed):
    """The program of the same blocks, drawn in any order."""
    workspace = to_workspace(program, {}).workspace
    random.Random(seed).shuffle(workspace.stacks)  # noqa: S311 - no secret
    return from_workspace(workspace, {}).program


def python_of_blocktext(seed):
    program = parse(Ordered(seed).blocktext)
    return to_python(program).text if accepted(program) else None


def python_of_blocks(seed):
    program = drawn_anyhow(parse(Ordered(seed).blocktext), seed)
    return to_python(program).text if accepted(program) else None


def python_of_python(seed):
    python = Ordered(seed).python
    return python if accepted(from_python(python), python) else None


NOTATIONS = [python_of_blocktext, python_of_blocks, python_of_python]


@pytest.mark.parametrize("notation", NOTATIONS)
@MANY
@given(seeds)
def test_a_program_that_passes_the_check_knows_its_names(notation, seed):
    python = notation(seed)
    if python is not None:
        run(python)


@pytest.mark.parametrize("notation", NOTATIONS)
def test_many_of_these_programs_pass_the_check(notation):
    assert sum(notation(seed) is not None for seed in range(100)) > 10
