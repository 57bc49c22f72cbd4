"""Sets of blocks: which of them the palette shows, from a first lesson to everything.

A set is a TOML file; those of the user's own lie in ``sets`` of `home`:

    [title]
    en = "First steps"

    [show]
    categories = ["Distances"]
    blocks = ["lb_main", "function.move_straight"]

What it names need not be there: a block of somebody else's own is kept in mind.
"""

import re
import unicodedata
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from types import MappingProxyType
from typing import Annotated, NoReturn

import msgspec
from msgspec import Meta, Struct

from learnblock import description_file
from learnblock.errors import BlockSetError, Diagnostic, UnknownNameError
from learnblock.files import is_device_name, save
from learnblock.home import home

#: Our own, in the order of the lessons.
BUILT_IN = ("first-steps", "loops-and-functions", "senses", "events", "everything")
EVERYTHING = "everything"
MOST_NAMES = 1000
MOST_OWN = 200

_FOLDER = Path(__file__).parent / "sets"
_NAME = re.compile(r"\w(?:[\w -]{0,58}\w)?")

Language = Annotated[str, Meta(min_length=2, max_length=20)]
Title = Annotated[str, Meta(max_length=100)]
Description = Annotated[str, Meta(max_length=500)]
Mentioned = Annotated[
    tuple[Annotated[str, Meta(min_length=1, max_length=200)], ...], Meta(max_length=MOST_NAMES)
]


class BlockNames(Struct, frozen=True, forbid_unknown_fields=True, omit_defaults=True):
    """Some of the blocks.

    Args:
        categories: whole ones, as configurations name them (``Distances``), or ours of the language
            (``lb_control``).
        blocks: as Block-Text calls a skill (``function.turn``), else by the block's type.
    """

    categories: Mentioned = ()
    blocks: Mentioned = ()


class BlockSet(Struct, frozen=True, forbid_unknown_fields=True, omit_defaults=True):
    """Which blocks are shown.

    What is said of a block goes before what is said of its category, and hiding before showing.
    Where nothing is shown by name, everything is that is not hidden.

    Args:
        name: of its file; the file itself does not say it.
        title: by language.
        description: likewise.
        show: nothing but these.
        hide: not these.
    """

    name: Annotated[str, Meta(max_length=60)] = ""
    title: Annotated[dict[Language, Title], Meta(max_length=50)] = {}
    description: Annotated[dict[Language, Description], Meta(max_length=50)] = {}
    show: BlockNames = BlockNames()
    hide: BlockNames = BlockNames()


@cache
def built_in() -> Mapping[str, BlockSet]:
    """Our own sets by name, in the order of the lessons."""
    return MappingProxyType({name: read(_FOLDER / f"{name}.toml") for name in BUILT_IN})


def own() -> tuple[tuple[BlockSet, ...], tuple[BlockSetError, ...]]:
    """The user's own sets, and what is wrong with files that are none."""
    sets, errors = [], []
    for file in sorted(_own_folder().glob("*.toml"))[:MOST_OWN]:
        try:
            checked_name(file.stem)
            sets.append(read(file))
        except BlockSetError as error:
            errors.append(error)
        except OSError as error:
            reason = f"it cannot be read: {error.strerror or error}"
            errors.append(BlockSetError(file.name, [Diagnostic("no-access", reason)]))
    return tuple(sets), tuple(errors)


def read(file: Path) -> BlockSet:
    """The set in a file.

    Raises:
        BlockSetError: it is wrong; the diagnostics say where.
        OSError: there is no such file.
    """
    found = description_file.read(file, BlockSet, BlockSetError, lambda _: ())
    return msgspec.structs.replace(found, name=file.stem)


def parse(text: str, name: str) -> BlockSet:
    """The set in a file's text.

    Args:
        text: TOML.
        name: of the set.

    Raises:
        BlockSetError: it is wrong, or the name is.
    """
    filename = f"{name}.toml"
    document = description_file.parse(text, filename, BlockSetError)
    found = description_file.convert(
        document, BlockSet, BlockSetError, lambda _: (), name=filename, source=text
    )
    return msgspec.structs.replace(found, name=checked_name(name))


def write(block_set: BlockSet) -> str:
    """The text of a set's file."""
    unnamed = msgspec.structs.replace(block_set, name="")
    return description_file.write(unnamed, block_set.name, BlockSetError)


def save_own(block_set: BlockSet, *, replace: bool) -> None:
    """Write a set into the user's folder: as a whole or not at all.

    Raises:
        BlockSetError: it has no good name, or one that is taken.
        OSError: the file cannot be written.
    """
    file = _own_file(block_set.name)
    if file.exists() and not replace:
        _refuse(
            block_set.name,
            f"you have a set of blocks `{file.stem}` already: choose another name, or save once"
            " more to replace it",
        )
    save(file, write(block_set).encode())


def delete_own(name: str) -> None:
    """Delete a set of the user's own.

    Raises:
        UnknownNameError: there is none of that name.
        BlockSetError: no set can have it.
    """
    file = _own_file(name)
    if not file.is_file():
        known = [path.stem for path in _own_folder().glob("*.toml")]
        raise UnknownNameError("set of blocks", name, known)
    file.unlink()


def checked_name(name: str) -> str:
    """The name as its file is called.

    Raises:
        BlockSetError: it is one of ours, or no name of a file.
    """
    name = unicodedata.normalize("NFC", name)
    if not _NAME.fullmatch(name) or is_device_name(name):
        _refuse(
            name,
            f"a set of blocks cannot be called {name!r:.80}: use up to 60 letters, digits, `-`, `_`"
            " and blanks",
        )
    if name in BUILT_IN:
        _refuse(name, f"`{name}` is a set of LearnBlock's own: choose another name for yours")
    return name


def _own_folder() -> Path:
    return home() / "sets"


def _own_file(name: str) -> Path:
    return _own_folder() / f"{checked_name(name)}.toml"


def _refuse(name: str, message: str) -> NoReturn:
    raise BlockSetError(name, [Diagnostic("wrong-name", message)])
