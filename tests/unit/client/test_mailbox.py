import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st

from learnblock.client.mailbox import LARGEST_VALUE, MOST_WAITING, Mailbox, checked
from learnblock.errors import DeviceValueError

TEXTS = st.text(st.characters(codec="utf-8"), max_size=20)
VALUES = st.recursive(
    st.none()
    | st.booleans()
    | st.integers(-(2**63), 2**63 - 1)
    | st.floats(allow_nan=False)
    | TEXTS,
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(TEXTS, inner, max_size=4),
    max_leaves=10,
)


def with_waiting(*messages):
    """A mailbox that has just received these messages."""
    arriving = [messages]
    return Mailbox(collect=lambda: arriving.pop() if arriving else ())


@given(VALUES)
def test_a_value_arrives_as_it_was_sent(value):
    name, plain = checked("go", value)
    assert (name, plain) == ("go", value)
    assert msgspec.msgpack.decode(msgspec.msgpack.encode(plain)) == value


def deep(levels):
    value = []
    for _ in range(levels):
        value = [value]
    return value


@pytest.mark.parametrize(
    "value",
    [
        object(), 2**63, {1: 2}, {3, 4}, "\ud800", {"\ud800": 1}, deep(20), 1j, b"bytes", len,
        [object()], "x" * LARGEST_VALUE, ["x" * 100] * 41,
    ],
)  # fmt: skip
def test_a_value_that_is_no_plain_data_or_too_large_is_refused(value):
    with pytest.raises(DeviceValueError, match="message"):
        checked("go", value)


@pytest.mark.parametrize("name", ["", "x" * 101, 5, None, "\ud800", ["go"]])
def test_the_name_of_a_message_is_a_short_text(name):
    with pytest.raises(DeviceValueError, match="a text of 1 to 100 characters"):
        checked(name, 1)


def test_each_message_is_taken_once_in_the_order_of_arrival():
    mailbox = with_waiting(("go", 1), ("stop", 2), ("go", 3))
    taken = []
    while mailbox.take("go"):
        taken.append(mailbox.value("go"))
    assert taken == [1, 3]
    assert mailbox.take("stop")
    assert mailbox.value("stop") == 2
    assert mailbox.value("go") == 3
    assert mailbox.value("never") is None


def test_in_a_snapshot_every_question_about_a_name_has_the_same_answer():
    mailbox = with_waiting(("go", 1), ("go", 2))
    with mailbox.snapshot():
        assert [mailbox.take("go"), mailbox.take("go"), mailbox.take("stop")] == [True, True, False]
        assert mailbox.value("go") == 1
    with mailbox.snapshot():
        assert mailbox.take("go")
    assert mailbox.value("go") == 2
    assert not mailbox.take("go")


def test_only_the_newest_messages_wait():
    mailbox = with_waiting(*(("go", number) for number in range(MOST_WAITING + 5)))
    assert mailbox.take("go")
    assert mailbox.value("go") == 5


def test_a_robot_that_is_alone_may_send_and_receives_nothing():
    mailbox = Mailbox()
    mailbox.send("go", 1)
    assert not mailbox.take("go")
    with pytest.raises(DeviceValueError):
        mailbox.send("go", object())
