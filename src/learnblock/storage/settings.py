"""The user's settings: typed, saved in a file, checked by name.

Each table of ``settings.toml`` in `learnblock.storage.home` is a Struct, whose fields have types,
bounds, defaults and descriptions:

    [robots.cozmo]
    address = "192.168.1.20"

    [perception]
    webcam = 0
"""

import tomllib
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import reduce
from pathlib import Path
from typing import Annotated, Any, Generic, TypeVar

import msgspec
from msgspec import Meta, inspect

from learnblock.errors import SettingsError, UnknownNameError
from learnblock.i18n import Phrase
from learnblock.storage import toml_source
from learnblock.storage.files import save
from learnblock.storage.home import home
from learnblock.storage.struct_types import describe
from learnblock.storage.toml_values import loads

Patience = Annotated[float, Meta(ge=0.1, le=60, description="robot-setting-patience")]


class Settings(msgspec.Struct, frozen=True, forbid_unknown_fields=True, kw_only=True):
    """The base class of every table; each field has a default."""


SettingsT = TypeVar("SettingsT", bound=Settings)


@dataclass(frozen=True, slots=True)
class Described:
    """One setting, as shown to a person.

    Args:
        name: the name of the setting.
        value: the current value.
        default: the value if the user has not chosen one.
        allowed: its possible values, such as ``a whole number from 1 to 65535 (a port)``.
    """

    name: str
    value: Any
    default: Any
    allowed: Phrase


def file() -> Path:
    """The path of the user's settings file, which may not exist."""
    return home() / "settings.toml"


@dataclass(frozen=True, slots=True)
class SettingsSection(Generic[SettingsT]):
    """One table of the file.

    Args:
        path: the names of the enclosing tables and its own name.
        owner: the owner of the settings, such as ``the robot cozmo``.
        kind: the type of the settings.
    """

    path: tuple[str, ...]
    owner: str
    kind: type[SettingsT]

    def load(self, overrides: Mapping[str, Any] | None = None) -> SettingsT:
        """Load the settings.

        Args:
            overrides: settings by name, which take precedence over the file.

        Raises:
            SettingsError: a value or a name in the file or in `overrides` is invalid.
        """
        if not file().exists():
            return self._converted(dict(overrides or {}))
        whole = toml_source.read(file(), self._file_kind(), SettingsError, lambda _: ())
        saved: SettingsT = reduce(getattr, map(_identifier, self.path), whole)
        return self._converted({**_as_dict(saved), **(overrides or {})}) if overrides else saved

    def change(self, name: str, text: str | None) -> SettingsT:
        """Change one setting, given as text, in the user's file; None restores its default.

        Raises:
            UnknownNameError: there is no such setting.
            SettingsError: the value is invalid, or the file already is.
        """
        field = next(
            (field for field in msgspec.structs.fields(self.kind) if field.name == name), None
        )
        if field is None:
            names = [field.name for field in msgspec.structs.fields(self.kind)]
            raise UnknownNameError("setting", name, names)
        value = field.default if text is None else _value(text, self._types()[name])
        return self.change_all({name: value})

    def wrong(self, values: Mapping[str, Any]) -> dict[str, Phrase]:
        """Explain by name which of these values are not allowed, and why."""
        phrases = {}
        for name, value in values.items():
            try:
                self._converted({name: value})
            except SettingsError as error:
                phrases[name] = error.phrase
        return phrases

    def change_all(self, values: Mapping[str, Any]) -> SettingsT:
        """Change several settings in the user's file, all of them or none.

        Raises:
            SettingsError: a value or a name is invalid, or the file already is.
            OSError: the file can't be written.
        """
        return self.update(lambda _: values)

    def update(self, change: Callable[[SettingsT], Mapping[str, Any]]) -> SettingsT:
        """Change settings depending on what they are; other processes wait until it is done.

        Args:
            change: returns the new values of the settings that it changes, by name.

        Raises:
            SettingsError: a value or a name is invalid, or the file already is.
            OSError: the file can't be written.
        """
        from filelock import FileLock  # noqa: PLC0415 - reading needs none

        file().parent.mkdir(parents=True, exist_ok=True)
        with FileLock(file().with_name(".settings.lock")):
            present = self.load()
            new = self._converted({**_as_dict(present), **change(present)})
            if new != present:
                self._save(new)
        return new

    def describe(self) -> Iterator[Described]:
        """Describe every setting with its current value.

        Raises:
            SettingsError: the user's file is invalid.
        """
        present, types = self.load(), self._types()
        for field in msgspec.structs.fields(self.kind):
            allowed = describe(types[field.name])
            yield Described(field.name, getattr(present, field.name), field.default, allowed)

    def _converted(self, values: Mapping[str, Any]) -> SettingsT:
        name = f"settings of {self.owner}"
        return toml_source.convert(values, self.kind, SettingsError, lambda _: (), name=name)

    def _types(self) -> dict[str, inspect.Type]:
        struct = inspect.type_info(self.kind)
        assert isinstance(struct, inspect.StructType)  # noqa: S101 - for the type checker
        return {field.name: field.type for field in struct.fields}

    def _save(self, settings: SettingsT) -> None:
        """Write what differs from the defaults; the rest of the file stays, with its comments."""
        import tomlkit  # noqa: PLC0415 - reading needs none

        whole = tomlkit.parse(file().read_text("utf-8")) if file().exists() else tomlkit.document()
        table: Any = reduce(lambda outer, key: outer.setdefault(key, {}), self.path, whole)
        for field in msgspec.structs.fields(settings):
            value = getattr(settings, field.name)
            if value == field.default:
                table.pop(field.name, None)
            elif value != table.get(field.name):
                table[field.name] = value
        save(file(), tomlkit.dumps(whole).encode())

    def _file_kind(self) -> Any:
        """The type of the file, limited to this table, so that mistakes have a line."""
        return reduce(_table_with, reversed(self.path), self.kind)


def _table_with(kind: Any, name: str) -> Any:
    """A table that contains another table."""
    return msgspec.defstruct(
        "SettingsSection",
        [(_identifier(name), kind, kind())],
        rename={_identifier(name): name},
        frozen=True,
    )


def _value(text: str, kind: inspect.Type) -> Any:
    """Read a value typed on the command line; all types except strings are written as in TOML."""
    if _is_text(kind):
        return text
    try:
        values = loads(f"value = {text}")
    except (tomllib.TOMLDecodeError, RecursionError):
        # One of the allowed words, or an invalid value, which is reported later.
        return text
    return values["value"] if len(values) == 1 else text


def _is_text(kind: inspect.Type) -> bool:
    """Whether only strings are allowed."""
    if isinstance(kind, inspect.Metadata):
        return _is_text(kind.type)
    if isinstance(kind, inspect.LiteralType):
        return all(isinstance(value, str) for value in kind.values)
    return isinstance(kind, inspect.StrType)


def _as_dict(settings: Settings) -> dict[str, Any]:
    return {field.name: getattr(settings, field.name) for field in msgspec.structs.fields(settings)}


def _identifier(name: str) -> str:
    return name.replace("-", "_")
