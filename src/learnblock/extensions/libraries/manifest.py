"""The manifest of a library: ``library.toml``."""

import keyword
from collections.abc import Iterator, Mapping
from typing import Annotated

import msgspec
from msgspec import Meta

from learnblock.blocks.installed_libraries import MANIFEST
from learnblock.errors import LibraryError
from learnblock.i18n import Phrase
from learnblock.storage import toml_source
from learnblock.storage.files import is_device_name
from learnblock.storage.toml_source import FileMistake

Name = Annotated[
    str,
    Meta(
        pattern=r"^[a-z][a-z0-9_]{0,39}\Z",
        description="at most 40 lower-case letters, digits and _, beginning with a letter",
    ),
]
Version = Annotated[
    str,
    Meta(pattern=r"^\d{1,5}(\.\d{1,5}){0,2}\Z", description="one to three numbers, such as 1.2.0"),
]
Language = Annotated[str, Meta(pattern=r"^[a-z]{2,3}(-[A-Za-z0-9]{2,8})?\Z")]
Title = Annotated[str, Meta(min_length=1, max_length=60)]


class Manifest(msgspec.Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """The manifest of a library.

    Args:
        learnblock: the version of this format.
        name: the name that programs import.
        version: a higher version is newer.
        title: the name of the palette tab, by language code.
        description: the purpose of the library.
    """

    learnblock: Annotated[int, Meta(ge=1, le=1, description="the version of the format, 1")]
    name: Name
    version: Version
    title: Annotated[dict[Language, Title], Meta(max_length=50)] = {}
    description: Annotated[str, Meta(max_length=2000)] = ""

    @property
    def order(self) -> tuple[int, ...]:
        """The version as numbers to compare."""
        return order(self.version)


def order(version: str) -> tuple[int, ...]:
    """A version as numbers to compare: 1.2 is 1.2.0, and older than 1.10."""
    numbers = [int(part) for part in version.split(".")]
    return tuple(numbers + [0] * (3 - len(numbers)))


def manifest(
    name: str, version: str, title: Mapping[str, str] | None = None, description: str = ""
) -> Manifest:
    """The manifest of a new library.

    Raises:
        LibraryError: a value is invalid.
    """
    values = {
        "learnblock": 1,
        "name": name,
        "version": version,
        "title": dict(title or {}),
        "description": description,
    }
    return toml_source.convert(values, Manifest, LibraryError, _findings, name=MANIFEST)


def read_manifest(text: str) -> Manifest:
    """The manifest in a string.

    Raises:
        LibraryError: it is invalid.
    """
    values = toml_source.parse(text, MANIFEST, LibraryError)
    return toml_source.convert(
        values, Manifest, LibraryError, _findings, name=MANIFEST, source=text
    )


def write_manifest(manifest: Manifest) -> str:
    """The text of ``library.toml``."""
    return toml_source.write(manifest, MANIFEST, LibraryError)


def _findings(manifest: Manifest) -> Iterator[FileMistake]:
    if keyword.iskeyword(manifest.name) or is_device_name(manifest.name):
        message = Phrase("library-bad-name", name=manifest.name)
        yield FileMistake(("name",), "name-taken", message)
