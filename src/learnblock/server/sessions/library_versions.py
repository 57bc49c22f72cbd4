"""Which versions of libraries a project was made with, and which are installed."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace

from learnblock import library
from learnblock.language.imports import imported
from learnblock.language.nodes import Program
from learnblock.library import order


@dataclass(frozen=True)
class LibraryVersions:
    """Versions by the name of the library.

    Args:
        made_with: as the project remembers.
        installed: as they are now.
    """

    made_with: Mapping[str, str]
    installed: Mapping[str, str] = field(default_factory=library.versions)

    def renewed(self) -> "LibraryVersions":
        """With what is installed by now."""
        return replace(self, installed=library.versions())

    def used(self, program: Program) -> dict[str, str]:
        """Those that a program is made with now; of a library that is gone, the last."""
        known = {**self.made_with, **self.installed}
        return {name: known[name] for name in sorted(imported(program)) if name in known}

    def remarks(self) -> Iterator[str]:
        """What somebody should know who opens the project."""
        for name, version in self.made_with.items():
            there = self.installed.get(name)
            if there is None:
                yield (
                    f"this program was made with version {version} of the library {name}, which is"
                    " not installed: import it"
                )
            elif order(there) < order(version):
                yield (
                    f"this program was made with version {version} of the library {name}, and"
                    f" {there} is installed: import the newer one"
                )
