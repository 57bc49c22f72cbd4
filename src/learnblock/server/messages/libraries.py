"""What is said of libraries."""

from typing import Annotated

from msgspec import Meta, Struct, field

from learnblock.server.messages.base import (
    LONGEST_TEXT,
    Message,
    Name,
    ShortText,
)

#: That are imported at once.
MOST_LIBRARIES = 20
#: Of a library, or that are made one.
MOST_SKILLS = 200

# The page speaks.


class LibraryFile(Struct, frozen=True, omit_defaults=True):
    """A library in one file.

    Args:
        filename: as the user calls it.
        content: its bytes, in base 64.
        renames: other names for skills of it.
    """

    filename: Name
    content: Annotated[bytes, Meta(max_length=LONGEST_TEXT)]
    renames: Annotated[dict[ShortText, ShortText], Meta(max_length=MOST_SKILLS)] = {}


class ListLibraries(Message, frozen=True):
    """Ask which libraries are installed: `Libraries`."""


class ListExportable(Message, frozen=True):
    """Ask what a library could be made of: `Exportable`."""


class ReadLibraries(Message, frozen=True):
    """Ask what is in files, and what keeps them from being imported: `LibrariesRead`."""

    files: Annotated[tuple[LibraryFile, ...], Meta(max_length=MOST_LIBRARIES)]


class ImportLibraries(Message, frozen=True):
    """Install libraries, all or none; `replace` versions that are as new. Then `Libraries`."""

    files: Annotated[tuple[LibraryFile, ...], Meta(max_length=MOST_LIBRARIES)]
    replace: bool = False


class RemoveLibrary(Message, frozen=True):
    """Take an installed library away: all pages hear `Libraries`."""

    name: Name


class DownloadLibrary(Message, frozen=True):
    """Ask for an installed library in one file: `LibraryMade`."""

    name: Name


class MakeLibrary(Message, frozen=True):
    """Ask for a library of functions of the program and blocks of one's own: `LibraryMade`.

    Args:
        name: by which programs import it.
        version: one to three numbers.
        title: the tab of the palette by language code.
        functions: those that they call come along.
        own: files of blocks of one's own.
    """

    name: Name
    version: Name
    title: Annotated[dict[ShortText, ShortText], Meta(max_length=20)] = field(default_factory=dict)
    functions: Annotated[tuple[Name, ...], Meta(max_length=MOST_SKILLS)] = ()
    own: Annotated[tuple[Name, ...], Meta(max_length=MOST_SKILLS)] = ()


class UseLibrary(Message, frozen=True):
    """Have the program import an installed library."""

    name: Name


# The server speaks.


class InstalledLibrary(Struct, frozen=True, omit_defaults=True):
    """A library that is installed.

    Args:
        name: by which programs import it.
        version: of one to three numbers; empty where it cannot be read.
        title: by language code.
        description: what it is for.
        skills: the names of its skills.
        problem: why it cannot be used.
    """

    name: str
    version: str = ""
    title: dict[str, str] = {}
    description: str = ""
    skills: tuple[str, ...] = ()
    problem: str = ""


class Libraries(Message, frozen=True):
    """The libraries that are installed; all pages hear it whenever one has changed."""

    libraries: tuple[InstalledLibrary, ...]


class SkillClash(Struct, frozen=True):
    """A skill of a library whose name somebody has; `place` says who."""

    skill: str
    place: str


class LibraryRead(Struct, frozen=True, omit_defaults=True):
    """What is in a file.

    Args:
        filename: as it was sent.
        library: what it would be; None where it is none.
        installed: the version that is installed; empty for none.
        is_newer: than that one.
        clashes: names that somebody has already.
        problem: why it cannot be imported at all, or a new name cannot be given.
    """

    filename: str
    library: InstalledLibrary | None = None
    installed: str = ""
    is_newer: bool = True
    clashes: tuple[SkillClash, ...] = ()
    problem: str = ""


class LibrariesRead(Message, frozen=True):
    """What is in files, in the order in which they were sent; nothing of them was run."""

    files: tuple[LibraryRead, ...]


class ExportableFunction(Struct, frozen=True, omit_defaults=True):
    """A function of the program.

    Args:
        name: of the function.
        parameters: their names.
        takes_along: the functions that it calls.
        problem: why it cannot be part of a library.
    """

    name: str
    parameters: tuple[str, ...]
    takes_along: tuple[str, ...] = ()
    problem: str = ""


class ExportableBlocks(Struct, frozen=True):
    """A file of blocks of the user's own, and the names of these."""

    name: str
    blocks: tuple[str, ...]


class Exportable(Message, frozen=True):
    """What a library could be made of."""

    functions: tuple[ExportableFunction, ...]
    own: tuple[ExportableBlocks, ...]


class LibraryMade(Message, frozen=True):
    """A library in one file, in base 64."""

    filename: str
    content: bytes
