"""The robots: one module for each, with a class ``Robot(Client)``.

A robot has an id and a module: ``sim-ebo`` is `learnblock.robots.sim_ebo`. Third-party robots come
from entry points of the group ``learnblock.robots`` (id = module) and from the ``robots`` folder of
`learnblock.storage.home`, one file each, and are used like ours.
"""

import importlib
import os
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import Any

from learnblock.client import Client
from learnblock.errors import LearnBlockError, UnknownNameError
from learnblock.storage import installed
from learnblock.storage.home import home, import_file

_OURS = (
    "sim-ebo",
    "sim-thymio",
    "sim-ev3",
    "sim-cozmo",
    "sim-spike",
    "sim-legoed",
    "sim-root",
    "sim-create3",
    "coppeliasim",
    "cozmo",
    "create3",
    "ebo",
    "ev3",
    "legoed",
    "rcis",
    "root",
    "spike",
    "thymio",
)


@dataclass(frozen=True, slots=True)
class RobotEntry:
    """A robot that can be chosen.

    Args:
        name: its id, such as ``sim-ebo``.
        module: the module with its class ``Robot``, as a program imports it.
        path: the module's file, if it is in the user's folder.
        simulated: whether it belongs to the embedded simulator; None if that is known only after
            loading it.
    """

    name: str
    module: str
    path: Path | None = None
    simulated: bool | None = None

    def load(self) -> type[Client]:
        """Import the robot's class.

        Raises:
            LearnBlockError: the module cannot be imported or has no such class.
        """
        module = _import(self)
        robot = getattr(module, "Robot", None)
        if not (isinstance(robot, type) and issubclass(robot, Client)):
            raise LearnBlockError("robot-no-class", module=self.module)
        return robot


def entries() -> dict[str, RobotEntry]:
    """All robots by name; a built-in robot wins over others with the same name.

    With ``LEARNBLOCK_ROBOTS=simulated``, as in a class, only our simulated ones.
    """
    ours = {name: _our_own(name) for name in _OURS}
    if _only_simulated():
        return {name: entry for name, entry in ours.items() if entry.simulated}
    return {**_users(), **_plugins(), **ours}


def is_built_in(name: str) -> bool:
    """Whether the robot with this name comes with LearnBlock."""
    return name in _OURS


def built_in() -> tuple[str, ...]:
    """The names of LearnBlock's own robots."""
    return _OURS


def find(name: str) -> RobotEntry:
    """The robot with this name or module.

    Raises:
        UnknownNameError: there is no such robot.
    """
    if name in _OURS and not _only_simulated():
        return _our_own(name)
    robots = entries()
    for entry in robots.values():
        if name in (entry.name, entry.module):
            return entry
    raise UnknownNameError("robot", name, robots)


def connect(name: str, **arguments: Any) -> Client:
    """Connect to a robot; the arguments are passed to its class.

    Raises:
        UnknownNameError: there is no such robot.
        RobotConnectionError: it cannot be reached.
    """
    return find(name).load()(**arguments)


def module_of(name: str) -> str:
    """The module that a program for this robot imports.

    Raises:
        UnknownNameError: there is no such robot.
    """
    return find(name).module


def module_name(name: str) -> str:
    """The module of a built-in robot."""
    return "learnblock.robots." + name.replace("-", "_")


def _only_simulated() -> bool:
    return os.environ.get("LEARNBLOCK_ROBOTS") == "simulated"


def _our_own(name: str) -> RobotEntry:
    return RobotEntry(name, module_name(name), simulated=name.startswith("sim-"))


def _plugins() -> dict[str, RobotEntry]:
    points = installed.entry_points("learnblock.robots")
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
        # The module may be a user's or a plugin's code, which can raise any error.
        raise LearnBlockError(
            "robot-not-loaded", name=entry.name, reason=f"{type(error).__name__}: {error}"
        ) from error
