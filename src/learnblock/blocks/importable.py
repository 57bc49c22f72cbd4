"""The modules that a program can import."""

from collections.abc import Mapping
from dataclasses import dataclass, field

from learnblock.blocks.schema.configuration import BlockConfiguration


@dataclass(frozen=True, slots=True)
class Importable:
    """The modules that the ``import`` of a program can name.

    Args:
        libraries: modules with skills and nothing else.
        files: Python files next to the program, with everything that they define.
        functions: those functions of such files that need something of the robot, with their needs,
            as the program writes them: ``follow`` or ``helpers.follow``.
    """

    libraries: frozenset[str] = frozenset()
    files: frozenset[str] = frozenset()
    functions: Mapping[str, BlockConfiguration] = field(default_factory=dict)

    def __contains__(self, name: object) -> bool:
        return name in self.libraries or name in self.files

    @property
    def names(self) -> tuple[str, ...]:
        """The names of all modules, sorted."""
        return tuple(sorted(self.libraries | self.files))
