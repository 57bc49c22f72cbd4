"""Which names a library cannot give to its skills here, since somebody else has them."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from learnblock.blocks import builtin
from learnblock.blocks.known import known
from learnblock.blocks.libraries import installed_blocks
from learnblock.blocks.reserved import RESERVED
from learnblock.errors import Diagnostic, LibraryError
from learnblock.library.contents import Library
from learnblock.library.making import own_skills


@dataclass(frozen=True, slots=True)
class Clash:
    """A name that two have.

    Args:
        skill: the name.
        library: the library that would have it.
        place: who has it already, such as ``the library songs``.
    """

    skill: str
    library: str
    place: str

    @property
    def sentence(self) -> str:
        """What is wrong, and what to do."""
        return (
            f"`{self.skill}` of the library {self.library} is the name of a skill of {self.place}"
            f" already: give it another name with --rename {self.skill}=NEW"
        )


def clashes(libraries: Iterable[Library]) -> tuple[Clash, ...]:
    """The names of libraries that are to be installed together and that somebody else has."""
    libraries = tuple(libraries)
    taken = {**_others({one.name for one in libraries})}
    found: list[Clash] = []
    for library in libraries:
        found += [
            Clash(name, library.name, taken[name]) for name in library.skills if name in taken
        ]
        for name in library.skills:
            taken.setdefault(name, f"the library {library.name}")
    return tuple(found)


def refuse_clashes(libraries: Iterable[Library]) -> None:
    """Refuse libraries whose skills cannot be told from others.

    Raises:
        LibraryError: with every clash.
    """
    found = clashes(libraries)
    if found:
        problems = [Diagnostic("name-clash", one.sentence) for one in found]
        raise LibraryError(found[0].library, problems)


def _others(coming: Iterable[str]) -> Mapping[str, str]:
    """Who has which name, but for the libraries that come anew."""
    found = {name: "a plugin" for name, one in known().items() if not one.library}
    found |= {
        one.name: f"the library {one.library}"
        for one in installed_blocks()
        if one.library not in coming
    }
    found |= {
        skill: f"your own blocks in {stem}.py"
        for stem, skills in own_skills().items()
        for skill in skills
    }
    found |= dict.fromkeys(builtin(), "LearnBlock's own")
    return found | dict.fromkeys(RESERVED, "every robot's own")
