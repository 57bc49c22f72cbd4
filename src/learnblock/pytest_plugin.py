"""Fixtures for tests of programs and skills.

A file ``conftest.py`` beside the tests asks for them, so that no other tests load LearnBlock:

    pytest_plugins = ["learnblock.pytest_plugin"]
"""

from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from learnblock import robots, running
from learnblock.client import AnyRobot
from learnblock.errors import LearnBlockError
from learnblock.running.batch import CAN_FORK, Batch, WarmProcess

#: Runs a program and returns the report of its run.
Run = Callable[..., running.Report]


@pytest.fixture
def robot_name() -> str:
    """The robot of a test; `pytest.mark.parametrize` chooses others."""
    return "sim-ebo"


@pytest.fixture
def world() -> str | None:
    """The name or path of the world of a test; the robot's own by default."""
    return None


@pytest.fixture
def robot(robot_name: str, world: str | None) -> Iterator[AnyRobot]:
    """A simulated robot in its world, which is stopped at the end of the test."""
    with robots.connect(robot_name, world=world) as robot:
        # Type checkers can't know which robot it is.
        yield robot  # type: ignore[misc]


@pytest.fixture
def run(
    request: pytest.FixtureRequest,
    robot_name: str,
    world: str | None,
    _runs: WarmProcess | None,
) -> Run:
    """Run a program beside the file of the test, and return its report.

        def test_the_square_is_driven(run):
            assert "reached" == run("square.bt", world="square").goals[0].state

    A program with mistakes, or one that can't be run, fails the test.
    """
    chosen = running.Options(world=world, seconds=60)

    def run_program(file: str | Path, **options: Any) -> running.Report:
        path = request.path.parent / file
        try:
            job = _job(path, robot_name, replace(chosen, **options))
            ((_, result),) = Batch([job], 1, kept=_runs).results()
        except LearnBlockError as error:
            pytest.fail(str(error), pytrace=False)
        if result.lost:
            pytest.fail(f"{path.name}: {result.lost}", pytrace=False)
        return result.report

    return run_program


def _job(path: Path, robot_name: str, options: running.Options) -> running.Job:
    robot = robots.find(robot_name)
    return running.Job(running.program(running.read(path), robot), robot, options)


@pytest.fixture(scope="session")
def _runs() -> Iterator[WarmProcess | None]:
    """The process that makes the runs of all tests; without it, each is made here."""
    if not CAN_FORK:
        yield None
        return
    process = WarmProcess()
    yield process
    process.end()
