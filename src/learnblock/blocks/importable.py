"""The modules that a program can import."""

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Importable:
    """The modules that the ``import`` of a program can name.

    Args:
        libraries: modules with skills and nothing else.
        files: Python files beside the program, with everything that they define.
    """

    libraries: frozenset[str] = frozenset()
    files: frozenset[str] = frozenset()

    def __contains__(self, name: object) -> bool:
        return name in self.libraries or name in self.files

    @property
    def names(self) -> tuple[str, ...]:
        """The names of all modules, sorted."""
        return tuple(sorted(self.libraries | self.files))
