"""The command line, as people and scripts use it."""

import hashlib
import inspect
import itertools
import json
import os
import signal
import subprocess
import sys

import click
import pytest
from click.testing import CliRunner

from learnblock.cli import main
from learnblock.cli.commands import COMMANDS, load
from learnblock.runtime import standby
from runs import EXAMPLES, TWINS
from terminals import shown_on_a_terminal

SQUARE = str(EXAMPLES / "square.bt")


def call(*arguments, **options):
    """Run a command in this process."""
    return CliRunner().invoke(main, [str(argument) for argument in arguments], **options)


@pytest.fixture
def write(tmp_path):
    """Write a file and return its path."""

    def write(name, text):
        path = tmp_path / name
        path.write_text(text, encoding="utf-8")
        return path

    return write


def test_help_shows_every_command_and_how_to_start():
    shown = call("--help").output
    commands = (
        "open", "run", "check", "format", "convert", "robots", "new", "perception", "worlds",
        "skills", "demo",
    )  # fmt: skip
    for command in commands:
        assert f"\n  {command} " in shown
    assert "learnblock demo" in shown


def described(commands, path=()):
    """Return every command by its path, with the lines of its help."""
    for name, command in commands.items():
        yield (*path, name), inspect.cleandoc(command.help or "").splitlines()
        if isinstance(command, click.Group):
            yield from described(command.commands, (*path, name))


@pytest.mark.parametrize(
    ("words", "lines"), list(described({name: load(name) for name in COMMANDS}))
)
def test_examples_in_help_are_on_separate_lines(words, lines):
    shown = [line.strip() for line in call(*words, "--help").output.splitlines()]
    examples = [line for line in lines if line.startswith("learnblock ")]
    assert [line for line in examples if line not in shown] == []


def test_it_runs_as_a_module_too():
    command = [sys.executable, "-m", "learnblock", "--version"]
    shown = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    assert shown.startswith("learnblock, version ")


def test_run_prints_a_json_report():
    result = call("run", SQUARE, "--robot", "sim-ev3", "--world", "empty", "--json")
    report = json.loads(result.stdout)
    assert result.exit_code == 0
    assert report.keys() == {
        "time",
        "distance",
        "pose",
        "goals",
        "emotions",
        "no_effect",
        "collisions",
        "trace_sha256",
        "output",
        "ended",
        "error",
    }
    assert report["ended"] == "finished"
    assert 760 < report["distance"] < 840
    assert report["error"] is None


def test_run_ends_with_a_report_and_skills_without_effect():
    result = call("run", EXAMPLES / "dance.bt", "--robot", "sim-ev3", "--world", "empty")
    assert result.exit_code == 0
    assert "ended      finished" in result.stderr
    assert "no effect  expressJoy: sim-ev3 has no face" in result.stderr


def test_run_writes_a_trace_whose_hash_it_reports(tmp_path):
    trace = tmp_path / "trace.jsonl"
    result = call("run", SQUARE, "--robot", "sim-ev3", "--for", 3, "--trace", trace, "--json")
    lines = [json.loads(line) for line in trace.read_text().splitlines()]
    assert (
        hashlib.sha256(trace.read_bytes()).hexdigest() == json.loads(result.stdout)["trace_sha256"]
    )
    assert lines[0]["run"]["robot"] == "sim-ev3"
    assert lines[-1] == {"t": 3.0, "end": "time limit"}
    times = [line["t"] for line in lines if "pose" in line]
    assert max(b - a for a, b in itertools.pairwise(times)) <= 0.1 + 1e-9


@pytest.mark.parametrize("suffix", [".png", ".svg"])
def test_run_draws_a_picture(tmp_path, suffix):
    picture = tmp_path / f"square{suffix}"
    result = call("run", SQUARE, "--robot", "sim-ev3", "--for", 3, "--picture", picture)
    starts = {".png": b"\x89PNG", ".svg": b"<svg"}
    assert result.exit_code == 0
    assert starts[suffix] in picture.read_bytes()[:200]


def test_a_picture_in_another_format_is_refused_before_the_run(tmp_path):
    result = call("run", SQUARE, "--picture", tmp_path / "square.gif")
    assert result.exit_code == 2
    assert "must be a .png or .svg file." in result.stderr


def test_the_json_report_has_what_the_program_prints(write):
    result = call("run", write("says.bt", 'print("hello")\nprint(3)\n'), "--json")
    assert json.loads(result.stdout)["output"] == "hello\n3\n"


def test_the_json_report_of_a_program_that_cannot_be_read_is_refused(write):
    result = call("run", write("broken.bt", "x = (1\n"), "--json")
    report = json.loads(result.stdout)
    assert (result.exit_code, report["ended"], report["error"]["line"]) == (1, "refused", 1)


@pytest.mark.parametrize(("short", "long"), [("bt", "block-text"), ("py", "python")])
def test_a_notation_can_be_named_by_the_ending_of_its_files(write, short, long):
    program = write("x.bt", "x = 1\n")
    assert call("convert", program, "--to", short).stdout == (
        call("convert", program, "--to", long).stdout
    )


def test_an_error_is_reported_at_the_line_of_block_text(write):
    program = write("broken.bt", "x = 0\nmain:\n    function.stop_bot()\n    x = 1 / x\nend\n")
    result = call("run", program, "--json")
    error = json.loads(result.stdout)["error"]
    assert result.exit_code == 3
    assert (error["file"], error["line"]) == ("broken.bt", 4)
    assert error["message"].endswith("\nPython: ZeroDivisionError: division by zero")
    assert error["text"] == "x = 1 / x"


def test_an_error_is_reported_at_the_line_of_python(write):
    program = write(
        "broken.py",
        "from learnblock.robots.sim_ebo import Robot\n\nrobot = Robot()\n\nrobot.fly()\n",
    )
    result = call("run", program)
    assert result.exit_code == 1
    assert "broken.py:5" in result.stderr
    assert "fly" in result.stderr


def test_a_program_with_mistakes_is_not_run(write):
    program = write("typo.bt", "function.move_strait()\n")
    result = call("run", program)
    assert result.exit_code == 1
    assert "Did you mean 'move_straight'?" in result.stderr


def test_a_program_that_is_not_run_leaves_no_process(write, monkeypatch):
    started = []

    class Noted(standby.Standby):
        def __init__(self):
            super().__init__()
            started.append(self.process)

    monkeypatch.setattr(standby, "Standby", Noted)
    assert call("run", write("typo.bt", "function.move_strait()\n")).exit_code == 1
    assert [one.returncode is None for one in started] == [False]


def test_a_query_without_a_sensor_is_refused_unless_run_anyway():
    wall = EXAMPLES / "wall.bt"
    options = ("--robot", "sim-ev3", "--world", "walls")
    refused = call("run", wall, *options)
    anyway = call("run", wall, *options, "--anyway", "--for", 20, "--json")
    assert refused.exit_code == 1
    assert "This robot has no distance sensor on the right" in refused.stderr
    (missed,) = json.loads(anyway.stdout)["no_effect"]
    assert (missed["skill"], missed["device"]) == ("is_right_obstacle", "obstacle-right")


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (["--robot", "sim-ebbo"], "There is no robot 'sim-ebbo'. Did you mean 'sim-ebo'?"),
        (["--world", "lin"], "There is no world 'lin'. Did you mean 'line'?"),
        (["--pace", "fast"], "The pace has to be free, real or a positive number"),
    ],
)
def test_an_invalid_choice_is_reported_with_advice(arguments, sentence):
    result = call("run", SQUARE, *arguments)
    assert result.exit_code == 2
    assert sentence in result.stderr


def test_check_prints_position_code_and_message_and_exits_with_1(write):
    program = write("typo.bt", "main:\n    function.move_strait()\nend\n")
    result = call("check", program)
    assert result.exit_code == 1
    assert result.stdout.startswith(f"{program}:2:5: unknown-skill ")


def test_warnings_alone_are_not_a_failure():
    result = call("check", EXAMPLES / "line-thymio.bt", "--robot", "sim-thymio")
    assert result.exit_code == 0
    assert "missing-device" in result.stdout


def test_check_says_that_a_program_has_no_problems(write):
    program = write("first.bt", "main:\n    function.turn_back()\nend\n")
    result = call("check", program)
    assert (result.exit_code, result.stdout) == (0, f"{program}: no problems\n")
    assert call("check", program, "--json").stdout == "[]\n"


def test_the_report_has_a_short_hash_and_its_json_the_whole_one():
    whole = json.loads(call("run", SQUARE, "--world", "empty", "--json").stdout)["trace_sha256"]
    report = call("run", SQUARE, "--world", "empty").stderr
    assert len(whole) == 64
    assert f"trace      {whole[:12]}\n" in report


def test_check_can_print_json(write):
    program = write("typo.bt", "function.move_strait()\n")
    found = json.loads(call("check", program, "--json").stdout)
    assert [(one["line"], one["column"], one["severity"]) for one in found] == [(1, 1, "error")]


def test_format_rewrites_a_file_and_checks_without_touching_it(write):
    program = write("messy.bt", "main:\nfunction.stop_bot( )\nend\n")
    would = call("format", "--check", program)
    assert (would.exit_code, program.read_text()) == (1, "main:\nfunction.stop_bot( )\nend\n")
    assert call("format", program).exit_code == 0
    assert program.read_text() == "main:\n    function.stop_bot()\nend\n"
    assert call("format", "--check", program).exit_code == 0


@pytest.mark.parametrize("robot", [*TWINS, "ev3", "cozmo", "ebo", "thymio", "rcis"])
def test_convert_names_any_robot_in_the_import_line_only(robot):
    python = call("convert", SQUARE, "--to", "python", "--robot", robot).stdout
    first, *rest = python.splitlines()
    assert first == f"from learnblock.robots.{robot.replace('-', '_')} import Robot"
    assert rest == call("convert", SQUARE, "--to", "python").stdout.splitlines()[1:]


def test_convert_there_and_back_gives_the_same_text(write):
    python = write("square.py", call("convert", SQUARE, "--to", "python").stdout)
    assert (
        call("convert", python, "--to", "block-text").stdout == (EXAMPLES / "square.bt").read_text()
    )


def test_lists_can_be_printed_as_json():
    robots = json.loads(call("robots", "--json").stdout)
    worlds = json.loads(call("worlds", "--json").stdout)
    skills = json.loads(call("skills", "--json").stdout)
    assert {robot["name"] for robot in robots} >= set(TWINS)
    assert {"empty", "line", "tags", "labyrinth"} <= {world["name"] for world in worlds}
    turn = next(skill for skill in skills if skill["name"] == "turn")
    assert turn["needs"] == ["Base"]
    assert turn["languages"]["ES"]


def test_a_skill_is_explained():
    shown = call("skills", "turn").stdout
    assert "function.turn(angle, rotSpeed=120)" in shown
    assert "robot.turn(angle, rotSpeed=120)" in shown


def test_a_file_in_another_format_is_refused(write):
    result = call("run", write("notes.txt", "hello"))
    assert result.exit_code == 1
    assert "notes.txt:0:0: unknown-notation" in result.stderr


def test_a_file_that_is_not_utf_8_names_the_line(tmp_path):
    path = tmp_path / "latin.bt"
    path.write_bytes(b"x = 1\ny = '\xe9'\n")
    result = call("check", path)
    assert result.exit_code == 1
    assert result.stdout.startswith(f"{path}:2:0: not-utf-8 ")


@pytest.mark.skipif(os.name == "nt", reason="Windows has no SIGINT for one process")
def test_ctrl_c_ends_a_run_with_its_report(write):
    program = write("endless.bt", "while True:\n    function.move_straight()\n    print(1)\nend\n")
    command = [sys.executable, "-m", "learnblock", "run", program, "--pace", "real"]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert process.stdout.readline() == "1\n"
    process.send_signal(signal.SIGINT)
    _, errors = process.communicate(timeout=20)
    assert "ended      stopped" in errors
    assert process.returncode == 130


@pytest.mark.skipif(os.name == "nt", reason="Windows has no pseudo-terminals")
def test_a_terminal_shows_the_state_in_one_line():
    command = [sys.executable, "-m", "learnblock", "run", SQUARE, "--for", "4", "--pace", "5"]
    states = shown_on_a_terminal(command).split("\r\x1b[K")
    assert sum(" x real time" in state for state in states) > 2


def test_the_users_folder_adds_a_skill_a_world_and_a_robot(own_home, write):
    for name in ("skills", "worlds", "robots"):
        (own_home / name).mkdir()
    (own_home / "skills" / "mine.py").write_text(
        "def wiggle(robot, times: int = 2) -> None:\n"
        '    """Turn left and right."""\n'
        "    for _ in range(times):\n"
        "        robot.turn_left()\n"
        "        robot.sleep(0.5)\n"
        "        robot.turn_right()\n"
        "        robot.sleep(0.5)\n"
    )
    (own_home / "worlds" / "mine.toml").write_text('title = "My room"\n')
    (own_home / "robots" / "my_ebo.py").write_text(
        "from learnblock.robots.simulated import SimulatedRobot\n\n\n"
        "class Robot(SimulatedRobot):\n"
        '    description_name = "ebo"\n'
    )
    program = write("mine.bt", "function.wiggle(3)\n")
    result = call("run", program, "--robot", "my-ebo", "--world", "mine", "--json")
    assert json.loads(result.stdout)["time"] == 3.0
