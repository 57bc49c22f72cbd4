"""What the teacher does at the wall."""

import asyncio
from collections.abc import Awaitable, Callable, Mapping
from functools import partial
from typing import Any

from learnblock.classroom import hand_in_messages as hand_ins
from learnblock.classroom import messages as ours
from learnblock.classroom.pair_messages import LetShareWorlds
from learnblock.classroom.room import Room
from learnblock.classroom.show_messages import LetShowPrograms
from learnblock.server import messages

Handler = Callable[[Room, Any], Awaitable[ours.ToTeacher | None]]


async def do(room: Room, message: ours.FromTeacher) -> ours.ToTeacher | None:
    """Do what the teacher wants; return what answers it, if anything does.

    Raises:
        LearnBlockError: it can't be done.
        OSError: it can't be saved.
    """
    answer = await _HANDLERS[type(message)](room, message)
    room.changed()
    return answer


async def _eyes_up(room: Room, message: ours.EyesUp) -> None:
    await room.rest(eyes_up=message.on)


async def _stop_all(room: Room, _: ours.StopAll) -> None:
    await room.order(messages.Stop())


async def _send_hint(room: Room, message: ours.SendHint) -> None:
    pupil = None if message.pupil is None else room.known(message.pupil)
    for desk in room.desks.values() if pupil is None else [room.desk(pupil)]:
        desk.help(message.text)


async def _hand_out(room: Room, message: ours.HandOut) -> None:
    start = messages.StartLesson(message.lesson, message.project, step=message.step)
    pupils = None if message.pupils is None else map(room.known, message.pupils)
    await room.hand_out(start, pupils)


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


async def _let_share(room: Room, message: LetShareWorlds) -> None:
    await room.pairs.let(on=message.on)


async def _let_show(room: Room, message: LetShowPrograms) -> None:
    room.shown_programs.let(on=message.on)


async def _list_hand_ins(room: Room, message: hand_ins.ReadHandIns) -> hand_ins.HandInList:
    return await asyncio.to_thread(room.marking.listed, message.lesson, message.step)


async def _show_hand_in(room: Room, message: hand_ins.ReadHandIn) -> hand_ins.ShownHandIn:
    pupil = room.known(message.pupil)
    return await asyncio.to_thread(room.marking.shown, pupil.id, message.lesson, message.step)


async def _collect(room: Room, message: hand_ins.CollectHandIns) -> hand_ins.HandInList:
    await asyncio.to_thread(room.marking.collect, message.lesson, message.step)
    await room.gather(message.lesson, message.step)
    for desk in room.desks.values():
        desk.tell_hand_ins()
    return await asyncio.to_thread(room.marking.listed, message.lesson, message.step)


async def _check(room: Room, message: hand_ins.CheckHandIns) -> None:
    room.marking.checking.start(message.lesson, message.step)


async def _end_checking(room: Room, _: hand_ins.EndChecking) -> None:
    room.marking.checking.stop()


async def _mark(room: Room, message: hand_ins.MarkHandIn) -> hand_ins.HandInList:
    pupil, (lesson, step) = room.known(message.pupil), (message.lesson, message.step)
    save = partial(room.hand_ins.say, note=message.note, mark=message.mark, line=message.line)
    await asyncio.to_thread(save, pupil.id, lesson, step)
    return await asyncio.to_thread(room.marking.listed, lesson, step)


async def _hand_back(room: Room, message: hand_ins.HandBack) -> hand_ins.HandInList:
    pupils = [room.known(pupil) for pupil in message.pupils]
    ids = [pupil.id for pupil in pupils]
    await asyncio.to_thread(room.marking.hand_back, message.lesson, message.step, ids)
    for pupil in pupils:
        room.desk(pupil).tell_hand_ins()
    return await asyncio.to_thread(room.marking.listed, message.lesson, message.step)


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
    LetShareWorlds: _let_share,
    LetShowPrograms: _let_show,
    hand_ins.ReadHandIns: _list_hand_ins,
    hand_ins.ReadHandIn: _show_hand_in,
    hand_ins.CollectHandIns: _collect,
    hand_ins.CheckHandIns: _check,
    hand_ins.EndChecking: _end_checking,
    hand_ins.MarkHandIn: _mark,
    hand_ins.HandBack: _hand_back,
}
