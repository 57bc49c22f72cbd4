"""Names of a library's skills that are already taken."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from learnblock.blocks import builtin
from learnblock.blocks.installed_libraries import installed_blocks
from learnblock.blocks.known import all_configurations
from learnblock.blocks.reserved import RESERVED
from learnblock.errors import Diagnostic, LibraryError
from learnblock.extensions.libraries.contents import Library
from learnblock.extensions.libraries.making import own_skills
from learnblock.i18n import Phrase


@dataclass(frozen=True, slots=True)
class Clash:
    """A name that two skills have.

    Args:
        skill: the name.
        library: the library that is to be installed.
        place: where the other skill is, such as ``the library songs``.
    """

    skill: str
    library: str
    place: Phrase

    @property
    def phrase(self) -> Phrase:
        """The message about the clash."""
        return Phrase("library-clash", skill=self.skill, library=self.library, place=self.place)


def clashes(libraries: Iterable[Library]) -> tuple[Clash, ...]:
    """The taken names in libraries that are to be installed together."""
    libraries = tuple(libraries)
    places = {**_others({library.name for library in libraries})}
    name_clashes: list[Clash] = []
    for library in libraries:
        name_clashes += [
            Clash(name, library.name, places[name]) for name in library.skills if name in places
        ]
        for name in library.skills:
            places.setdefault(name, Phrase("library-place-library", library=library.name))
    return tuple(name_clashes)


def refuse_clashes(libraries: Iterable[Library]) -> None:
    """Refuse libraries whose skills have taken names.

    Raises:
        LibraryError: a name is taken; the error lists every clash.
    """
    name_clashes = clashes(libraries)
    if name_clashes:
        problems = [Diagnostic("name-clash", clash.phrase) for clash in name_clashes]
        raise LibraryError(name_clashes[0].library, problems)


def _others(coming: Iterable[str]) -> Mapping[str, Phrase]:
    """The taken names and where they are, except those of the libraries to be installed."""
    places = {
        name: Phrase("library-place-plugin")
        for name, configuration in all_configurations().items()
        if not configuration.library
    }
    places |= {
        block.name: Phrase("library-place-library", library=block.library)
        for block in installed_blocks()
        if block.library not in coming
    }
    places |= {
        skill: Phrase("library-place-block", block=stem)
        for stem, skills in own_skills().items()
        for skill in skills
    }
    places |= dict.fromkeys(builtin(), Phrase("library-place-learnblock"))
    return places | dict.fromkeys(RESERVED, Phrase("library-place-robot"))
