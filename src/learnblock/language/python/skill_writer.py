"""Write functions as skills: in Python they take the robot first and pass it to each other."""

from learnblock.language.python.writer import PythonWriter
from learnblock.language.tree.builtins import MODULES
from learnblock.language.tree.nodes import Call, Def, Program


def to_skills(program: Program, origin: str) -> str:
    """The Python of a program that consists of functions and the variables that they share.

    Args:
        program: the program of a library.
        origin: the file of the program.
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
