"""What the ``import`` of a program can name."""

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Importable:
    """What the ``import`` of a program can name.

    Args:
        libraries: these bring skills and nothing else.
        files: Python files beside the program, which bring whatever they define.
    """

    libraries: frozenset[str] = frozenset()
    files: frozenset[str] = frozenset()

    def __contains__(self, name: object) -> bool:
        return name in self.libraries or name in self.files

    @property
    def names(self) -> tuple[str, ...]:
        """All of them, in order."""
        return tuple(sorted(self.libraries | self.files))
