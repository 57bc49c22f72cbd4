"""Functions as skills: in Python they take the robot first, and hand it on to one another."""

from learnblock.language.library import MODULES
from learnblock.language.nodes import Call, Def, Program
from learnblock.language.python_writer import PythonWriter


def to_skills(program: Program, origin: str) -> str:
    """The Python of a program that is nothing but functions and the variables they share.

    Args:
        program: of a library.
        origin: the file that the program stands in.
    """
    writer = _SkillWriter(program, frozenset())
    writer.body_of(list(program.items))
    heading = [f'"""Made from {origin}: change that, and not this file."""']
    imports = [f"import {module}" for module in MODULES if module in writer.modules]
    lines = [*heading, *([""] if imports else []), *imports, *writer.lines]
    return "\n".join([*lines, ""])


class _SkillWriter(PythonWriter):
    def definition(self, node: Def) -> None:
        parameters = ["robot", *map(self.variable, node.parameters)]
        self.function(f"def {self.variable(node.name)}({', '.join(parameters)})", node)

    def call(self, node: Call, level: int) -> str:
        text = super().call(node, level)
        if node.name not in self.functions:
            return text
        name, _, arguments = text.partition("(")
        return f"{name}(robot{'' if arguments == ')' else ', '}{arguments}"
