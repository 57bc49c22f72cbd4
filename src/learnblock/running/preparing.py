"""From a program's file to a program on a robot: choose, check and translate."""

from importlib.util import find_spec

from learnblock import language, robots
from learnblock.blocks import builtin, installed_libraries
from learnblock.blocks.importable import Importable
from learnblock.blocks.known import all_configurations
from learnblock.errors import Diagnostic
from learnblock.robots import RobotEntry
from learnblock.running.source import Source
from learnblock.runtime.program import Program

DEFAULT_ROBOT = "sim-ebo"


def choose_robot(source: Source, name: str | None = None) -> RobotEntry:
    """Choose the robot called `name`, else the one named in the program, else the default.

    Raises:
        UnknownNameError: there is no such robot.
    """
    return robots.find(name or source.robot or DEFAULT_ROBOT)


def check(source: Source, robot: RobotEntry | None = None) -> list[Diagnostic]:
    """Check a program, for a robot if one is given; return its mistakes and warnings."""
    devices = robot.load().known_devices() if robot else None
    folder = source.path.resolve().parent
    beside = {one.name: one for one in installed_libraries.blocks_beside(folder, source.libraries)}
    skills = all_configurations().extended({**beside, **builtin()})
    found = installed_libraries.importable(folder, source.imports)
    python = source.text if source.is_python else None
    packages = _with_packages(found, source)
    return language.check(source.tree, skills, devices, packages, python=python)


def program(source: Source, robot: RobotEntry) -> Program:
    """Make the program that is run: the file itself if it is Python, else its translation."""
    folder = str(source.path.resolve().parent)
    if source.is_python:
        return Program(source.path.name, source.text, source.text, folder=folder)
    python = language.to_python(source.tree, robot.module)
    return Program(source.path.name, python.text, source.text, python.source_map, folder)


def _with_packages(found: Importable, source: Source) -> Importable:
    """The modules that Python can import; a library is `learnblock.libraries.NAME` there."""
    plain = source.imports - source.libraries
    packages = {one for one in plain if find_spec(one.partition(".")[0]) is not None}
    return Importable(found.libraries - plain, found.files | packages)
