"""A function of one's own that is tried: a program of one line, below the source as it stands."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

from learnblock.blocks.signature import Signature, signatures
from learnblock.errors import LearnBlockError, UnknownNameError
from learnblock.runtime.program import Program

# The source's own names are most likely none of these; the robot is whichever one is chosen.
_MAKE = """

from learnblock.robots.sim_ebo import Robot as _Robot

_robot = _Robot()
"""


@dataclass(frozen=True)
class Trial:
    """A function that is tried.

    Args:
        name: of the file that it will stand in.
        source: the whole of it.
        functions: the names of its functions, which may call each other as skills.
        call: the one line.
    """

    name: str
    source: str
    functions: tuple[str, ...]
    call: str

    def program(self, name: str) -> Program:
        """What is run; its lines are those of the source as far as that goes."""
        del name
        learns = "".join(f"_robot.learn({one})\n" for one in self.functions)
        python = f"{self.source}{_MAKE}{learns}{self.call}\n"
        return Program(f"{self.name}.py", python, python)

    def block_at(self, python_line: int) -> None:
        """No block of the workspace runs."""
        del python_line

    def python_line(self, block: str) -> None:
        """No block of the workspace holds it."""
        del block

    def own_line(self, python_line: int) -> int:
        """The line of the source; 0 for one that is not in it."""
        return python_line if python_line <= len(self.source.split("\n")) else 0


def trial(name: str, source: str, function: str, arguments: Sequence[object]) -> Trial:
    """Try a function.

    Args:
        name: of the file; empty where it has none yet.
        source: the whole of it.
        function: which one; empty for the first.
        arguments: values of JSON, in the order of its parameters.

    Raises:
        ProgramError: the source is no Python.
        LearnBlockError: there is no such function, or it cannot be called so.
    """
    known = {one.name: one for one in signatures(source, f"{name or 'block'}.py")}
    if not known:
        raise LearnBlockError("there is no function in it that takes the robot: write one first")
    chosen = known.get(function or next(iter(known)))
    if chosen is None:
        raise UnknownNameError("function", function, known)
    called = f"_robot.{chosen.name}({', '.join(map(_written, _checked(chosen, arguments)))})"
    call = f"print({called})" if chosen.answers else called
    return Trial(name or "block", source, tuple(known), call)


def _checked(function: Signature, arguments: Sequence[object]) -> Sequence[object]:
    least = sum(1 for one in function.arguments if one.required)
    if not least <= len(arguments) <= len(function.arguments):
        raise LearnBlockError(
            f"`{function.name}` takes {least} to {len(function.arguments)} values, not"
            f" {len(arguments)}"
        )
    return arguments


def _written(value: object) -> str:
    """A value of JSON as Python writes it."""
    if isinstance(value, float) and not math.isfinite(value):
        raise LearnBlockError(f"{value} is no number that a block can give")
    if isinstance(value, list):
        return f"[{', '.join(map(_written, value))}]"
    if isinstance(value, dict):
        raise LearnBlockError("a block gives numbers, texts, truth values and lists")
    return repr(value)
