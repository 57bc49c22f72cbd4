"""Trying a function of a custom block: a program of one line below the block's source."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

from learnblock.blocks.source.signature import Signature, signatures
from learnblock.errors import LearnBlockError, UnknownNameError
from learnblock.runtime.program import Program

# Names that a source is unlikely to use; the import represents the chosen robot.
_MAKE = """

from learnblock.robots.sim_ebo import Robot as _Robot

_robot = _Robot()
"""


@dataclass(frozen=True)
class FunctionCall:
    """A call of a function of a custom block.

    Args:
        name: the name of the block's file.
        source: the whole file.
        functions: the names of its functions, which may call each other as skills.
        call: the line that calls the function.
    """

    name: str
    source: str
    functions: tuple[str, ...]
    call: str

    def program(self, name: str) -> Program:
        """The program to run; it begins with the lines of the source."""
        del name
        learns = "".join(f"_robot.learn({function})\n" for function in self.functions)
        python = f"{self.source}{_MAKE}{learns}{self.call}\n"
        return Program(f"{self.name}.py", python, python)

    def block_at(self, python_line: int) -> None:
        """Return None, because no block of the workspace runs."""
        del python_line

    def python_line(self, block: str) -> None:
        """Return None, because it contains no block of the workspace."""
        del block

    def lacking(self, equipment: frozenset[str]) -> None:
        """Return None: the author of the source finds out what it needs."""
        del equipment

    def custom_line(self, python_line: int) -> int:
        """The line of the source; 0 for a line below it."""
        return python_line if python_line <= len(self.source.split("\n")) else 0


def function_call(
    name: str, source: str, function: str, arguments: Sequence[object]
) -> FunctionCall:
    """Create a program that tries a function.

    Args:
        name: the name of the block's file; empty for a block that was never saved.
        source: the whole file.
        function: the name of the function; empty for the first one.
        arguments: the arguments as JSON values in the order of the parameters.

    Raises:
        ProgramError: the source is not valid Python.
        LearnBlockError: there is no such function, or it does not take these arguments.
    """
    functions = {
        signature.name: signature for signature in signatures(source, f"{name or 'block'}.py")
    }
    if not functions:
        raise LearnBlockError("play-no-function")
    chosen = functions.get(function or next(iter(functions)))
    if chosen is None:
        raise UnknownNameError("function", function, functions)
    called = f"_robot.{chosen.name}({', '.join(map(_written, _checked(chosen, arguments)))})"
    call = f"print({called})" if chosen.answers else called
    return FunctionCall(name or "block", source, tuple(functions), call)


def _checked(function: Signature, arguments: Sequence[object]) -> Sequence[object]:
    least = sum(1 for argument in function.arguments if argument.required)
    if not least <= len(arguments) <= len(function.arguments):
        raise LearnBlockError(
            "play-wrong-count",
            function=function.name,
            least=least,
            most=len(function.arguments),
            count=len(arguments),
        )
    return arguments


def _written(value: object) -> str:
    """A JSON value as Python source."""
    if isinstance(value, float) and not math.isfinite(value):
        raise LearnBlockError("play-bad-number", value=str(value))
    if isinstance(value, list):
        return f"[{', '.join(map(_written, value))}]"
    if isinstance(value, dict):
        raise LearnBlockError("play-bad-value")
    return repr(value)
