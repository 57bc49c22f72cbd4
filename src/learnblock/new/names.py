"""The names of new robots and skills: they become names of files, modules and functions."""

import keyword
import re
from pathlib import Path

from learnblock.blocks.known import all_configurations
from learnblock.blocks.reserved import RESERVED
from learnblock.errors import NewNameError
from learnblock.robots import entries
from learnblock.storage.files import is_device_name

LONGEST = 40
"""The limit of a name, in characters."""

_ROBOT = re.compile(r"[a-z][a-z0-9]*(-[a-z0-9]+)*")
_FUNCTION = re.compile(r"[a-z][a-z0-9]*(_[a-z0-9]+)*")


def check_robot_name(name: str) -> None:
    """Refuse a name that a new robot cannot have.

    Raises:
        NewNameError: the name is not allowed, or a robot of LearnBlock or a plugin has it.
    """
    module = name.replace("-", "_")
    if not _ROBOT.fullmatch(name) or not _is_free(module):
        example = _slug(name, "-") or "my-robot"
        raise NewNameError("new-bad-robot-name", name=name[:60], most=LONGEST, example=example)
    if name.startswith("sim-"):
        raise NewNameError("new-twin-name", name=name)
    for candidate in (name, f"sim-{name}"):
        entry = entries().get(candidate)
        if entry and entry.path is None:
            raise NewNameError("new-robot-exists", name=candidate)


def check_skill_name(name: str, file: Path) -> None:
    """Refuse a name that a new skill cannot have.

    Args:
        name: the function's name.
        file: the skill's file; if it exists, it may already contain a skill with that name.

    Raises:
        NewNameError: the name is not allowed, or is taken.
    """
    if not _FUNCTION.fullmatch(name) or not _is_free(name):
        example = _slug(name, "_") or "my_skill"
        raise NewNameError("new-bad-skill-name", name=name[:60], most=LONGEST, example=example)
    if name in RESERVED or (name in all_configurations() and not file.exists()):
        raise NewNameError("new-skill-exists", name=name)


def _is_free(module: str) -> bool:
    """Whether the name is short enough, and not used by Python or a file system."""
    reserved = keyword.iskeyword(module) or is_device_name(module)
    return len(module) <= LONGEST and not reserved


def _slug(name: str, joint: str) -> str:
    """A valid name that is similar to `name`, or ""."""
    words = re.findall(r"[a-z0-9]+", name.lower())
    slug = joint.join(words)[:LONGEST].strip(joint)
    return "" if not slug or slug[0].isdigit() or not _is_free(slug) else slug
