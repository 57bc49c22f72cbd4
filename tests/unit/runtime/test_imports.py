"""The modules that Block-Text's `import` finds, in a child process and in a standalone program."""

import os
import subprocess
import sys

import pytest

LIBRARY = '''
steps = []

def waltz(robot, times=2):
    """Dance."""
    for _ in range(times):
        step(robot)

def step(robot):
    steps.append(len(steps))
    robot.sleep(0.1)
    print("step", len(steps))
'''
PROGRAM = """from learnblock.libraries.dance import *
from learnblock.robots.{robot} import Robot

robot = Robot()
robot.waltz(1)
robot.waltz()
"""


def installed(home):
    folder = home / "libraries" / "dance"
    folder.mkdir(parents=True)
    (folder / "__init__.py").write_text(LIBRARY)


@pytest.fixture
def home(tmp_path, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path / "home"))
    return tmp_path / "home"


def test_the_skills_of_an_installed_library_are_the_robots(run, home):
    installed(home)
    result = run(PROGRAM.format(robot="tiny"), header="")
    assert result.output == "step 1\nstep 2\nstep 3\n"


def test_a_trace_has_the_skill_of_a_library_but_not_the_skills_it_calls(run, home):
    installed(home)
    result = run(PROGRAM.format(robot="tiny"), header="")
    assert ["waltz", "waltz"] == [event["call"] for event in result.events if "call" in event]


def test_a_library_is_not_available_before_it_is_imported(run, home):
    installed(home)
    result = run("robot.waltz(1)")
    assert "'waltz'" in str(result.ending.phrase) or "`waltz`" in str(result.ending.phrase)


def test_a_file_next_to_the_program_has_plain_functions_and_skills(run, home, tmp_path):
    (tmp_path / "dance.py").write_text(LIBRARY + "def greet(name):\n    print('hello', name)\n")
    result = run(PROGRAM.format(robot="tiny") + "greet('Ana')\nprint(hasattr(robot, 'greet'))",
                 header="", folder=str(tmp_path))  # fmt: skip
    assert result.output == "step 1\nstep 2\nstep 3\nhello Ana\nFalse\n"


def test_a_file_next_to_the_program_comes_before_an_installed_library(run, home, tmp_path):
    installed(home)
    (tmp_path / "dance.py").write_text("def waltz(robot, times=0):\n    print('mine')\n")
    result = run(PROGRAM.format(robot="tiny"), header="", folder=str(tmp_path))
    assert result.output == "mine\nmine\n"


def test_a_skill_of_ours_is_not_hidden_by_a_library(run, home):
    folder = home / "libraries" / "dance"
    folder.mkdir(parents=True)
    (folder / "__init__.py").write_text("def sleep(robot, s=0): print('asleep')\n")
    text = "from learnblock.libraries.dance import *\nfrom learnblock.robots.tiny import Robot\n"
    result = run(text + "robot = Robot()\nrobot.sleep(0.1)\nprint('awake')", header="")
    assert result.output == "awake\n"


def test_a_program_without_a_host_finds_both(home, tmp_path):
    installed(home)
    (tmp_path / "names.py").write_text("def greet(name):\n    print('hello', name)\n")
    (tmp_path / "program.py").write_text(
        "from learnblock.libraries.names import *\n" + PROGRAM.format(robot="sim_ebo")
        + "greet('Ana')\n"
    )  # fmt: skip
    done = subprocess.run(
        [sys.executable, str(tmp_path / "program.py")],
        env={**os.environ, "LEARNBLOCK_HOME": str(home)},
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.stdout == "step 1\nstep 2\nstep 3\nhello Ana\n", done.stderr
