"""The program of another pupil, which drives a robot of this project."""

from dataclasses import dataclass

from learnblock.i18n import Phrase
from learnblock.project.document.document import Document
from learnblock.runtime.program import Program


@dataclass(frozen=True)
class GuestProgram:
    """A guest's program; pages show the robot's own instead, so no line or block is marked.

    Args:
        document: the program, without errors.
    """

    document: Document

    def program(self, name: str) -> Program:
        """The program to run."""
        return self.document.program(name)

    def block_at(self, python_line: int) -> None:
        """Return None, because no page of this project shows the block."""
        del python_line

    def python_line(self, block: str) -> None:
        """Return None: the project's breakpoints are in another program."""
        del block

    def lacking(self, equipment: frozenset[str]) -> Phrase | None:
        """What a robot lacks for the program."""
        return self.document.lacking(equipment)
