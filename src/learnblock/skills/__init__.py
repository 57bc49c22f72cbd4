"""Robot-agnostic skills: plain functions that take the robot first.

`find` collects them: ours, those of installed plugins (entry points of the group
``learnblock.skills``, each naming a module), and those in the ``skills`` folder of `home`.
"""

import importlib
import inspect
from collections.abc import Callable, Collection, Iterator
from pathlib import Path
from types import ModuleType
from typing import Any

from learnblock.errors import LearnBlockError
from learnblock.home import home, import_file

Skill = Callable[..., Any]

# Those that most programs use come first, since a program that names its skills loads no more.
_MODULES = (
    "base",
    "others",
    "pose",
    "motor",
    "camera",
    "distances",
    "ground",
    "light",
    "infrared",
    "controller",
    "emotion",
    "speaker",
    "led",
    "matrix",
    "mp3",
    "cozmo",
)


def find(names: Collection[str] | None = None) -> dict[str, Skill]:
    """The skills of these names, or all there are.

    Ours come first, then the user's, then those of plugins: another skill of the same name is not
    reached. A name that no skill has is left out, since the program may never call it.
    """
    found: dict[str, Skill] = {}
    for modules in (_ours, _users, _plugins):
        missing = None if names is None else set(names) - found.keys()
        found = _of_modules(modules(), missing) | found
    return found


def _of_modules(modules: Iterator[ModuleType], names: Collection[str] | None) -> dict[str, Skill]:
    """The skills in modules; none is imported any more once all names are found."""
    found: dict[str, Skill] = {}
    while names is None or not found.keys() >= set(names):
        module = next(modules, None)
        if module is None:
            break
        skills = functions(module)
        found = {name: skill for name, skill in skills if names is None or name in names} | found
    return found


def functions(module: ModuleType) -> Iterator[tuple[str, Skill]]:
    """The skills of a module: its own public functions."""
    for name, value in vars(module).items():
        if (
            not name.startswith("_")
            and inspect.isfunction(value)
            and value.__module__ == module.__name__
        ):
            yield name, value


def _ours() -> Iterator[ModuleType]:
    for name in _MODULES:
        yield importlib.import_module(f"{__name__}.{name}")


def _plugins() -> Iterator[ModuleType]:
    from importlib.metadata import entry_points  # noqa: PLC0415 - it searches all that is installed

    for point in entry_points(group="learnblock.skills"):
        yield point.load()


def _users() -> Iterator[ModuleType]:
    for path in sorted((home() / "skills").glob("*.py")):
        yield load(path)


def load(path: Path) -> ModuleType:
    """Import a file of skills.

    Raises:
        LearnBlockError: the file cannot be imported; its own error is the cause.
    """
    try:
        return import_file(path)
    except Exception as error:
        raise LearnBlockError(f"{path}: the skills in it cannot be loaded: {error}") from error
