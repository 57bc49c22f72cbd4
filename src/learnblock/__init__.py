"""LearnBlock: one program in blocks, Block-Text and Python, for any robot.

The public names of the package. To use a robot from Python:

    >>> import learnblock
    >>> robot = learnblock.connect("sim-ebo", world="empty")
    >>> robot.move_straight()
    >>> robot.sleep(1)
    >>> robot.stop()

and to convert a program from one notation to another:

    >>> program = learnblock.parse("function.move_straight()")
    >>> print(learnblock.to_python(program, "learnblock.robots.sim_ebo").text)
    from learnblock.robots.sim_ebo import Robot
    <BLANKLINE>
    robot = Robot()
    <BLANKLINE>
    robot.move_straight()
    <BLANKLINE>
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from learnblock.client import Client
    from learnblock.devices import Emotion
    from learnblock.errors import Diagnostic, LearnBlockError, ProgramError
    from learnblock.language import check, format, from_python, parse, to_python  # noqa: A004
    from learnblock.robots import connect

# Imported on first use: the child process of a program needs none of the language, and
# `learnblock --help` nothing at all.
_HOME = {
    "Client": "client",
    "Diagnostic": "errors",
    "Emotion": "devices",
    "LearnBlockError": "errors",
    "ProgramError": "errors",
    "check": "language",
    "connect": "robots",
    "format": "language",
    "from_python": "language",
    "parse": "language",
    "to_python": "language",
}


def __getattr__(name: str) -> Any:
    if name not in _HOME:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"{__name__}.{_HOME[name]}"), name)


def __dir__() -> list[str]:
    return sorted(__all__)


__all__ = [
    "Client",
    "Diagnostic",
    "Emotion",
    "LearnBlockError",
    "ProgramError",
    "check",
    "connect",
    "format",
    "from_python",
    "parse",
    "to_python",
]
