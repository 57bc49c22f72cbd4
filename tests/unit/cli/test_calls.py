"""The command `calls`."""

import pytest
from click.testing import CliRunner

from learnblock.cli import main

PROGRAM = "function.expressJoy()\nfunction.expressNeutral()\nfunction.move_straight(30)\n"


@pytest.fixture
def rows(tmp_path):
    """The rows of the calls of a program on a Cozmo."""
    program, log = tmp_path / "faces.bt", tmp_path / "faces.why"
    program.write_text(PROGRAM)
    runner = CliRunner()
    options = ["--robot", "sim-cozmo", "--why", str(log)]
    assert runner.invoke(main, ["run", str(program), *options]).exit_code == 0
    return runner.invoke(main, ["calls", str(log)]).output.splitlines()


def test_what_several_call_says_that_its_numbers_are_those_of_all_of_them(rows):
    shown = [row.split() for row in rows if "sim-cozmo.show_emotion" in row]
    assert [(row[1], " ".join(row[5:])) for row in shown] == [("2x", "of all callers")] * 2


def test_what_only_one_calls_has_its_own_numbers(rows):
    [drive] = [row for row in rows if "sim-cozmo.drive" in row]
    assert drive.endswith("%")
