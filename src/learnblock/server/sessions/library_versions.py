"""The versions of libraries with which a project was made, and the installed ones."""

from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass, field, replace

from learnblock.extensions import libraries
from learnblock.extensions.libraries import order
from learnblock.i18n import Phrase
from learnblock.language.edit.imports import imported
from learnblock.language.tree.nodes import Program


@dataclass(frozen=True)
class LibraryVersions:
    """Versions by the name of the library.

    Args:
        made_with: the versions saved in the project.
        installed: the installed versions.
    """

    made_with: Mapping[str, str]
    installed: Mapping[str, str] = field(default_factory=libraries.versions)

    def renewed(self) -> "LibraryVersions":
        """Return a copy with the versions installed now."""
        return replace(self, installed=libraries.versions())

    def used(self, program: Program) -> dict[str, str]:
        """The versions that a program uses now; for a removed library, the last one."""
        known = {**self.made_with, **self.installed}
        return {name: known[name] for name in sorted(imported(program)) if name in known}

    def remarks(self, offered: Collection[str] = ()) -> Iterator[Phrase]:
        """List the libraries that are missing or older than when the project was made.

        Args:
            offered: the libraries that the project contains, which need no remark.
        """
        for name, version in self.made_with.items():
            if name in offered:
                continue
            there = self.installed.get(name)
            if there is None:
                yield Phrase("project-library-missing", library=name, version=version)
            elif order(there) < order(version):
                yield Phrase(
                    "project-library-older", library=name, version=version, installed=there
                )
