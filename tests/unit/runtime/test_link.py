import random
import socket
import struct

import msgspec
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from msgspec import inspect

from learnblock.errors import DeviceValueError, RobotConnectionError
from learnblock.i18n import Phrase
from learnblock.runtime import messages
from learnblock.runtime.link import MAX_MESSAGE, SocketLink
from learnblock.runtime.messages import (
    LARGEST,
    Answer,
    Ask,
    Command,
    Connected,
    FromChild,
    FromHost,
    Printed,
)


@pytest.fixture
def ends():
    ours, theirs = socket.socketpair()
    with ours, theirs:
        yield SocketLink(ours, FromChild | FromHost), SocketLink(theirs, FromChild | FromHost)


@pytest.fixture
def wire():
    """Return a raw socket, and the link at its other end."""
    ours, theirs = socket.socketpair()
    with ours, theirs:
        yield ours, SocketLink(theirs, FromChild | FromHost)


texts = st.text(st.characters(exclude_categories=["Cs"]), max_size=20)
integers = st.integers(-(2**63), 2**63 - 1)
values = st.recursive(
    st.none() | st.booleans() | integers | st.floats(allow_nan=False) | texts | st.binary(),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(texts, inner, max_size=3),
    max_leaves=8,
)

# A phrase takes its code by position, which `st.builds` cannot draw by name.
phrases = st.recursive(
    st.builds(Phrase, texts),
    lambda inner: st.builds(
        lambda code, values: Phrase(code, **values),
        texts,
        st.dictionaries(
            texts,
            integers | st.floats(allow_nan=False) | texts | inner
            | st.lists(texts | inner, max_size=3).map(tuple),
            max_size=3,
        ),
    ),
    max_leaves=4,
)  # fmt: skip


def of(kind):
    fields = {one.name: values_of(one.type) for one in inspect.type_info(kind).fields}
    return st.builds(kind, **fields)


def values_of(info):  # noqa: C901, PLR0911 - one for each type
    match info:
        case inspect.IntType(ge=least, le=most):
            return st.integers(-(2**63) if least is None else least, most or 2**63 - 1)
        case inspect.FloatType(ge=least, le=most):
            return st.floats(least, most, allow_nan=False)
        case inspect.VarTupleType(item_type=item):
            return st.lists(values_of(item), max_size=9).map(tuple)
        case inspect.TupleType(item_types=items):
            return st.tuples(*map(values_of, items))
        case inspect.FrozenSetType(item_type=item):
            return st.frozensets(values_of(item), max_size=9)
        case inspect.DictType(key_type=key, value_type=value):
            return st.dictionaries(values_of(key), values_of(value), max_size=3)
        case inspect.UnionType(types=types):
            return st.one_of(*map(values_of, types))
        case inspect.LiteralType(values=choices):
            return st.sampled_from(choices)
        case inspect.EnumType(cls=cls):
            return st.sampled_from(cls)
        case inspect.DataclassType(cls=cls) if cls is Phrase:
            return phrases
        case inspect.StructType(cls=cls) | inspect.DataclassType(cls=cls):
            return of(cls)
    return PLAIN[type(info)]


PLAIN = {
    inspect.AnyType: values,
    inspect.BoolType: st.booleans(),
    inspect.BytesType: st.binary(max_size=99),
    inspect.NoneType: st.none(),
    inspect.RawType: values.map(msgspec.msgpack.encode).map(msgspec.Raw),
    inspect.StrType: texts,
}
EVERY_KIND = [
    kind
    for kind in vars(messages).values()
    if isinstance(kind, type)
    and issubclass(kind, messages.Message)
    and kind is not messages.Message
]


@pytest.mark.parametrize("kind", EVERY_KIND)
def test_every_message_arrives_unchanged(ends, kind):
    here, there = ends

    @settings(max_examples=25)
    @given(of(kind))
    def check(message):
        here.send(message)
        assert message == there.receive(1)

    check()


def test_messages_arrive_in_order(ends):
    here, there = ends
    for number in range(100):
        here.put(Answer(number))
    here.flush()
    assert [Answer(number) for number in range(100)] == [there.receive(1) for _ in range(100)]


def test_a_message_of_many_parts_arrives_whole(wire):
    ours, link = wire
    sent = _framed(msgspec.msgpack.encode(Printed("hello")))
    for byte in sent[:-1]:
        ours.sendall(bytes([byte]))
        assert link.receive(0.0001) is None
    ours.sendall(sent[-1:])
    assert link.receive(1) == Printed("hello")


def test_nothing_within_the_timeout_is_none(ends):
    assert ends[0].receive(0.001) is None


def test_a_frame_arrives_as_a_writable_picture(ends):
    here, there = ends
    frame = np.arange(2 * 3 * 3, dtype=np.uint8).reshape(2, 3, 3)
    here.send(Answer(frame))
    received = there.receive(1).value
    assert received.dtype == np.uint8
    assert np.array_equal(frame, received)
    received[0, 0, 0] = 255


def test_numbers_and_lists_of_numpy_arrive_as_plain_ones(ends):
    here, there = ends
    here.send(Answer([np.float64(1.5), np.int8(3), np.bool_(1), np.array([1.0, 2.0])]))
    assert there.receive(1).value == [1.5, 3, True, [1.0, 2.0]]


def test_any_other_object_arrives_as_its_description(ends):
    here, there = ends
    here.send(Answer(range(3)))
    assert there.receive(1).value == "range(0, 3)"


def deep(levels):
    value = []
    for _ in range(levels):
        value = [value]
    return value


@pytest.mark.parametrize(
    "value", [2**64, "\ud800", deep(10**5), {(1, 2): 3, object(): 4}.keys, "x" * (MAX_MESSAGE + 1)]
)
def test_a_value_that_cannot_be_sent_leaves_the_link_intact(ends, value):
    here, there = ends
    here.put(Answer("before"))
    try:
        here.put(Command(0, "say", (value,)))
    except DeviceValueError:
        here.put(Answer("refused"))
    here.put(Answer("after"))
    here.flush()
    arrived = [there.receive(1) for _ in range(3)]
    assert (Answer("before"), Answer("after")) == (arrived[0], arrived[2])


def test_a_cyclic_list_cannot_be_sent(ends):
    circle = []
    circle.append(circle)
    with pytest.raises(DeviceValueError) as refused:
        ends[0].put(Answer(circle))
    assert refused.value.phrase.code == "run-value-not-sendable"


def test_a_message_that_is_too_long_is_refused_before_it_is_sent(ends):
    with pytest.raises(DeviceValueError) as refused:
        ends[0].put(Printed("x" * (LARGEST + 1)))
    assert refused.value.phrase.code == "run-value-too-large"
    assert refused.value.phrase.values["limit"] == LARGEST


def test_a_program_may_show_a_picture_as_large_as_a_frame_and_nothing_else(ends):
    here, there = ends
    frame = np.full((300, 400, 3), 7, np.uint8)
    with pytest.raises(DeviceValueError):
        here.put(Command(0, "show_image", (frame, frame)))
    # No socket buffers it all at once.
    here.put(Command(0, "show_image", (frame,)))
    there._received += here._outgoing
    there._split()
    assert np.array_equal(frame, there.receive(1).args[0])
    there._received += _framed(msgspec.msgpack.encode(["Command", 0, "say", ["x" * LARGEST]]))
    with pytest.raises(RobotConnectionError):
        there._split()


def test_the_largest_frame_passes(ends):
    here, there = ends
    frame = np.zeros((1080, 1920, 3), np.uint8)
    here.put(Answer(frame))
    # In parts, because no socket buffers it all at once.
    queued, here._outgoing = bytes(here._outgoing), bytearray()
    there._received += queued
    there._split()
    assert there.receive(1).value.shape == (1080, 1920, 3)


def test_a_closed_link_ends_the_conversation_for_both(ends):
    here, there = ends
    here.close()
    with pytest.raises(EOFError, match="the other end of the link is gone"):
        there.receive(1)
    with pytest.raises(EOFError):
        here.receive(1)
    with pytest.raises(EOFError):
        there.send(Answer("x" * 10**6))


def _framed(body):
    return struct.pack(">I", len(body)) + body


WRONG = {
    "empty": _framed(b""),
    "not msgpack": _framed(b"\xc1"),
    "another type": _framed(msgspec.msgpack.encode(42)),
    "an unknown tag": _framed(msgspec.msgpack.encode(["Explode"])),
    "no tag": _framed(msgspec.msgpack.encode([])),
    "too few fields": _framed(msgspec.msgpack.encode(["Ask", 1])),
    "a field of another type": _framed(msgspec.msgpack.encode(["Sleep", "long"])),
    "cut short": _framed(msgspec.msgpack.encode(Printed("hello"))[:-2]),
    "too much": _framed(msgspec.msgpack.encode(Printed("hello")) + b"\0"),
    "no UTF-8": _framed(b"\x92\xa7Printed\xa1\xff"),
    "a key that is a map": _framed(b"\x92\xa6Answer\x81\x80\x02"),
    "too long": struct.pack(">I", MAX_MESSAGE + 1),
    "the longest length": b"\xff\xff\xff\xff",
    "too deep": _framed(b"\x92\xa6Answer" + b"\x91" * 10**6 + b"\x01"),
    "a list of 4 billion": _framed(b"\x92\xa6Answer\xdd\xff\xff\xff\xff"),
    "an unknown extension": _framed(b"\x92\xa6Answer\xc7\x01\x05x"),
    "an extension without a shape": _framed(b"\x92\xa6Answer\xc7\x01\x01x"),
    "a frame too small for its shape": _framed(
        b"\x92\xa6Answer\xc7\x0d\x01" + struct.pack(">III", 9**9, 9**9, 3) + b"x"
    ),
}


@pytest.mark.parametrize("name", WRONG)
def test_invalid_data_is_refused(name):
    ours, theirs = socket.socketpair()
    with ours, theirs:
        link = SocketLink(theirs, FromHost | FromChild)
        ours.setblocking(False)
        with pytest.raises(RobotConnectionError):
            _push(ours, WRONG[name], link)


def _push(connection, data, link):
    """Send all of `data` through a socket that may not buffer it, to a link that sends nothing."""
    while True:
        data = data[connection.send(data) :] if data else data
        assert link.receive(0.01) is None


def test_thousands_of_damaged_messages_give_messages_or_refusals_and_nothing_else():
    rng = random.Random(0)  # noqa: S311 - not a secret
    good = [
        msgspec.msgpack.encode(message)
        for message in (
            Ask(3, "read", (1.5, "x", None)),
            Connected(
                (messages.DeviceOffer("Base", "ROBOT", ("move",)),), frozenset({"Base"}), 7, 0.01, 0
            ),
            messages.Called("turn", (90,), {"speed": [1, {"a": b"b"}]}),
            messages.Ended(messages.Fault("ValueError", "wrong", (1, 2))),
            messages.Steps(tuple(range(300))),
        )
    ]
    arrived = refused = 0
    for _ in range(4000):
        link = SocketLink(None, FromHost | FromChild)
        link._received += _damaged(rng, rng.choice(good))
        try:
            link._split()
        except RobotConnectionError:
            refused += 1
        arrived += len(link._messages)
    assert refused > 1000
    assert arrived > 100


def _damaged(rng, message):
    data = bytearray(_framed(message) if rng.random() < 0.8 else message)
    for _ in range(rng.randint(1, 4)):
        place = rng.randrange(len(data))
        match rng.randrange(3):
            case 0:
                data[place] = rng.randrange(256)
            case 1:
                del data[place : place + rng.randint(1, 5)]
            case _:
                data[place:place] = rng.randbytes(rng.randint(1, 5))
        data = data or bytearray(1)
    return data
