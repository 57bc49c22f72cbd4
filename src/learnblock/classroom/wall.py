"""The teacher's wall and the projector: one stream each, at most twice a second."""

import asyncio
from collections.abc import Iterator
from contextlib import suppress
from typing import Protocol

import msgspec
from starlette.websockets import WebSocket, WebSocketDisconnect

from learnblock.classroom import messages as ours
from learnblock.classroom.hand_in_messages import HandInSteps, WaitingHandIns
from learnblock.classroom.room import Room
from learnblock.classroom.roster import MORE, names_of
from learnblock.classroom.teaching import do
from learnblock.errors import LearnBlockError, phrase_of
from learnblock.server.messages import Scene

#: Seconds between two looks at the class.
_PERIOD = 0.5
#: Seconds after which the times are looked at again, even if nothing happens.
_LONGEST_REST = 1.0
#: The limit of a message of the teacher in characters.
_LARGEST = 10_000
_decoder = msgspec.json.Decoder(ours.FromTeacher)


class View(Protocol):
    """What a board shows."""

    def news(self, room: Room) -> Iterator[msgspec.Struct]:
        """The messages about what has changed since the last time."""


class Board:
    """A page that shows the class.

    Args:
        socket: its websocket, accepted.
        room: the class.
        view: what it shows.
    """

    def __init__(self, socket: WebSocket, room: Room, view: View) -> None:
        self._socket = socket
        self._room = room
        self._view = view
        self._woken = asyncio.Event()
        self._woken.set()

    def wake(self) -> None:
        """Look at the class again."""
        self._woken.set()

    async def serve(self) -> None:
        """Show the class until the page has gone."""
        self._room.boards.add(self)
        showing = asyncio.create_task(self._show())
        try:
            with suppress(WebSocketDisconnect):
                while (received := await self._socket.receive())["type"] == "websocket.receive":
                    await self._do(received.get("text") or "")
        finally:
            self._room.boards.discard(self)
            showing.cancel()
            await asyncio.gather(showing, return_exceptions=True)

    async def _do(self, text: str) -> None:
        try:
            if len(text) > _LARGEST:
                raise LearnBlockError("server-message-too-long", count=len(text))
            answer = await do(self._room, _decoder.decode(text))
        except (LearnBlockError, OSError, ValueError) as error:
            await self._send(ours.Refused(phrase_of(error)))
        else:
            if answer:
                await self._send(answer)

    async def _show(self) -> None:
        while True:
            self._woken.clear()
            for message in self._view.news(self._room):
                await self._send(message)
            await asyncio.sleep(_PERIOD)
            with suppress(TimeoutError):
                await asyncio.wait_for(self._woken.wait(), _LONGEST_REST)

    async def _send(self, message: msgspec.Struct) -> None:
        await self._socket.send_text(msgspec.json.encode(message).decode())


class WallView:
    """All pupils, for the teacher; only what has changed is sent."""

    def __init__(self) -> None:
        self._wall: ours.Wall | None = None
        self._offers: tuple[ours.LessonOffer, ...] | None = None
        self._seats: dict[str, ours.Seat] = {}
        self._scenes: dict[str, Scene] = {}
        self._marking = MarkingView()
        self._waiting: WaitingHandIns | None = None

    def news(self, room: Room) -> Iterator[msgspec.Struct]:
        """What has changed since the last time."""
        if self._offers is not room.offers:
            self._offers = room.offers
            yield ours.Offers(room.offers)
        wall = _wall(room)
        if wall != self._wall:
            self._wall = wall
            yield wall
        names = names_of(room.roster.pupils)
        # A pupil who is just being deleted still has a desk.
        desks = {pupil: room.desks[pupil] for pupil in names if pupil in room.desks}
        seats = {
            pupil: msgspec.structs.replace(desk.seat(), name=names[pupil])
            for pupil, desk in desks.items()
        }
        for pupil, desk in desks.items():
            plan = room.plan(desk)
            if plan and self._scenes.get(pupil) is not plan.scene:
                self._scenes[pupil] = plan.scene
                yield plan
        known = self._seats
        if changed := [seat for seat in seats.values() if known.get(seat.id) != seat]:
            yield ours.Seats(tuple(_news(seat, known.get(seat.id)) for seat in changed))
        self._seats = seats
        places = {pupil: desk.progress.place for pupil, desk in desks.items()}
        waiting = room.marking.waiting(places)
        if waiting != self._waiting:
            self._waiting = waiting
            yield waiting
        yield from self._marking.news(room)


class MarkingView:
    """How many have handed in what; the page asks for the rest."""

    def __init__(self) -> None:
        self._steps: HandInSteps | None = None

    def news(self, room: Room) -> Iterator[msgspec.Struct]:
        """What has changed since the last time."""
        steps = room.marking.steps(room.taught)
        if steps != self._steps:
            self._steps = steps
            yield steps


def _news(seat: ours.Seat, before: ours.Seat | None) -> ours.Seat:
    """A seat without the beginning of its way, if the wall knows that."""
    kept = len(before.way) if before else 0
    if not before or seat.way[:kept] != before.way:
        return seat
    return msgspec.structs.replace(seat, way=seat.way[kept:], kept=kept)


class ProjectorView:
    """How to join, or one pupil's world without the name."""

    def __init__(self) -> None:
        self._shown: ours.Projected | None = None

    def news(self, room: Room) -> Iterator[msgspec.Struct]:
        """What has changed since the last time."""
        shown = _projected(room)
        if shown != self._shown:
            self._shown = shown
            yield shown


def _wall(room: Room) -> ours.Wall:
    roster = room.roster
    return ours.Wall(
        title=roster.title,
        word=room.word,
        address=room.address,
        open=roster.is_open,
        eyes_up=room.eyes_up,
        more=MORE,
        projected=room.projected or "",
        pupils=tuple(pupil.id for pupil in roster.pupils),
        lesson=room.lesson,
        began=room.began,
        knocking=tuple(room.knocking),
        sharing=room.pairs.allowed,
        showing=room.shown_programs.allowed,
        shown=room.shown_programs.shown,
    )


def _projected(room: Room) -> ours.Projected:
    roster = room.roster
    here = sum(bool(desk.own_pages) for desk in room.desks.values())
    shown = ours.Projected(
        roster.title,
        room.word,
        room.address,
        roster.is_open,
        here=here,
        joined=len(roster.pupils),
    )
    desk = room.desks.get(room.projected or "")
    if desk is None:
        return shown
    seat = msgspec.structs.replace(
        desk.seat(),
        name="",
        project="",
        id="",
        question="",
        quiet=0,
        stuck=0,
        hand_in="",
        shows="",
        shows_since=0,
    )
    plan = desk.progress.plan_of("")
    return msgspec.structs.replace(shown, seat=seat, plan=plan)
