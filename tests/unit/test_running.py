"""From a file to a run, as the docs describe it."""

import dataclasses
import re

import pytest

from learnblock import robots, running
from learnblock.errors import ProgramError, UnknownNameError
from learnblock.running.source import LARGEST_PROGRAM
from learnblock.runtime.ending import How
from learnblock.runtime.limits import MEGABYTE, Limits
from places import ROOT
from runs import EXAMPLES, run_example

PAGE = (ROOT / "docs" / "running.md").read_text(encoding="utf-8")


def test_the_page_lists_every_field_of_a_report_in_order():
    report = PAGE.partition("| field | meaning |")[2].partition("The exit code")[0]
    fields = [field.name for field in dataclasses.fields(running.Report)]
    assert fields == re.findall(r"^\| `(\w+)` \|", report, re.MULTILINE)


def test_the_page_lists_every_ending():
    line = next(line for line in PAGE.splitlines() if line.startswith("| `ended` |"))
    assert {*How, "refused"} == set(re.findall(r"`([a-z ]+)`", line)) - {"ended"}


def test_the_page_lists_the_limits():
    limits = Limits()
    assert limits.memory == 2048 * MEGABYTE
    assert limits.cpu == 3600
    assert (limits.open_files, limits.file_size, limits.output) == (64, 16 * MEGABYTE, MEGABYTE)
    assert limits.silence == 5
    text = " ".join(PAGE.split())
    assert "2 GB of memory, an hour of processor time, 64 open files of at most 16 MB" in text


def test_a_python_file_names_its_robot_and_another_can_be_chosen(tmp_path):
    path = tmp_path / "program.py"
    path.write_text("from learnblock.robots.sim_ev3 import Robot\n\nrobot = Robot()\n")
    source = running.read(path)
    assert running.choose_robot(source).name == "sim-ev3"
    assert running.choose_robot(source, "sim-cozmo").name == "sim-cozmo"


def test_a_file_too_large_for_a_program_is_refused(tmp_path):
    path = tmp_path / "huge.bt"
    path.write_text("#" * (LARGEST_PROGRAM + 1))
    with pytest.raises(ProgramError, match="too-large"):
        running.read(path)


def test_a_robot_known_only_once_connected_is_refused_before_the_first_line(monkeypatch):
    robot = robots.find("sim-ebo").load()
    monkeypatch.setattr(robot, "known_equipment", lambda: None)
    assert running.check(running.read(EXAMPLES / "first/edge.bt"), robots.find("sim-ebo")) == []
    report = run_example("first/edge.bt", "sim-ebo").report
    assert (report.ended, report.time) == ("error", 0)
    assert str(report.error["message"]).startswith(
        "The program has an error on line 4. This robot has no ground sensors"
    )
    assert run_example("first/edge.bt", "sim-ebo", anyway=True).report.ended == "finished"


def test_an_unknown_example_is_named():
    with pytest.raises(UnknownNameError, match=r"Did you mean 'square\.bt'"):
        running.example("sqare.bt")


def codes(path):
    return [one.code for one in running.check(running.read(path))]


def test_a_program_may_import_files_next_to_it(tmp_path, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path / "home"))
    path = tmp_path / "program.bt"
    path.write_text('import "dance"\nfunction.waltz(3)\ngreet("Ana")\n')
    assert codes(path) == ["unknown-library", "unknown-skill"]
    (tmp_path / "dance.py").write_text("def waltz(robot, n): pass\ndef greet(name): pass\n")
    assert codes(path) == []


def test_functions_of_imported_files_need_what_they_ask_for(tmp_path, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path / "home"))
    (tmp_path / "helpers.py").write_text(
        "from parts.eyes import look\n\n\n"
        "def follow(who):\n    while not look(who):\n        who.move_straight(50)\n\n\n"
        "def greet(who):\n    who.expressJoy()\n"
    )
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts" / "eyes.py").write_text(
        "import helpers\n\n\ndef look(who):\n    return who.is_tag(1)\n"
    )
    path = tmp_path / "program.py"
    path.write_text(
        "import helpers as h\nfrom helpers import greet as hello\n"
        "from learnblock.robots.sim_ev3 import Robot\n\nrobot = Robot()\n\n# main\n"
        "hello(robot)\nh.follow(robot)\n"
    )
    source = running.read(path)
    assert running.runs_on(source)["sim-cozmo"].runs
    refused = running.runs_on(source)["sim-ev3"].refused
    assert [(one.skill.name, one.needs) for one in refused] == [("h.follow", ("Camera",))]
    found = running.check(source, running.choose_robot(source))
    assert [(one.code, one.line, one.severity) for one in found] == [
        ("missing-device", 8, "warning"),
        ("missing-device", 9, "error"),
    ]
    assert "h.follow" in str(found[1].message)


def test_a_function_of_the_program_hides_an_imported_one(tmp_path):
    (tmp_path / "helpers.py").write_text("def look(who):\n    return who.is_tag(1)\n")
    path = tmp_path / "program.py"
    path.write_text(
        "from helpers import look\nfrom learnblock.robots.sim_ev3 import Robot\n\n"
        "robot = Robot()\n\n\ndef look(who):\n    return 1\n\n\n# main\nprint(look(robot))\n"
    )
    assert running.runs_on(running.read(path))["sim-ev3"].runs


def test_a_python_file_may_import_any_package(tmp_path):
    path = tmp_path / "program.py"
    path.write_text(
        "from numpy import *\nfrom learnblock.robots.sim_ebo import Robot\n\nrobot = Robot()\n"
    )
    assert codes(path) == []
    path.write_text(path.read_text().replace("numpy", "no_such_package"))
    assert codes(path) == ["unknown-library"]


def test_without_our_package_a_python_file_finds_no_library_and_no_skills_of_a_file(
    tmp_path, monkeypatch
):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path / "home"))
    folder = tmp_path / "home" / "libraries" / "dance"
    folder.mkdir(parents=True)
    (folder / "library.toml").write_text('learnblock = 1\nname = "dance"\nversion = "1"\n')
    (folder / "__init__.py").write_text("def waltz(robot): pass\n")
    (tmp_path / "helper.py").write_text("def sway(robot): pass\n")
    text = "from {0}{1} import *\nfrom learnblock.robots.sim_ebo import Robot\n\nrobot = Robot()\n"
    path = tmp_path / "program.py"
    for package, expected in (("learnblock.libraries.", []), ("", ["unknown-library"])):
        path.write_text(text.format(package, "dance"))
        assert codes(path) == expected
    for package, expected in (("learnblock.libraries.", []), ("", ["unknown-skill"])):
        path.write_text(text.format(package, "helper") + "robot.sway()\n")
        assert codes(path) == expected


@pytest.mark.parametrize(("name", "is_python"), [("PROG.BT", False), ("Test.Py", True)])
def test_the_ending_of_a_file_may_be_in_capitals(name, is_python, tmp_path):
    path = tmp_path / name
    path.write_text("print(1)\n", encoding="utf-8")
    assert is_python is running.read(path).is_python
