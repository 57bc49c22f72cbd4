"""Block sets: the blocks that the palette shows, from a first lesson to everything.

A block set is a TOML file; the user's are in the folder ``sets`` of `home`:


    en = "First steps"

    [show]
    categories = ["Distances"]
    blocks = ["lb_main", "function.move_straight"]

A set may name blocks that do not exist here, such as another user's custom blocks.
"""

import os
import re
import unicodedata
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from types import MappingProxyType
from typing import Annotated, Literal, NoReturn, get_args

import msgspec
from msgspec import Meta, Struct

from learnblock.errors import BlockSetError, Diagnostic, UnknownNameError
from learnblock.i18n import Phrase, in_each_language
from learnblock.storage import toml_source
from learnblock.storage.files import is_device_name, save
from learnblock.storage.home import home

BuiltIn = Literal["first-steps", "loops-and-functions", "senses", "events", "everything"]
#: The built-in sets, in the order of the lessons.
BUILT_IN: tuple[BuiltIn, ...] = get_args(BuiltIn)
EVERYTHING: BuiltIn = "everything"
#: Names the built-in set with which projects begin, as the teacher of a class has chosen.
VARIABLE = "LEARNBLOCK_BLOCKS"
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
    """A selection of blocks.

    Args:
        categories: whole tabs, named as in configurations (``Distances``), or those of the language
            (``lb_control``).
        blocks: skills as in Block-Text (``function.turn``), and other blocks by their type.
    """

    categories: Mentioned = ()
    blocks: Mentioned = ()


# Why: docs/decisions.md, "A block set hides blocks and forbids nothing"
class BlockSet(Struct, frozen=True, forbid_unknown_fields=True, omit_defaults=True):
    """A block set.

    An entry for a block wins over one for its category, and hiding wins over showing. If nothing is
    shown by name, everything is shown that is not hidden.

    Args:
        name: the name of its file; the file does not contain it.
        title: the title, by language.
        description: the description, by language.
        show: show only these.
        hide: show all except these.
    """

    name: Annotated[str, Meta(max_length=60)] = ""
    title: Annotated[dict[Language, Title], Meta(max_length=50)] = {}
    description: Annotated[dict[Language, Description], Meta(max_length=50)] = {}
    show: BlockNames = BlockNames()
    hide: BlockNames = BlockNames()


def of_new_projects() -> str:
    """The name of the built-in set with which a project begins."""
    name = os.environ.get(VARIABLE, EVERYTHING)
    return name if name in BUILT_IN else EVERYTHING


@cache
def built_in() -> Mapping[str, BlockSet]:
    """The built-in sets by name, in the order of the lessons."""
    return MappingProxyType({name: _built_in(name) for name in BUILT_IN})


def _built_in(name: str) -> BlockSet:
    """One of the built-in sets, with its title and description from the words of each language."""
    return msgspec.structs.replace(
        read(_FOLDER / f"{name}.toml"),
        title=in_each_language(Phrase(f"set-{name}-title")),
        description=in_each_language(Phrase(f"set-{name}-about")),
    )


def own() -> tuple[tuple[BlockSet, ...], tuple[BlockSetError, ...]]:
    """The user's own sets, and the errors of invalid files."""
    sets, errors = [], []
    for file in sorted(_own_folder().glob("*.toml"))[:MOST_OWN]:
        try:
            checked_name(file.stem)
            sets.append(read(file))
        except BlockSetError as error:
            errors.append(error)
        except OSError as error:
            reason = Phrase("set-unreadable", reason=error.strerror or str(error))
            errors.append(BlockSetError(file.name, [Diagnostic("no-access", reason)]))
    return tuple(sets), tuple(errors)


def read(file: Path) -> BlockSet:
    """Read the set in a file.

    Raises:
        BlockSetError: it is invalid.
        OSError: the file cannot be read.
    """
    block_set = toml_source.read(file, BlockSet, BlockSetError, lambda _: ())
    return msgspec.structs.replace(block_set, name=file.stem)


def parse(text: str, name: str) -> BlockSet:
    """The set in the text of a file.

    Args:
        text: TOML.
        name: the name of the set.

    Raises:
        BlockSetError: the text or the name is invalid.
    """
    filename = f"{name}.toml"
    document = toml_source.parse(text, filename, BlockSetError)
    block_set = toml_source.convert(
        document, BlockSet, BlockSetError, lambda _: (), name=filename, source=text
    )
    return msgspec.structs.replace(block_set, name=checked_name(name))


def write(block_set: BlockSet) -> str:
    """A set as the text of its file."""
    unnamed = msgspec.structs.replace(block_set, name="")
    return toml_source.write(unnamed, block_set.name, BlockSetError)


def save_own(block_set: BlockSet, *, replace: bool) -> None:
    """Save a set in the user's folder.

    Raises:
        BlockSetError: its name is not allowed or is taken.
        OSError: the file cannot be written.
    """
    file = _own_file(block_set.name)
    if file.exists() and not replace:
        _refuse(block_set.name, Phrase("set-name-taken", name=file.stem))
    save(file, write(block_set).encode())


def delete_own(name: str) -> None:
    """Delete one of the user's own sets.

    Raises:
        UnknownNameError: there is no such set.
        BlockSetError: the name is not allowed.
    """
    file = _own_file(name)
    if not file.is_file():
        names = [path.stem for path in _own_folder().glob("*.toml")]
        raise UnknownNameError("block-set", name, names)
    file.unlink()


def checked_name(name: str) -> str:
    """The name in the form used for files.

    Raises:
        BlockSetError: it is the name of a built-in set, or not a file name.
    """
    name = unicodedata.normalize("NFC", name)
    if not _NAME.fullmatch(name) or is_device_name(name):
        _refuse(name, Phrase("set-bad-name", name=name[:80]))
    if name in BUILT_IN:
        _refuse(name, Phrase("set-built-in-name", name=name))
    return name


def _own_folder() -> Path:
    return home() / "sets"


def _own_file(name: str) -> Path:
    return _own_folder() / f"{checked_name(name)}.toml"


def _refuse(name: str, message: Phrase) -> NoReturn:
    raise BlockSetError(name, [Diagnostic("wrong-name", message)])
