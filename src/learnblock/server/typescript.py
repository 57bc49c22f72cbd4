"""The page's types, written from `learnblock.server.messages`, and those of worlds and robots.

The build writes them into ``frontend/src/protocol`` as ``messages.ts`` and ``world.ts``.
"""

from collections.abc import Iterable, Iterator, Mapping
from typing import Any, get_args

import msgspec
from msgspec import inspect, json

from learnblock.monitor import worlds
from learnblock.monitor.sensors import QUANTITIES, Quantity
from learnblock.project.document import views
from learnblock.server import messages

_HEADER = """\
/** The conversation with the server; written by `hatch_types.py`. */

import type { Phrase } from "../i18n";
import type { RobotDescription, WorldFile } from "./world";
"""
_WORLD_HEADER = """\
/** Worlds and robots as in their files; written by `hatch_types.py`. */
"""
_SCALARS: dict[type[inspect.Type], str] = {
    inspect.StrType: "string",
    inspect.IntType: "number",
    inspect.FloatType: "number",
    inspect.BoolType: "boolean",
    # In base 64.
    inspect.BytesType: "string",
    inspect.NoneType: "null",
    inspect.AnyType: "unknown",
}


def typescript() -> str:
    """The whole module."""
    unions = {"FromPage": messages.FROM_PAGE, "ToPage": messages.TO_PAGE}
    aliases = {"Notation": views.Notation, "View": views.View}
    quantities = _constant("QUANTITIES", "Record<string, Quantity>", dict(QUANTITIES))
    return (
        module(_HEADER, unions, aliases, [Quantity])
        + answers(messages.FROM_PAGE)
        + quantities
        + limits(messages.FROM_PAGE)
    )


def world_typescript() -> str:
    """The module of what `Scene` and the world editor's messages carry as plain values."""
    aliases = {name: getattr(worlds, name) for name in ("Colour", "PropKind", "Theme")}
    types = module(_WORLD_HEADER, {}, aliases, [worlds.WorldFile, worlds.RobotDescription])
    sizes = "Readonly<Record<PropKind, readonly [number, number] | number>>"
    return types + _constant("PROP_SIZES", sizes, dict(worlds.PROP_SIZES))


def module(
    header: str, unions: Mapping[str, Any], aliases: Mapping[str, Any], structs: Iterable[type] = ()
) -> str:
    """A module with the types of a conversation.

    Args:
        header: its first lines.
        unions: the messages by direction.
        aliases: other types that have a name.
        structs: types that are sent on their own.
    """
    kinds = {name: inspect.type_info(union) for name, union in unions.items()}
    alone = [inspect.type_info(struct) for struct in structs]
    parts = [header]
    parts += [
        f"export type {name} = {_written(inspect.type_info(alias))};\n"
        for name, alias in aliases.items()
    ]
    parts += [_interface(struct) for struct in structs_of([*kinds.values(), *alone])]
    parts += [
        f"export type {name} =\n  | " + "\n  | ".join(_members(kind)) + ";\n"
        for name, kind in kinds.items()
    ]
    return "\n".join(parts)


def answers(union: Any) -> str:
    """What may answer a request besides `Done` and `Failed`, by the kind of request.

    Args:
        union: the messages from the page.
    """
    rows = [f"  {kind.__name__}: {kind.answer};\n" for kind in get_args(union) if kind.answer]
    return f"\nexport interface Answers {{\n{''.join(rows)}}}\n"


def limits(union: Any) -> str:
    """The greatest lengths that the server accepts, by message and field.

    A text has a number of characters, a file a number of bytes, and any other field a number of
    entries.

    Args:
        union: the messages from the page.
    """
    longest = {
        struct.cls.__name__: {
            field.encode_name: most
            for field in struct.fields
            if (most := _max_length(field.type)) is not None
        }
        for struct in structs_of([inspect.type_info(union)])
    }
    written = json.format(
        json.encode({name: lengths for name, lengths in longest.items() if lengths})
    )
    return f"\nexport const LIMITS = {written.decode()} as const;\n"


def _max_length(kind: inspect.Type) -> int | None:
    if isinstance(kind, inspect.UnionType):
        lengths = map(_max_length, kind.types)
        return next((length for length in lengths if length is not None), None)
    most: int | None = getattr(kind, "max_length", None)
    return most


def _constant(name: str, kind: str, value: Any) -> str:
    """A constant that page and server share, of a type of TypeScript."""
    written = json.format(json.encode(value)).decode()
    return f"\nexport const {name}: {kind} = {written};\n"


def _members(kind: inspect.Type) -> Iterator[str]:
    yield from map(_written, kind.types if isinstance(kind, inspect.UnionType) else [kind])


def structs_of(kinds: Any) -> list[inspect.StructType]:
    """Every struct used in the messages, in alphabetical order."""
    structs: dict[str, inspect.StructType] = {}
    ahead = list(kinds)
    while ahead:
        kind = ahead.pop()
        if isinstance(kind, inspect.StructType):
            struct = structs.get(kind.cls.__name__)
            if struct and struct.cls is not kind.cls:
                raise TypeError(f"{struct.cls} and {kind.cls} have the same name")
            if struct:
                continue
            structs[kind.cls.__name__] = kind
        ahead += _parts(kind)
    return [structs[name] for name in sorted(structs)]


def _parts(kind: inspect.Type) -> list[inspect.Type]:
    match kind:
        case inspect.StructType(fields=fields):
            return [field.type for field in fields]
        case inspect.UnionType(types=types):
            return list(types)
        case (
            inspect.ListType(item_type=item)
            | inspect.VarTupleType(item_type=item)
            | inspect.Metadata(type=item)
        ):
            return [item]
        case inspect.TupleType(item_types=items):
            return list(items)
        case inspect.DictType(value_type=value):
            return [value]
    return []


def _interface(struct: inspect.StructType) -> str:
    if struct.array_like:
        fields = ", ".join(f"{field.name}: {_written(field.type)}" for field in struct.fields)
        return f"export type {struct.cls.__name__} = [{fields}];\n"
    lines = [f"export interface {struct.cls.__name__} {{"]
    if struct.tag is not None:
        lines.append(f'  {struct.tag_field}: "{struct.tag}";')
    lines += [
        f"  {field.encode_name}{_mark(struct, field)}: {_written(field.type)};"
        for field in struct.fields
    ]
    return "\n".join([*lines, "}", ""])


def _mark(struct: inspect.StructType, field: inspect.Field) -> str:
    """Whether a field may be absent: the server omits defaults, and a page may too."""
    defaults = struct.cls.__struct_config__.omit_defaults
    has_default = (
        field.default is not msgspec.NODEFAULT or field.default_factory is not msgspec.NODEFAULT
    )
    return "?" if defaults and has_default else ""


def _written(kind: inspect.Type) -> str:
    if isinstance(kind, inspect.Metadata):
        return kind.extra["values_of"] if kind.extra else _written(kind.type)
    scalar = _SCALARS.get(type(kind))
    return _compound(kind) if scalar is None else scalar


def _compound(kind: inspect.Type) -> str:
    match kind:
        case inspect.StructType(cls=cls) | inspect.DataclassType(cls=cls):
            return str(cls.__name__)
        case inspect.LiteralType() | inspect.EnumType():
            return " | ".join(f'"{value}"' for value in _choices(kind))
        case inspect.UnionType(types=types):
            return " | ".join(dict.fromkeys(map(_written, types)))
        case inspect.ListType(item_type=item) | inspect.VarTupleType(item_type=item):
            return f"{_bracketed(item)}[]"
        case inspect.TupleType(item_types=items):
            return f"[{', '.join(map(_written, items))}]"
        case inspect.DictType(value_type=value):
            return f"Record<string, {_written(value)}>"
    raise TypeError(f"there is no TypeScript for {kind}")


def _choices(kind: inspect.LiteralType | inspect.EnumType) -> Iterable[Any]:
    if isinstance(kind, inspect.EnumType):
        return [member.value for member in kind.cls]
    return kind.values


def _bracketed(kind: inspect.Type) -> str:
    text = _written(kind)
    return f"({text})" if " | " in text else text
