"""The types of a Struct's fields: the values that they allow, in words and as choices.

Numbers are passed as strings, because a file spells them the same in every language.
"""

from collections.abc import Mapping

from msgspec import inspect

from learnblock.i18n import Phrase, Value

#: The path to a value: ``("wall", 2, "height")`` is the height of the third ``[[wall]]``.
KeyPath = tuple[str | int, ...]


def describe(allowed: inspect.Type) -> Phrase:
    """Describe the values of a type, such as ``a number from 0 to 100 (width, mm)``."""
    match allowed:
        case inspect.Metadata(type=inner, extra_json_schema=extra):
            note = (extra or {}).get("description")
            described = describe(inner)
            if not note:
                return described
            return Phrase("toml-with-note", allowed=described, note=Phrase(note))
        case inspect.UnionType(types=types):
            if tagged := tag(allowed):
                key, values = tagged
                return Phrase("toml-tagged", key=key, allowed=_describe_scalar(values))
            return _either([kind for kind in types if not isinstance(kind, inspect.NoneType)])
        case inspect.TupleType() | inspect.VarTupleType():
            return _describe_list(allowed)
    return _describe_scalar(allowed)


def _describe_scalar(allowed: inspect.Type) -> Phrase:
    match allowed:
        case inspect.LiteralType(values=values):
            return Phrase("toml-choice", count=len(values), choices=tuple(map(str, values)))
        case inspect.FloatType(ge=float() | int() as least, le=float() | int() as most):
            return Phrase("toml-number", least=f"{least:g}", most=f"{most:g}")
        case inspect.IntType(ge=int() as least, le=int() as most):
            return Phrase("toml-whole-number", least=str(least), most=str(most))
        case inspect.StrType(min_length=least, max_length=most):
            if most is not None:
                return Phrase("toml-text", least=least or 0, most=most)
            # Its description says more.
            return Phrase("toml-plain-text")
    return Phrase("toml-boolean" if isinstance(allowed, inspect.BoolType) else "toml-table")


def bare(allowed: inspect.Type) -> inspect.Type:
    """A type without its description."""
    return bare(allowed.type) if isinstance(allowed, inspect.Metadata) else allowed


def alternatives(allowed: inspect.Type) -> list[inspect.Type]:
    """The types of a union, or the type itself."""
    kind = bare(allowed)
    return list(map(bare, kind.types)) if isinstance(kind, inspect.UnionType) else [kind]


def choices(allowed: inspect.Type) -> list[object]:
    """The values that a type lists one by one."""
    kinds = alternatives(allowed)
    return [
        choice for kind in kinds if isinstance(kind, inspect.LiteralType) for choice in kind.values
    ]


def fields(allowed: inspect.Type) -> tuple[inspect.Field, ...]:
    """The fields of a Struct's type; none for another type."""
    for kind in alternatives(allowed):
        if isinstance(kind, inspect.StructType):
            return kind.fields
    return ()


def tag(allowed: inspect.Type) -> tuple[str, inspect.LiteralType] | None:
    """The key that tells the tables of a union apart, and its values; None if there is none."""
    kinds = [kind for kind in alternatives(allowed) if isinstance(kind, inspect.StructType)]
    key = kinds[0].tag_field if kinds else None
    return (key, inspect.LiteralType(tuple(kind.tag for kind in kinds))) if key else None


def known_keys(allowed: inspect.Type) -> list[str]:
    """The keys of a table."""
    tagged = tag(allowed)
    return [*(tagged[:1] if tagged else ()), *(field.encode_name for field in fields(allowed))]


def type_of_key(allowed: inspect.Type, key: str) -> inspect.Type:
    """The type of the values of a key of a table."""
    if (tagged := tag(allowed)) and key == tagged[0]:
        return tagged[1]
    return next(field.type for field in fields(allowed) if field.encode_name == key)


def entry_types(allowed: inspect.Type) -> tuple[inspect.Type, inspect.Type]:
    """The types of the keys and of the values of a table that can have any keys."""
    kinds = [kind for kind in alternatives(allowed) if isinstance(kind, inspect.DictType)]
    return (kinds[0].key_type, kinds[0].value_type) if kinds else (allowed, allowed)


def type_at(root: inspect.Type, path: KeyPath, document: object) -> inspect.Type:
    """The type at a path, with its description; in a union, the path leads into the list.

    Args:
        root: the type of the whole document.
        path: the path.
        document: its value says which table of a union it is.
    """
    allowed, value = root, document
    for step in path:
        allowed, value = _entry(allowed, step), value[step]  # type: ignore[index] # as the path
        allowed = _chosen(allowed, value)
    return allowed


def _chosen(allowed: inspect.Type, value: object) -> inspect.Type:
    """The table of a union that a value says it is; the union itself if it says none."""
    tagged = tag(allowed)
    if tagged is None or not isinstance(value, Mapping):
        return allowed
    tag_value = value.get(tagged[0])
    kinds = [kind for kind in alternatives(allowed) if isinstance(kind, inspect.StructType)]
    return next((kind for kind in kinds if kind.tag == tag_value), allowed)


def _entry(allowed: inspect.Type, step: str | int) -> inspect.Type:
    if isinstance(step, str):
        return type_of_key(allowed, step)
    for kind in alternatives(allowed):
        if isinstance(kind, inspect.TupleType):
            return kind.item_types[step]
        if isinstance(kind, inspect.VarTupleType):
            return kind.item_type
    return allowed


def _either(kinds: list[inspect.Type]) -> Phrase:
    first, *others = kinds
    if not others:
        return describe(first)
    return Phrase("toml-either", first=describe(first), second=_either(others))


def _describe_list(allowed: inspect.TupleType | inspect.VarTupleType) -> Phrase:
    if isinstance(allowed, inspect.TupleType):
        items = tuple(map(describe, allowed.item_types))
        if all(item == items[0] for item in items):
            return Phrase("toml-list-exactly", count=len(items), item=items[0])
        return Phrase("toml-items", items=items)
    bounds: dict[str, Value] = {"least": allowed.min_length or 0, "most": allowed.max_length or 0}
    return Phrase("toml-list", item=describe(allowed.item_type), **bounds)
