"""What type checkers and editors make of programs."""

import json
import subprocess
import sys

import jedi
import pytest

from learnblock import robots
from learnblock.stubs.own import write_stubs

#: Two mistakes: arguments that don't fit, and a skill that no robot has.
PROGRAM = """\
from learnblock.robots.sim_ebo import Robot

robot = Robot()
robot.turn(90)
robot.drive_distance("x", 3, 4, 5)
robot.no_such_skill()
"""
#: EBO has a camera and no bumper.
OWN = """\
from learnblock_home.robots.rover import Robot

robot = Robot()
robot.waltz(2)
robot.waltz("two")
robot.turn(90)
robot.is_tag(3)
"""
ROVER = """\
from learnblock.devices import Base
from learnblock.client import Client


class Robot(Client):
    '''A rover.'''

    @classmethod
    def device_names(cls):
        return frozenset({"Base:ROBOT"})

    @classmethod
    def abilities(cls):
        return frozenset()
"""
WALTZ = '''\
def waltz(robot, times: int = 3) -> None:
    """Sway to the right and to the left."""
'''


@pytest.fixture
def programs(monkeypatch, tmp_path):
    """A folder of programs, with the stubs of a robot and of a skill of one's own."""
    home = tmp_path / "home"
    for file, text in {"robots/rover.py": ROVER, "skills/dance.py": WALTZ}.items():
        (home / file).parent.mkdir(parents=True)
        (home / file).write_text(text)
    monkeypatch.setenv("LEARNBLOCK_HOME", str(home))
    folder = tmp_path / "programs"
    write_stubs(folder)
    return folder


def mypy(folder, program) -> list[tuple[int, str]]:
    """The lines with mistakes, and the kind of each."""
    (folder / "program.py").write_text(program)
    command = [sys.executable, "-m", "mypy", "--output=json", "--cache-dir=.cache", "program.py"]
    checked = subprocess.run(command, check=False, capture_output=True, text=True, cwd=folder)
    mistakes = map(json.loads, checked.stdout.splitlines())
    return [(mistake["line"], mistake["code"]) for mistake in mistakes]


def pyright(folder, program) -> list[tuple[int, str]]:
    """The same by basedpyright, which brings pyright and the Node that it runs in."""
    (folder / "program.py").write_text(program)
    settings = {"typeCheckingMode": "standard", "reportMissingModuleSource": "none"}
    (folder / "pyrightconfig.json").write_text(json.dumps(settings))
    command = ["basedpyright", "--outputjson", "--pythonpath", sys.executable, "program.py"]
    checked = subprocess.run(
        [sys.executable, "-m", *command], check=False, capture_output=True, text=True, cwd=folder
    )
    mistakes = json.loads(checked.stdout)["generalDiagnostics"]
    return [(each["range"]["start"]["line"] + 1, each["rule"]) for each in mistakes]


@pytest.mark.slow
def test_mypy_finds_wrong_arguments_and_unknown_skills(programs):
    assert [(5, "call-arg"), (5, "arg-type"), (6, "attr-defined")] == mypy(programs, PROGRAM)


@pytest.mark.exhaustive
def test_mypy_knows_ones_own_robots_and_skills(programs):
    assert [(5, "arg-type"), (7, "attr-defined")] == mypy(programs, OWN)


@pytest.mark.exhaustive
@pytest.mark.timeout(300)  # It starts Node and reads the stubs of the standard library.
def test_pyright_finds_the_same(programs):
    call, name = "reportCallIssue", "reportAttributeAccessIssue"
    assert [(5, call), (6, name)] == pyright(programs, PROGRAM)
    assert [(5, "reportArgumentType"), (7, name)] == pyright(programs, OWN)


@pytest.mark.sample(1)
@pytest.mark.parametrize("name", robots.built_in())
def test_jedi_completes_skills_with_signature_and_first_sentence(name, tmp_path):
    program = f"from {robots.module_of(name)} import Robot\nrobot = Robot()\nrobot.tur"
    script = jedi.Script(program, project=jedi.Project(tmp_path, sys_path=sys.path))
    completed = {each.name: each for each in script.complete()}
    assert {"turn", "turn_back", "turn_left"} <= completed.keys()
    help_text = completed["turn"].docstring()
    assert help_text.startswith("turn(angle: float, rotSpeed: float=120) -> None\n\nTurn on the")
