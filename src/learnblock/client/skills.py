"""Robot-agnostic skills: plain functions that take the robot first.

`find` collects the built-in skills, those of the libraries that the program has imported, those in
the ``skills`` folder of `home`, and those of installed plugins (entry points of the group
``learnblock.skills``, each naming a module).
"""

import importlib
import inspect
import sys
from collections.abc import Callable, Collection, Iterator
from pathlib import Path
from types import ModuleType
from typing import Any

from learnblock.errors import LearnBlockError
from learnblock.storage import skill_files
from learnblock.storage.home import import_file

Skill = Callable[..., Any]

# The most common ones come first, so that a program that lists its skills loads only what it needs.
_MODULES = (
    "base",
    "driving",
    "others",
    "pose",
    "motor",
    "camera",
    "faces",
    "objects",
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
    "pen",
    "screen",
    "cozmo",
    "messages",
    "keyboard",
    "game",
    "handling",
    "music",
)
#: How many of these nearly every program uses.
_COMMON = 2
_OWN_PACKAGE = "learnblock.skills."
#: The prefix of the modules that Block-Text imports.
_LIBRARIES = "learnblock.libraries."


def prepare() -> None:
    """Load the skills of nearly every program, before it is known."""
    for name in _MODULES[:_COMMON]:
        importlib.import_module(_OWN_PACKAGE + name)


def find(names: Collection[str] | None = None) -> dict[str, Skill]:
    """The skills with these names, or all skills.

    If several skills have the same name, the first wins, in this order: built-in skills, those of
    imported libraries, the user's, those of plugins. Unknown names are left out, since the program
    may never call them.

    A user's file runs only when one of its skills is first called, so a mistake in it does
    not affect other programs.
    """
    skills: dict[str, Skill] = {}
    for search in (_ours, _imported, _users, _plugins):
        missing = None if names is None else set(names) - skills.keys()
        skills = search(missing) | skills
    return skills


def _of_modules(modules: Iterator[ModuleType], names: Collection[str] | None) -> dict[str, Skill]:
    """The skills in modules; stops importing once all names are found."""
    matches: dict[str, Skill] = {}
    while names is None or not matches.keys() >= set(names):
        module = next(modules, None)
        if module is None:
            break
        skills = _skills_of(module)
        matches = {
            name: skill for name, skill in skills if names is None or name in names
        } | matches
    return matches


def functions(module: ModuleType) -> Iterator[tuple[str, Skill]]:
    """The skills of a module: the public functions that it defines."""
    for name, value in vars(module).items():
        if (
            not name.startswith("_")
            and inspect.isfunction(value)
            and value.__module__ == module.__name__
        ):
            yield name, value


def _skills_of(module: ModuleType) -> Iterator[tuple[str, Skill]]:
    """The skills of a module; in a library, only the functions whose first parameter is `robot`."""
    candidates = functions(module)
    if not module.__name__.startswith(_LIBRARIES):
        return candidates
    return ((name, skill) for name, skill in candidates if _takes_robot(skill))


def _takes_robot(function: Skill) -> bool:
    return inspect.getfullargspec(function).args[:1] == ["robot"]


def _ours(names: Collection[str] | None) -> dict[str, Skill]:
    return _of_modules((importlib.import_module(_OWN_PACKAGE + name) for name in _MODULES), names)


def _imported(names: Collection[str] | None) -> dict[str, Skill]:
    # Other threads of a server import modules meanwhile. `copy` is atomic; `tuple(items())` is not,
    # because it allocates, which may collect garbage and let another thread run.
    modules = sys.modules.copy()
    loaded = [module for name, module in modules.items() if name.startswith(_LIBRARIES)]
    return _of_modules(iter(loaded), names)


def _plugins(names: Collection[str] | None) -> dict[str, Skill]:
    if names is not None and not names:
        return {}
    return _of_modules((point.load() for point in skill_files.plugins()), names)


def _users(names: Collection[str] | None) -> dict[str, Skill]:
    skills: dict[str, Skill] = {}
    for path in skill_files.own_files() if names is None or names else ():
        for name in skill_files.names(path):
            if names is None or name in names:
                skills.setdefault(name, _later(path, name))
    return skills


def _later(path: Path, name: str) -> Skill:
    """A skill whose file is imported at the first call."""

    def skill(robot: Any, *args: Any, **kwargs: Any) -> Any:
        return _loaded(path, name)(robot, *args, **kwargs)

    skill.__name__ = skill.__qualname__ = name
    definition = skill_files.definition(path, name)
    if definition is not None:
        from learnblock.client.signatures import describe  # noqa: PLC0415 - most have no own skills

        describe(skill, definition)
    return skill


def _loaded(path: Path, name: str) -> Skill:
    function = getattr(load(path), name, None)
    if not inspect.isfunction(function):
        raise LearnBlockError("skill-not-function", file=_short(path), name=name)
    return function


def load(path: Path) -> ModuleType:
    """Import a file of skills.

    Raises:
        LearnBlockError: the file cannot be imported; the original error is the cause.
    """
    try:
        return import_file(path)
    except SyntaxError as error:
        raise LearnBlockError(
            "skill-file-syntax", file=_short(path), line=error.lineno or 0, reason=error.msg
        ) from error
    except (Exception, SystemExit) as error:
        raise LearnBlockError(
            "skill-file-broken", file=_short(path), reason=_described(error)
        ) from error


def _short(path: Path) -> str:
    """The folder and name of a user's file; the traceback shows its whole path."""
    return f"{path.parent.name}/{path.name}"


def _described(error: BaseException) -> str:
    return f"{type(error).__name__}: {error}" if str(error) else type(error).__name__
