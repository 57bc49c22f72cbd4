"""What the teacher does at the wall."""

import asyncio
from collections.abc import Awaitable, Callable, Mapping
from typing import Any

from learnblock.classroom import messages as ours
from learnblock.classroom.room import Room
from learnblock.server import messages

Handler = Callable[[Room, Any], Awaitable[ours.NewPin | None]]


async def do(room: Room, message: ours.FromTeacher) -> ours.NewPin | None:
    """Do what the teacher wants; return a pupil's new pictures, if any.

    Raises:
        LearnBlockError: it can't be done.
        OSError: it can't be saved.
    """
    answer = await _HANDLERS[type(message)](room, message)
    room.changed()
    return answer


async def _eyes_up(room: Room, message: ours.EyesUp) -> None:
    room.rest(eyes_up=message.on)


async def _stop_all(room: Room, _: ours.StopAll) -> None:
    await room.order(messages.Stop())


async def _send_hint(room: Room, message: ours.SendHint) -> None:
    pupil = None if message.pupil is None else room.known(message.pupil)
    for desk in room.desks.values() if pupil is None else [room.desk(pupil)]:
        desk.help(message.text)


async def _hand_out(room: Room, message: ours.HandOut) -> None:
    await room.hand_out(messages.StartLesson(message.lesson, message.project))


async def _renew_pin(room: Room, message: ours.RenewPin) -> ours.NewPin:
    pupil = room.known(message.pupil)
    return ours.NewPin(pupil.name, await room.renew_pin(pupil))


async def _remove(room: Room, message: ours.RemovePupils) -> None:
    for pupil in [room.known(pupil_id) for pupil_id in message.pupils]:
        await room.remove(pupil)


async def _let_join(room: Room, message: ours.LetJoin) -> None:
    await asyncio.to_thread(room.roster.let_join, open=message.on)


async def _answer_knocking(room: Room, message: ours.AnswerKnocking) -> None:
    if message.on:
        await asyncio.to_thread(room.roster.expect_more)
    room.knocking.clear()


async def _renew_word(room: Room, _: ours.RenewWord) -> None:
    await asyncio.to_thread(room.roster.renew_word)


async def _project(room: Room, message: ours.ShowOnProjector) -> None:
    room.projected = None if message.pupil is None else room.known(message.pupil).id


_HANDLERS: Mapping[type, Handler] = {
    ours.EyesUp: _eyes_up,
    ours.StopAll: _stop_all,
    ours.SendHint: _send_hint,
    ours.HandOut: _hand_out,
    ours.RenewPin: _renew_pin,
    ours.RemovePupils: _remove,
    ours.LetJoin: _let_join,
    ours.AnswerKnocking: _answer_knocking,
    ours.RenewWord: _renew_word,
    ours.ShowOnProjector: _project,
}
