"""Layer 3 of the robot side: one module per robot, each with a class ``Robot(Client)``.

A robot has an id and a module: ``sim-ebo`` is `learnblock.robots.sim_ebo`. Robots of others come
from entry points of the group ``learnblock.robots`` (id = module) and from the ``robots`` folder of
`learnblock.home`, a file each, and are used like ours.
"""

import importlib
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import Any

from learnblock.client import Client
from learnblock.errors import LearnBlockError, UnknownNameError
from learnblock.home import home, import_file

_OURS = (
    "sim-ebo",
    "sim-thymio",
    "sim-ev3",
    "sim-cozmo",
    "coppeliasim",
    "cozmo",
    "ebo",
    "ev3",
    "rcis",
    "thymio",
)


@dataclass(frozen=True, slots=True)
class RobotEntry:
    """A robot that can be chosen.

    Args:
        name: its id, such as ``sim-ebo``.
        module: the module that holds its class ``Robot``, as a program imports it.
        path: the module's file where it lies in the user's own folder.
        simulated: whether it lives in the embedded simulator; None where only loading it would
            tell.
    """

    name: str
    module: str
    path: Path | None = None
    simulated: bool | None = None

    def load(self) -> type[Client]:
        """Its class.

        Raises:
            LearnBlockError: the module cannot be imported or has no such class.
        """
        module = _import(self)
        robot = getattr(module, "Robot", None)
        if not (isinstance(robot, type) and issubclass(robot, Client)):
            raise LearnBlockError(f"{self.module} has no class `Robot` that derives from `Client`")
        return robot


def entries() -> dict[str, RobotEntry]:
    """The robots there are, by name; ours come first where two share one."""
    ours = {name: _our_own(name) for name in _OURS}
    return {**_users(), **_plugins(), **ours}


def find(name: str) -> RobotEntry:
    """The robot of that name, or of that module.

    Raises:
        UnknownNameError: there is none.
    """
    if name in _OURS:
        return _our_own(name)
    known = entries()
    for entry in known.values():
        if name in (entry.name, entry.module):
            return entry
    raise UnknownNameError("robot", name, known)


def connect(name: str, **arguments: Any) -> Client:
    """The robot of that name, connected; the arguments are those of its class.

    Raises:
        UnknownNameError: there is no such robot.
        RobotConnectionError: it cannot be reached.
    """
    return find(name).load()(**arguments)


def module_of(name: str) -> str:
    """The module that a program for the robot of that name imports.

    Raises:
        UnknownNameError: no robot has that name.
    """
    return find(name).module


def module_name(name: str) -> str:
    """The module of one of our own robots."""
    return "learnblock.robots." + name.replace("-", "_")


def _our_own(name: str) -> RobotEntry:
    return RobotEntry(name, module_name(name), simulated=name.startswith("sim-"))


def _plugins() -> dict[str, RobotEntry]:
    from importlib.metadata import entry_points  # noqa: PLC0415 - it searches all that is installed

    points = entry_points(group="learnblock.robots")
    return {point.name: RobotEntry(point.name, point.module) for point in points}


def _users() -> dict[str, RobotEntry]:
    return {
        path.stem.replace("_", "-"): RobotEntry(
            path.stem.replace("_", "-"), f"learnblock_home.robots.{path.stem}", path
        )
        for path in sorted((home() / "robots").glob("[!_]*.py"))
    }


def _import(entry: RobotEntry) -> ModuleType:
    try:
        if entry.path:
            return import_file(entry.path)
        return importlib.import_module(entry.module)
    except LearnBlockError:
        raise
    except Exception as error:
        # A robot's module is someone else's code: it may raise whatever it likes.
        raise LearnBlockError(f"the robot `{entry.name}` cannot be loaded: {error}") from error
