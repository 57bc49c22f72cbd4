"""The edges of every field of a message, made from its class."""

import msgspec
from msgspec import inspect

from learnblock.i18n import Phrase

#: Of any type: what a field may get whatever it expects.
ODD = (
    None, True, 0, -1, 2**32, 2**63 - 1, -(2**63), 2**64 - 1, 1e308, float("nan"), float("inf"),
    "", "\0", "/dev/ptmx", "../../../etc/passwd", "/a\0b", "\x1b]0;x\x07", "run-too-much-output",
    "x" * 70_000, b"", b"\x91" * 3000, [], [[]] * 3000, {}, {"a": {}}, {1: 2},
)  # fmt: skip
PHRASES = (
    Phrase(""), Phrase("run-too-much-output"), Phrase("run-too-much-output", megabytes=Phrase("x")),
    Phrase("run-not-contained", reason="x"), Phrase("run-lost", reason="x"), Phrase("not-known"),
    Phrase("grade-no-program"), Phrase("x" * 10**4), Phrase("run-means-name-near", name=1, near=()),
    Phrase("run-value-too-large", size=float("nan"), limit=float("inf")),
)  # fmt: skip


def fields(kind):
    """The fields of a message that are sent, with their types."""
    return inspect.type_info(kind).fields


def edges(info):  # noqa: PLR0911 - one for each type
    """Values at the edges of a type, and beyond them."""
    match info:
        case inspect.IntType(ge=least, le=most):
            return [value for bound in (least, most) if bound is not None
                    for value in (bound - 1, bound, bound + 1)]  # fmt: skip
        case inspect.FloatType():
            return [-1.0, 1e300]
        case inspect.StrType(max_length=most) if most:
            return ["x" * most, "ñ" * most, "x" * (most + 1)]
        case inspect.BytesType(max_length=most) if most:
            return [b"\xc0" * most, b"x" * (most + 1)]
        case inspect.VarTupleType(item_type=item, max_length=most):
            few = [[value] for value in edges(item)]
            return [*few, [typical(item)] * (most or 100), [typical(item)] * ((most or 100) + 1)]
        case inspect.DictType(key_type=key, value_type=value, max_length=most):
            several = {f"k{index}": typical(value) for index in range((most or 1000) + 1)}
            return [*({typical(key): edge} for edge in edges(value)), several]
        case inspect.UnionType(types=types):
            return [value for kind in types for value in edges(kind)]
        case inspect.StructType(cls=cls):
            return [*altered(cls)]
        case inspect.DataclassType(cls=cls) if cls is Phrase:
            return list(PHRASES)
    return []


def typical(info):
    """A value that a type accepts."""
    match info:
        case inspect.IntType(ge=least):
            return least or 0
        case inspect.UnionType(types=types):
            return typical(types[0])
        case inspect.TupleType(item_types=types):
            return [*map(typical, types)]
        case inspect.StructType(cls=cls):
            return whole(cls)
        case inspect.DataclassType():
            return Phrase("x")
    plain = {
        inspect.StrType: "x", inspect.BytesType: b"", inspect.VarTupleType: [],
        inspect.DictType: {}, inspect.BoolType: False, inspect.FloatType: 0.0,
    }  # fmt: skip
    return plain.get(type(info))


def whole(kind, **values):
    """A message with these values and typical other ones, as it is sent: a list."""
    info = inspect.type_info(kind)
    tag = [info.tag] if info.tag is not None else []
    return [*tag, *(values.get(field.name, typical(field.type)) for field in info.fields)]


def altered(kind, **values):
    """The message with one field after the other at each of its edges."""
    for field in fields(kind):
        for value in (*edges(field.type), *ODD):
            yield whole(kind, **{**values, field.name: value})


def framed(message):
    """A message as it is sent over a link."""
    body = msgspec.msgpack.encode(message)
    return len(body).to_bytes(4) + body
