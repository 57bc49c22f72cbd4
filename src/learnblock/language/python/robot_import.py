"""Recognize the import of a program's robot: the only line that differs between robots.

``from gpiozero import Robot`` and ``from .parts import Robot`` import something else.
"""

import ast
import re

from learnblock.storage.installed import entry_points

#: The packages of the built-in robots and of those in the user's folder.
_PACKAGES = ("learnblock.robots.", "learnblock_home.robots.")
_IMPORT = re.compile(r"^from[ \t]+([\w.]+)[ \t]+import[ \t]+Robot\b", re.MULTILINE)


def is_robot_module(module: str) -> bool:
    """Whether a module has a robot: a built-in one, the user's, or one of an installed package."""
    return module.startswith(_PACKAGES) or any(
        point.module == module for point in entry_points("learnblock.robots")
    )


def imports_robot(node: ast.AST) -> bool:
    """Whether a statement is ``from learnblock.robots.sim_ebo import Robot``, of any robot."""
    match node:
        case ast.ImportFrom(
            module=str(module), names=[ast.alias(name="Robot", asname=None)], level=0
        ):
            return is_robot_module(module)
    return False


def robot_import(text: str) -> re.Match[str] | None:
    """The place where a program imports its robot; group 1 is the module."""
    return next((match for match in _IMPORT.finditer(text) if is_robot_module(match[1])), None)


def with_robot(text: str, module: str) -> str:
    """A program that imports its robot from `module`."""
    match = robot_import(text)
    return text if match is None else text[: match.start(1)] + module + text[match.end(1) :]


def for_any_robot(text: str) -> str:
    """A program with the same import of a robot whatever its robot is."""
    return _IMPORT.sub(
        lambda match: "from robot import Robot" if is_robot_module(match[1]) else match[0], text
    )
