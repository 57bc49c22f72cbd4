"""Which robots run a program, and what serves a skill, on the command line."""

import json

import pytest
from click.testing import CliRunner

from learnblock.cli import main
from learnblock.cli.console import ExitCode


@pytest.fixture
def program(tmp_path):
    def written(text, name="program.bt"):
        (tmp_path / name).write_text(text, "utf-8")
        return str(tmp_path / name)

    return written


def call(*arguments):
    return CliRunner().invoke(main, list(arguments))


def line_of(output, robot):
    return next(line for line in output.splitlines() if line.split()[:1] == [robot])


def test_check_says_which_robots_run_a_program_and_why_others_cannot(program):
    file = program("while True:\n    x = function.is_left_obstacle()\nend\nfunction.expressJoy()\n")
    result = call("check", file, "--all-robots")

    assert result.exit_code == ExitCode.WELL
    assert result.output.startswith(file)
    served = "runs, with the distance sensors on the left"
    assert line_of(result.output, "sim-ebo").endswith(served)
    assert "can't run it: has no distance sensor on the left" in line_of(result.output, "sim-ev3")
    assert "depends on its settings" in line_of(result.output, "coppeliasim")


def test_decoration_that_a_robot_lacks_is_named(program):
    result = call("check", program('function.say_Text("hi")\n'), "--all-robots")
    assert line_of(result.output, "sim-thymio").endswith("runs, but has no voice")


def test_a_program_that_draws_runs_only_in_worlds(program):
    result = call("check", program("function.pen_down()\n"), "--all-robots")
    assert line_of(result.output, "sim-thymio").split()[1:] == ["runs"]
    assert line_of(result.output, "thymio").endswith(
        "can't run it: has no pen (simulated robots have one)"
    )


def test_a_text_is_decoration_for_a_robot_without_a_screen(program):
    result = call("check", program('function.show_text("hi")\n'), "--all-robots")
    assert line_of(result.output, "sim-thymio").split()[1:] == ["runs"]
    assert line_of(result.output, "thymio").endswith("runs, but has no screen")


def test_the_verdicts_are_also_json(program):
    (found,) = json.loads(call("check", program("x = 1\n"), "--all-robots", "--json").output)
    assert found["robots"]["sim-ebo"] == {"runs": True, "message": "runs"}
    assert found["robots"]["coppeliasim"]["runs"] is None


def test_a_program_that_cannot_be_read_fails_and_the_others_are_judged(program):
    broken, good = program("if:\n", "broken.bt"), program("x = 1\n", "good.bt")
    result = call("check", broken, good, "--all-robots")

    assert result.exit_code == ExitCode.MISTAKES
    assert good in result.output


def test_one_robot_and_all_robots_exclude_each_other(program):
    result = call("check", program("x = 1\n"), "--all-robots", "--robot", "sim-ebo")
    assert result.exit_code == ExitCode.USAGE
    assert "'--robot' and '--all-robots'" in result.output


def test_skills_says_what_serves_a_skill_on_each_robot():
    output = call("skills", "is_center_black_line").output
    assert "Needs: camera or ground sensors" in output
    assert line_of(output, "sim-ebo").split()[1:] == ["camera"]
    assert line_of(output, "ev3").split()[1:] == ["ground", "sensors"]


def test_a_robot_whose_devices_depend_on_its_settings_is_listed_too():
    output = call("skills", "is_center_black_line").output
    assert line_of(output, "coppeliasim").endswith("depends on its settings")


def test_a_robot_that_cannot_serve_a_skill_is_listed_with_what_it_lacks():
    output = call("skills", "is_center_red_line").output
    assert line_of(output, "thymio").split()[1:] == ["no", "camera"]


@pytest.mark.parametrize("skill", ["matrix_icon", "get_IR", "select_audio"])
def test_that_no_robot_can_do_a_skill_is_said_once(skill):
    result = call("skills", skill)
    assert "None of LearnBlock's robots has this. A robot of your own can" in result.output
    assert "sim-ebo" not in result.output


def test_check_says_that_no_robot_has_what_a_program_needs(program):
    file = program("x = function.get_IR()\n")
    result = call("check", file, "--robot", "sim-ebo")
    assert "none of LearnBlock's robots has one, but a robot of your own can" in result.output
    assert result.exit_code == ExitCode.MISTAKES
