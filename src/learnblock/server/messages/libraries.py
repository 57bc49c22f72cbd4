"""Messages about libraries."""

from typing import Annotated

from msgspec import Meta, Struct, field

from learnblock.i18n import Phrase
from learnblock.project.document.views import LONGEST_TEXT
from learnblock.server.messages.base import (
    LONGEST_FILE,
    FromReader,
    Look,
    Name,
    Own,
    ShortText,
    ToPage,
)

#: The maximum number of libraries in one import.
MOST_LIBRARIES = 20
#: The maximum number of skills in one library.
MOST_SKILLS = 200

# From the page.


class LibraryFile(Struct, frozen=True, omit_defaults=True):
    """A library in one file.

    Args:
        filename: the user's name for it.
        content: its bytes in base64.
        renames: new names for its skills.
    """

    filename: Name
    content: Annotated[bytes, Meta(max_length=LONGEST_FILE)]
    renames: Annotated[dict[ShortText, ShortText], Meta(max_length=MOST_SKILLS)] = {}


class ListLibraries(Look, frozen=True):
    """Ask which libraries are installed; the reply is `Libraries`."""


class ListExportable(Look, frozen=True):
    """Ask for the functions and blocks that a library can contain; the reply is `Exportable`."""


class ReadLibraries(Look, frozen=True):
    """Ask for the libraries in files, and for their problems; the reply is `LibrariesRead`."""

    files: Annotated[tuple[LibraryFile, ...], Meta(max_length=MOST_LIBRARIES)]


class ImportLibraries(Own, frozen=True):
    """Install all of these libraries or none; `replace` also replaces equally new versions."""

    files: Annotated[tuple[LibraryFile, ...], Meta(max_length=MOST_LIBRARIES)]
    replace: bool = False


class RemoveLibrary(Own, frozen=True):
    """Remove an installed library; every page receives `Libraries`."""

    name: Name


class DownloadLibrary(Look, frozen=True):
    """Ask for an installed library in one file; the reply is `LibraryMade`."""

    name: Name


class MakeLibrary(Own, FromReader, frozen=True):
    """Ask for a library made from program functions and custom blocks; the reply is `LibraryMade`.

    Args:
        name: its name in programs.
        version: its version: one to three numbers.
        title: the name of its palette tab, by language code.
        functions: functions of the program; the functions that they call are added.
        own: the files of custom blocks.
    """

    name: Name
    version: Name
    title: Annotated[dict[ShortText, ShortText], Meta(max_length=20)] = field(default_factory=dict)
    functions: Annotated[tuple[Name, ...], Meta(max_length=MOST_SKILLS)] = ()
    own: Annotated[tuple[Name, ...], Meta(max_length=MOST_SKILLS)] = ()


class ConvertLibrary(Own, FromReader, frozen=True):
    """Ask for a library file made from the files of one of the original LearnBlock.

    The reply is `LibraryConverted`; nothing is installed.

    Args:
        filename: the name of its .lb file.
        content: that file in base64.
        python: its .py file, if it has one.
        configuration: its .conf file, if it has one.
    """

    filename: Name
    content: Annotated[bytes, Meta(max_length=LONGEST_TEXT)]
    python: Annotated[bytes, Meta(max_length=LONGEST_FILE)] | None = None
    configuration: Annotated[bytes, Meta(max_length=LONGEST_TEXT)] | None = None


class UseLibrary(Own, frozen=True):
    """Import an installed library into the program."""

    name: Name


# To the page.


class InstalledLibrary(Struct, frozen=True, omit_defaults=True):
    """A library that is installed.

    Args:
        name: its name in programs.
        version: its version: one to three numbers; empty if it can't be read.
        title: its title, by language code.
        description: its purpose.
        skills: the names of its skills.
        problem: why it can't be used.
    """

    name: str
    version: str = ""
    title: dict[str, str] = {}
    description: str = ""
    skills: tuple[str, ...] = ()
    problem: Phrase | None = None


class Libraries(ToPage, frozen=True):
    """The installed libraries; sent to every page after each change."""

    libraries: tuple[InstalledLibrary, ...]


class SkillClash(Struct, frozen=True):
    """A skill of a library whose name is taken.

    Args:
        skill: its name.
        place: the current owner of this name, such as ``the library songs``.
    """

    skill: str
    place: Phrase


class LibraryRead(Struct, frozen=True, omit_defaults=True):
    """The content of a file.

    Args:
        filename: the name as sent.
        library: the library; None if it can't be read.
        installed: the installed version; empty if there is none.
        is_newer: whether the file is newer than that.
        clashes: skills whose names are taken.
        problem: why it can't be imported, or a new name can't be used.
    """

    filename: str
    library: InstalledLibrary | None = None
    installed: str = ""
    is_newer: bool = True
    clashes: tuple[SkillClash, ...] = ()
    problem: Phrase | None = None


class LibrariesRead(ToPage, frozen=True):
    """The contents of files in the order of the request; nothing in them was run."""

    files: tuple[LibraryRead, ...]


class ExportableFunction(Struct, frozen=True, omit_defaults=True):
    """A function of the program.

    Args:
        name: the name of the function.
        parameters: the names of its parameters.
        takes_along: the functions that it calls, which are added with it.
        problem: why it can't be part of a library.
    """

    name: str
    parameters: tuple[str, ...]
    takes_along: tuple[str, ...] = ()
    problem: Phrase | None = None


class ExportableBlocks(Struct, frozen=True):
    """A file of custom blocks, and their names."""

    name: str
    blocks: tuple[str, ...]


class Exportable(ToPage, frozen=True):
    """The functions and custom blocks that a library can contain."""

    functions: tuple[ExportableFunction, ...]
    own: tuple[ExportableBlocks, ...]


class LibraryMade(ToPage, frozen=True):
    """A library in one file, in base64."""

    filename: str
    content: bytes


class LibraryConverted(ToPage, frozen=True):
    """A library of the original LearnBlock as a file of today, in base64.

    Args:
        filename: its name.
        content: its bytes.
        changed: what is different.
        missing: what could not be carried over.
    """

    filename: str
    content: bytes
    changed: tuple[Phrase, ...]
    missing: tuple[Phrase, ...]
