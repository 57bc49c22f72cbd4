"""From a program's file to a program on a robot: choose, check and translate."""

from collections.abc import Mapping
from importlib.util import find_spec
from pathlib import Path
from types import MappingProxyType

from learnblock import language, robots
from learnblock.blocks import BlockConfiguration, builtin, installed_libraries
from learnblock.blocks.importable import Importable
from learnblock.blocks.known import all_configurations
from learnblock.blocks.schema.configuration import Configurations
from learnblock.errors import Diagnostic, LearnBlockError
from learnblock.i18n import Phrase
from learnblock.language.check.robots import Demand, Verdict, demands, verdict
from learnblock.language.check.used_skills import imports_of
from learnblock.language.tree.nodes import Program as Tree
from learnblock.robots import RobotEntry
from learnblock.running.source import Source
from learnblock.runtime.program import Program
from learnblock.wheels import Drivetrain

DEFAULT_ROBOT = "sim-ebo"
#: The most robots in one run.
MOST_ROBOTS = 30


def choose_robot(source: Source, name: str | None = None) -> RobotEntry:
    """Choose the robot called `name`, else the one named in the program, else the default.

    Raises:
        UnknownNameError: there is no such robot.
    """
    return robots.find(name or source.robot or DEFAULT_ROBOT)


def check(source: Source, robot: RobotEntry | None = None) -> list[Diagnostic]:
    """Check a program, for a robot if one is given; return its mistakes and warnings."""
    if robot is None:
        return _checked(source, None)
    kind = robot.load()
    return _checked(source, kind.known_equipment(), kind.drivetrain())


def lacking(source: Source, equipment: frozenset[str]) -> Phrase | None:
    """What a robot lacks for a program, once it is connected and its equipment is known."""
    diagnostics = _checked(source, equipment)
    errors = (
        diagnostic
        for diagnostic in diagnostics
        if diagnostic.code == "missing-device" and diagnostic.severity == "error"
    )
    first = next(errors, None)
    if first is None:
        return None
    return Phrase("check-program-error-in-line", line=str(first.line), problem=first.message)


def runs_on(source: Source) -> dict[str, Verdict | Phrase]:
    """For each robot, whether it can run a program, or why that is unknown."""
    skills = _skills(source)
    return verdicts(source.tree, skills, _functions(source, skills))


def verdicts(
    tree: Tree,
    skills: Mapping[str, BlockConfiguration],
    functions: Mapping[str, BlockConfiguration] = MappingProxyType({}),
) -> dict[str, Verdict | Phrase]:
    """For each robot, whether it can run a program, as `runs_on`.

    Args:
        tree: the program.
        skills: the skills that it can use.
        functions: see `learnblock.blocks.importable.Importable`.
    """
    demanded = demands(tree, skills, functions)
    return {entry.name: _verdict(demanded, entry) for entry in robots.entries().values()}


def program(source: Source, robot: RobotEntry) -> Program:
    """Make the program that is run: the file itself if it is Python, else its translation."""
    folder = str(_folder(source))
    if source.is_python:
        return Program(source.path.name, source.text, source.text, folder=folder)
    python = language.to_python(source.tree, robot.module)
    return Program(source.path.name, python.text, source.text, python.source_map, folder)


def _checked(
    source: Source, equipment: frozenset[str] | None, drivetrain: Drivetrain | None = None
) -> list[Diagnostic]:
    python = source.text if source.is_python else None
    skills = _skills(source)
    importable = _importable(source, skills)
    return language.check(
        source.tree, skills, equipment, importable, python=python, drivetrain=drivetrain
    )


def _verdict(demanded: tuple[Demand, ...], robot: RobotEntry) -> Verdict | Phrase:
    try:
        equipment = robot.load().known_equipment()
    except LearnBlockError as error:
        # A robot of the user's or of a plugin, whose file is broken.
        return error.phrase
    return Phrase("check-robot-unknown") if equipment is None else verdict(demanded, equipment)


def _skills(source: Source) -> Configurations:
    """The skills that a program can use."""
    beside = installed_libraries.blocks_beside(_folder(source), source.libraries)
    by_name = {block.name: block for block in beside}
    return all_configurations().extended({**by_name, **builtin()})


def _folder(source: Source) -> Path:
    return source.path.resolve().parent


def _importable(source: Source, skills: Configurations) -> Importable:
    """The modules that Python can import; a library is `learnblock.libraries.NAME` there."""
    importable = installed_libraries.importable(_folder(source), source.imports)
    plain = source.imports - source.libraries
    packages = {module for module in plain if find_spec(module.partition(".")[0]) is not None}
    functions = _functions(source, skills)
    return Importable(importable.libraries - plain, importable.files | packages, functions)


def _functions(source: Source, skills: Configurations) -> dict[str, BlockConfiguration]:
    """The functions of imported files that need something of the robot."""
    return installed_libraries.functions_beside(_folder(source), imports_of(source.tree), skills)
