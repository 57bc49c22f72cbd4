"""The messages of Ice's protocol, and invalid ones."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from learnblock.errors import IceEncodingError, IceRefusedError, LearnBlockError
from learnblock.ice.encoding import Writer
from learnblock.ice.interface import Mode
from learnblock.ice.messages import (
    HEADER,
    LARGEST,
    MessageKind,
    Status,
    failure,
    message,
    not_there,
    open_reply,
    read_header,
    read_reply,
    read_request,
    refusal,
    reply,
    request,
    request_opening,
)
from learnblock.ice.types import Refusal

NO_MOVE = "'base' has no operation 'move'"
#: A ping, byte for byte as in ZeroC's manual.
PING = bytes.fromhex(
    "49636550 01000100 00 00 2a00000001000000 046261736500 00 086963655f70696e67 01 00 060000000101"
)


def test_a_request_has_the_bytes_of_the_manual():
    opening = request_opening("base", "ice_ping", Mode.NONMUTATING)
    empty = Writer().encapsulated()
    assert request(1, opening, empty) == PING


def asked(body=None, version=(1, 1)):
    writer = Writer(version)
    opening = request_opening("base", "move", Mode.NORMAL)
    return read_request(body or request(5, opening, writer.encapsulated())[HEADER.size :])


def test_a_request_survives_a_round_trip():
    found = asked()
    assert (found.number, found.identity, found.facet) == (5, "base", ())
    assert (found.operation, found.mode, found.parameters.left) == ("move", 0, 0)


def answered(data):
    """Return the decoded reply to a message."""
    kind, size = read_header(data[: HEADER.size])
    assert (kind, size) == (MessageKind.REPLY, len(data) - HEADER.size)
    number, body = read_reply(data[HEADER.size :])
    assert number == 5
    return open_reply(body)


def test_a_reply_contains_the_results():
    gives = Writer()
    gives.text("well")
    assert answered(reply(asked(), gives)).text() == "well"


@pytest.mark.parametrize("version", [(1, 0), (1, 1)])
def test_a_user_exception_is_read_in_both_encodings(version):
    known = Refusal("::RoboCompDisplay::HardwareFailedException")
    with pytest.raises(IceRefusedError, match="it is dark") as caught:
        answered(refusal(asked(version=version), known, "it is dark"))
    assert caught.value.kind == known.type_id


@pytest.mark.parametrize(
    ("data", "kind", "sentence"),
    [
        (
            not_there(asked(), Status.NO_OBJECT),
            "ObjectNotExistException",
            NO_MOVE,
        ),
        (
            not_there(asked(), Status.NO_FACET),
            "FacetNotExistException",
            NO_MOVE,
        ),
        (
            not_there(asked(), Status.NO_OPERATION),
            "OperationNotExistException",
            NO_MOVE,
        ),
        (failure(asked(), Status.UNKNOWN, "a\nb: c\n"), "UnknownException", "^b: c$"),
        (failure(asked(), Status.UNKNOWN, ""), "UnknownException", "UnknownException"),
    ],
)
def test_the_reason_for_a_missing_reply_is_reported_by_ices_name(data, kind, sentence):
    with pytest.raises(IceRefusedError, match=sentence) as caught:
        answered(data)
    assert caught.value.kind == kind


@pytest.mark.parametrize(
    ("header", "sentence"),
    [
        (b"HTTP/1.1 200 O", "not an Ice message"),
        (HEADER.pack(b"IceP", 2, 0, 1, 0, 0, 0, 14), "not an Ice message"),
        (HEADER.pack(b"IceP", 1, 0, 1, 0, 7, 0, 14), "not an Ice message"),
        (HEADER.pack(b"IceP", 1, 0, 1, 0, 2, 2, 14), "compressed"),
        (HEADER.pack(b"IceP", 1, 0, 1, 0, 2, 0, 13), "The message has 13 bytes"),
        (HEADER.pack(b"IceP", 1, 0, 1, 0, 2, 0, LARGEST + 1), f"at most {LARGEST:,} are allowed"),
    ],
)
def test_bytes_that_are_not_a_message_are_rejected(header, sentence):
    with pytest.raises(IceEncodingError, match=sentence):
        read_header(header)


def test_a_message_that_is_only_a_header_has_no_content():
    assert read_header(message(MessageKind.VALIDATE)) == (MessageKind.VALIDATE, 0)


@given(st.binary(min_size=HEADER.size, max_size=HEADER.size), st.binary(max_size=100))
def test_any_bytes_are_a_message_or_refused(header, body):
    for read in (
        lambda: read_header(header),
        lambda: read_request(body),
        lambda: open_reply(read_reply(body)[1]),
    ):
        try:
            read()
        except LearnBlockError:
            continue
