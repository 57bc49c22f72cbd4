"""What a user has chosen: typed, kept in a file, refused by name.

Each table of ``settings.toml`` in `learnblock.home` is a Struct, whose fields have types, bounds,
defaults and descriptions:

    [robots.cozmo]
    address = "192.168.1.20"

    [perception]
    webcam = 0
"""

import tomllib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import reduce
from pathlib import Path
from typing import Annotated, Any, Generic, TypeVar

import msgspec
import tomli_w
from msgspec import Meta, inspect

from learnblock import description_file
from learnblock.errors import SettingsError, UnknownNameError
from learnblock.files import save
from learnblock.home import home

Patience = Annotated[float, Meta(ge=0.1, le=60, description="until it must have answered, s")]


class Settings(msgspec.Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """The base of every table; each field has a default."""


SettingsT = TypeVar("SettingsT", bound=Settings)


@dataclass(frozen=True, slots=True)
class Described:
    """One setting, as a person is shown it.

    Args:
        name: of the setting.
        value: as it is now.
        default: as it is where nobody has chosen.
        allowed: what it may be, such as ``a whole number from 1 to 65535 (a port)``.
    """

    name: str
    value: Any
    default: Any
    allowed: str


def file() -> Path:
    """Where the user's settings stand; the file need not be there."""
    return home() / "settings.toml"


@dataclass(frozen=True, slots=True)
class Table(Generic[SettingsT]):
    """One table of the file.

    Args:
        path: its name and, before that, those of the tables it stands in.
        owner: whose settings these are, in words: ``the robot cozmo``.
        kind: what can be set.
    """

    path: tuple[str, ...]
    owner: str
    kind: type[SettingsT]

    def load(self, chosen: Mapping[str, Any] | None = None) -> SettingsT:
        """The settings.

        Args:
            chosen: settings by name, which go before those of the file.

        Raises:
            SettingsError: a value or a name is wrong, in the file or among those chosen.
        """
        if not file().exists():
            return self._converted(dict(chosen or {}))
        whole = description_file.read(file(), self._file_kind(), SettingsError, lambda _: ())
        saved: SettingsT = reduce(getattr, map(_identifier, self.path), whole)
        return self._converted({**_as_dict(saved), **(chosen or {})}) if chosen else saved

    def change(self, name: str, text: str | None) -> SettingsT:
        """Set one setting, given as text, in the user's file; None puts its default back.

        Raises:
            UnknownNameError: there is no such setting.
            SettingsError: the value is wrong, or what stands in the file already is.
        """
        field = next((one for one in msgspec.structs.fields(self.kind) if one.name == name), None)
        if field is None:
            known = [one.name for one in msgspec.structs.fields(self.kind)]
            raise UnknownNameError(f"setting of {self.owner}", name, known)
        value = field.default if text is None else _value(text, self._types()[name])
        return self.change_all({name: value})

    def wrong(self, values: Mapping[str, Any]) -> dict[str, str]:
        """Why some of these values cannot be: a sentence for each of them, by name."""
        found = {}
        for name, value in values.items():
            try:
                self._converted({name: value})
            except SettingsError as error:
                found[name] = "; ".join(one.message for one in error.diagnostics)
        return found

    def change_all(self, values: Mapping[str, Any]) -> SettingsT:
        """Set several settings in the user's file, all of them or none.

        Raises:
            SettingsError: a value or a name is wrong, or what stands in the file already is.
        """
        changed = self._converted({**_as_dict(self.load()), **values})
        self._save(changed)
        return changed

    def describe(self) -> Iterator[Described]:
        """Every setting as it is now.

        Raises:
            SettingsError: what stands in the user's file is wrong.
        """
        present, types = self.load(), self._types()
        for field in msgspec.structs.fields(self.kind):
            allowed = description_file.describe(types[field.name])
            yield Described(field.name, getattr(present, field.name), field.default, allowed)

    def _converted(self, values: Mapping[str, Any]) -> SettingsT:
        name = f"settings of {self.owner}"
        return description_file.convert(values, self.kind, SettingsError, lambda _: (), name=name)

    def _types(self) -> dict[str, inspect.Type]:
        found = inspect.type_info(self.kind)
        assert isinstance(found, inspect.StructType)  # noqa: S101 - for the type checker
        return {field.name: field.type for field in found.fields}

    def _save(self, settings: SettingsT) -> None:
        whole = tomllib.loads(file().read_text("utf-8")) if file().exists() else {}
        *outer, name = self.path
        reduce(lambda table, key: table.setdefault(key, {}), outer, whole)[name] = {
            field.name: getattr(settings, field.name)
            for field in msgspec.structs.fields(settings)
            if getattr(settings, field.name) != field.default
        }
        save(file(), tomli_w.dumps(whole).encode())

    def _file_kind(self) -> Any:
        """The whole file as far as it concerns this table, so that mistakes have their line."""
        return reduce(_table_with, reversed(self.path), self.kind)


def _table_with(kind: Any, name: str) -> Any:
    """A table that holds another one."""
    return msgspec.defstruct(
        "Table",
        [(_identifier(name), kind, kind())],
        rename={_identifier(name): name},
        frozen=True,
    )


def _value(text: str, kind: inspect.Type) -> Any:
    """What a text typed on a command line means: a text stays one, all else is as in the file."""
    if _is_text(kind):
        return text
    try:
        written = tomllib.loads(f"value = {text}")
    except tomllib.TOMLDecodeError:
        # One of the words that are allowed, or told as the wrong value that it is.
        return text
    return written["value"] if len(written) == 1 else text


def _is_text(kind: inspect.Type) -> bool:
    """Whether nothing but texts is allowed."""
    if isinstance(kind, inspect.Metadata):
        return _is_text(kind.type)
    if isinstance(kind, inspect.LiteralType):
        return all(isinstance(value, str) for value in kind.values)
    return isinstance(kind, inspect.StrType)


def _as_dict(settings: Settings) -> dict[str, Any]:
    return {field.name: getattr(settings, field.name) for field in msgspec.structs.fields(settings)}


def _identifier(name: str) -> str:
    return name.replace("-", "_")
