"""The names of new things: they become file names, modules and words of programs."""

import keyword
import re
from pathlib import Path

from learnblock.blocks import all_configurations
from learnblock.blocks.reserved import RESERVED
from learnblock.errors import NewNameError
from learnblock.files import is_device_name
from learnblock.robots import entries

LONGEST = 40
"""Characters of a name."""

_ROBOT = re.compile(r"[a-z][a-z0-9]*(-[a-z0-9]+)*")
_FUNCTION = re.compile(r"[a-z][a-z0-9]*(_[a-z0-9]+)*")


def check_robot_name(name: str) -> None:
    """Refuse what cannot be the name of a robot of one's own.

    Raises:
        NewNameError: it is no such name, or that of a robot that comes with LearnBlock or a plugin.
    """
    module = name.replace("-", "_")
    if not _ROBOT.fullmatch(name) or not _is_free(module):
        example = _slug(name, "-") or "my-robot"
        raise NewNameError(
            f"a robot cannot be called {name!r:.60}: use up to {LONGEST} small letters, digits and"
            f" `-`, such as `{example}`"
        )
    if name.startswith("sim-"):
        raise NewNameError(f"{name!r} is the name of a twin: leave out `sim-`, it is made as well")
    for taken in (name, f"sim-{name}"):
        entry = entries().get(taken)
        if entry and entry.path is None:
            raise NewNameError(f"there is a robot `{taken}` already: choose another name")


def check_skill_name(name: str, file: Path) -> None:
    """Refuse what cannot be the name of a skill of one's own.

    Args:
        name: of the function.
        file: that it will stand in; one that is there may hold the skill of that name.

    Raises:
        NewNameError: it is no such name, or is taken.
    """
    if not _FUNCTION.fullmatch(name) or not _is_free(name):
        example = _slug(name, "_") or "my_skill"
        raise NewNameError(
            f"a skill cannot be called {name!r:.60}: use up to {LONGEST} small letters, digits and"
            f" `_`, such as `{example}`"
        )
    if name in RESERVED or (name in all_configurations() and not file.exists()):
        raise NewNameError(f"every robot has a `{name}` already: choose another name")


def _is_free(module: str) -> bool:
    """Whether neither Python nor a file system uses the name itself."""
    reserved = keyword.iskeyword(module) or is_device_name(module)
    return len(module) <= LONGEST and not reserved


def _slug(name: str, joint: str) -> str:
    """The nearest thing to `name` that may be one, or ""."""
    words = re.findall(r"[a-z0-9]+", name.lower())
    slug = joint.join(words)[:LONGEST].strip(joint)
    return "" if not slug or slug[0].isdigit() or not _is_free(slug) else slug
