"""Messages wait in order; of some kinds only the newest is kept."""

import asyncio

import pytest

from learnblock.server import messages
from learnblock.server.pages.boxes import FULL, Inbox, Outbox, OutboxFullError


def edit(number, notation="blocktext"):
    return messages.EditText(number, notation, str(number))


def telemetry(time):
    return messages.Telemetry(time, ())


def frame(time):
    return messages.CameraFrame(1, 1, time)


def taken_in(*said):
    async def take_all():
        inbox = Inbox()
        for message in said:
            await inbox.put(message)
        await inbox.close()
        return [message async for message in iterate(inbox)]

    return asyncio.run(take_all())


async def iterate(inbox):
    while (message := await inbox.take()) is not None:
        yield message


def taken_out(*told):
    async def take_all():
        outbox = Outbox()
        for message in told:
            outbox.put(*message) if isinstance(message, tuple) else outbox.put(message)
        outbox.put(messages.Printed("the end"))
        found = []
        while not found or found[-1].message != messages.Printed("the end"):
            found.append(await outbox.take())
        return [(parcel.message, parcel.data) for parcel in found[:-1]]

    return asyncio.run(take_all())


def test_messages_are_handled_in_order():
    said = (edit(1), messages.Undo(), edit(2), messages.Run())
    assert taken_in(*said) == list(said)


def test_only_the_last_waiting_edit_is_handled():
    assert taken_in(edit(1), edit(2), messages.Undo(), edit(3), edit(4)) == [
        edit(2),
        messages.Undo(),
        edit(4),
    ]


def test_edits_of_two_views_are_both_handled():
    assert taken_in(edit(1), edit(2, "python")) == [edit(1), edit(2, "python")]


def test_two_messages_of_other_kinds_are_both_handled():
    assert taken_in(messages.Undo(), messages.Undo()) == [messages.Undo()] * 2


def test_a_page_that_sends_too_much_has_to_wait():
    async def say_much():
        inbox = Inbox()
        saying = asyncio.gather(*(inbox.put(messages.Undo()) for _ in range(1000)))
        for _ in range(1000):
            assert await inbox.take() == messages.Undo()
        await saying

    asyncio.run(say_much())


def test_a_slow_page_gets_the_newest_telemetry_in_order():
    printed = messages.Printed("x")
    assert taken_out(telemetry(1), printed, telemetry(2), telemetry(3)) == [
        (telemetry(3), None),
        (printed, None),
    ]


def test_a_frame_keeps_its_picture():
    assert taken_out((frame(1), b"one"), (frame(2), b"two")) == [(frame(2), b"two")]


def test_a_page_that_reads_nothing_is_disconnected():
    async def fill():
        outbox = Outbox()
        for _ in range(2 * FULL):
            outbox.put(messages.Printed("x"))
        with pytest.raises(OutboxFullError):
            await outbox.take()

    asyncio.run(fill())
