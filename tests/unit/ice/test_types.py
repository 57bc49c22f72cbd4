"""Slice's types in bytes, and invalid bytes."""

import math
from array import array
from dataclasses import dataclass
from enum import IntEnum
from typing import Annotated

import pytest
from hypothesis import given
from hypothesis import strategies as st

from learnblock.errors import IceEncodingError, LearnBlockError
from learnblock.ice.encoding import Reader, Writer
from learnblock.ice.robocomp import Layout, interfaces
from learnblock.ice.types import (
    BOOL,
    BYTE,
    DOUBLE,
    FLOAT,
    INT,
    LONG,
    SHORT,
    STRING,
    Bool,
    Dictionary,
    Enumeration,
    Float,
    Int,
    Sequence,
    String,
    Structure,
)


class Colour(IntEnum):
    RED = 0
    BLUE = 2


@dataclass(frozen=True)
class Thing:
    name: String
    size: Float
    here: Bool
    count: Int
    colour: Annotated[Colour, Enumeration(Colour)] = Colour.RED


THING = Structure.of(Thing)


@pytest.mark.parametrize(
    ("kind", "value", "expected"),
    [
        (BOOL, True, "01"),
        (BYTE, 200, "c8"),
        (SHORT, -2, "feff"),
        (INT, 1, "01000000"),
        (LONG, -1, "ff" * 8),
        (FLOAT, 1.0, "0000803f"),
        (DOUBLE, -2.0, "00000000000000c0"),
        (STRING, "ñu", "03c3b175"),
        (STRING, "", "00"),
        (Sequence(BYTE), b"\x01\x02", "020102"),
        (Sequence(INT), [1, -1], "0201000000ffffffff"),
        (Sequence(STRING), ["a", ""], "02016100"),
        (Dictionary(STRING, BOOL), {"a": True}, "01016101"),
        (Enumeration(Colour), Colour.BLUE, "02"),
        (THING, Thing("t", 1.0, here=True, count=2), "017400 00803f 01 02000000 00"),
    ],
)
def test_a_value_has_the_bytes_of_the_manual(kind, value, expected):
    data = kind.encoded(value)
    assert data == bytes.fromhex(expected)
    assert list(kind.decoded(data)) == list(value) if isinstance(value, list) else True


@pytest.mark.parametrize(("count", "length"), [(254, 1), (255, 5), (70_000, 5)])
def test_a_size_takes_one_byte_up_to_254_and_five_beyond(count, length):
    data = STRING.encoded("x" * count)
    assert len(data) == length + count
    assert STRING.decoded(data) == "x" * count


def test_sequences_of_numbers_are_arrays_and_bytes_are_bytes():
    assert Sequence(FLOAT).decoded(Sequence(FLOAT).encoded([1.5, 2.5])) == array("f", [1.5, 2.5])
    assert Sequence(BYTE).decoded(b"\x02ab") == b"ab"


def test_a_struct_follows_the_order_of_its_layout():
    there = Structure.of(Thing, "count colour name here size")
    data = there.encoded(Thing("t", 1.0, here=True, count=2))
    assert data == bytes.fromhex("02000000 00 0174 01 0000803f")
    assert there.decoded(data) == Thing("t", 1.0, here=True, count=2)


def test_an_order_without_one_of_the_members_is_refused():
    with pytest.raises(ValueError, match="are not the members of Thing"):
        Structure.of(Thing, "count name")


@pytest.mark.parametrize(
    ("kind", "value"),
    [
        (INT, "1"),
        (INT, 2**31),
        (BYTE, 256),
        (BYTE, -1),
        (FLOAT, None),
        (FLOAT, 1e39),
        (STRING, 3),
        (STRING, "\ud800"),
        (Sequence(BYTE), 5),
        (Sequence(BYTE), [1, 2]),
        (Sequence(INT), 5),
        (Sequence(INT), ["a"]),
        (Sequence(STRING), [1]),
        (Dictionary(STRING, INT), [1]),
        (Enumeration(Colour), 1),
        (THING, object()),
        (THING, Thing("t", 1.0, here=True, count="many")),
    ],
)
def test_an_invalid_value_is_rejected_by_name(kind, value):
    with pytest.raises(IceEncodingError, match=f"is not a valid {kind}"):
        kind.encoded(value)


@pytest.mark.parametrize(
    ("kind", "data", "sentence"),
    [
        (INT, "010000", "4 bytes should follow, but only 3 do"),
        (INT, "0100000000", "1 bytes are left over"),
        (BOOL, "02", "2 is not a valid bool"),
        (STRING, "05", "5 bytes should follow, but only 0 do"),
        (STRING, "02c328", "is not a valid string"),
        (STRING, "ffffffffff", "-1 is not a valid size"),
        (Sequence(INT), "ffffffff7f", "8,589,934,588 bytes should follow, but only 0 do"),
        (Sequence(THING), "fe" + "00" * 100, "bytes should follow, but only 100 do"),
        (Enumeration(Colour), "01", "1 is not a valid Colour"),
    ],
)
def test_bytes_without_such_a_value_are_rejected(kind, data, sentence):
    with pytest.raises(IceEncodingError, match=sentence):
        kind.decoded(bytes.fromhex(data))


def test_an_encapsulation_contains_its_encoding():
    writer = Writer((1, 0))
    writer.text("a")
    reader = Reader(writer.encapsulated()).encapsulated()
    assert (reader.version, reader.text()) == ((1, 0), "a")


def test_an_unknown_encoding_is_refused():
    with pytest.raises(IceEncodingError, match=r"The encoding 2\.0 is not supported"):
        Reader(bytes.fromhex("060000000200")).encapsulated()


def types_of_robocomp():
    """Yield every type in RoboComp's interfaces, in each layout."""
    for layout in Layout:
        for interface in interfaces(layout).values():
            for operation in interface.operations:
                yield from (*operation.takes, *operation.gives)


TYPES = list(types_of_robocomp())


@given(st.sampled_from(TYPES), st.binary(max_size=200))
def test_any_bytes_are_a_value_or_refused(kind, data):
    try:
        value = kind.decoded(data)
    except LearnBlockError:
        return
    # A NaN does not equal itself, but its bytes do.
    if not any(isinstance(one, float) and math.isnan(one) for one in flat(value)):
        assert kind.decoded(kind.encoded(value)) == value


def flat(value):
    """Yield the leaves of a value."""
    if hasattr(value, "__dataclass_fields__"):
        value = [getattr(value, name) for name in value.__dataclass_fields__]
    if isinstance(value, dict):
        value = [*value, *value.values()]
    if isinstance(value, list | tuple | array):
        return [leaf for one in value for leaf in flat(one)]
    return [value]


@given(st.recursive(st.none() | st.booleans() | st.integers() | st.text(), st.lists, max_leaves=5))
def test_any_value_is_written_or_refused(value):
    for kind in TYPES[:40]:
        try:
            kind.encoded(value)
        except IceEncodingError:
            continue
