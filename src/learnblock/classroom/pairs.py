"""Two pupils in one world: who has invited whom, and whose program drives the second robot.

The run is the host's. The guest's program goes as text to the host's server before each run.
"""

import asyncio
import time
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import Literal, Protocol, assert_never

from learnblock.classroom.classmates import (
    Refusals,
    classmate_here,
    classmates_here,
    name_of,
)
from learnblock.classroom.desk import Desk, DeskPage
from learnblock.classroom.limits import INVITING
from learnblock.classroom.pair_messages import (
    AnswerInvitation,
    AskClassmates,
    Classmate,
    Classmates,
    FromPlayer,
    InPair,
    Invite,
    LeaveWorld,
)
from learnblock.classroom.questions import A
from learnblock.classroom.quota import Buckets
from learnblock.classroom.roster import Roster
from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase
from learnblock.server import messages

#: Seconds for which an invitation waits for its answer.
_WAITING = 60.0
#: Seconds after which a pupil without pages has left.
_GRACE = 20.0
#: What to say to the host about a project without a robot for a guest.
_LACKS = {
    "project": "class-pair-no-project",
    "lesson": "class-pair-lesson",
    "robot": "class-pair-one-robot",
}


class WorldPage(Protocol):
    """The page on which a guest sees the host's world."""

    async def ask(self, question: messages.Message, answer: type[A]) -> A | None:
        """Ask the host's server on behalf of the page; None without an answer."""

    async def send_away(self) -> None:
        """Close the page's connection for good."""

    async def replace(self) -> None:
        """Close the page's connection, since another page of the guest shows the world."""


@dataclass(eq=False)
class PupilPair:
    """A host and a guest, or a pupil who is invited.

    Args:
        host: the pupil who owns the world and the run.
        guest: the other.
        project: the name of the host's project.
        robot: the name of the guest's robot.
        until: what ends an invitation that is not answered.
        page: the page of the guest with the program; None before the invitation is accepted.
        view: where the guest sees the world; None while it is not connected.
        lock: held while the guest's program is fetched.
    """

    host: Desk
    guest: Desk
    project: str
    robot: str
    until: asyncio.TimerHandle | None = None
    page: DeskPage | None = None
    view: WorldPage | None = None
    lock: asyncio.Lock = field(default_factory=asyncio.Lock)

    @property
    def desks(self) -> tuple[Desk, Desk]:
        """Both pupils."""
        return self.host, self.guest

    def other(self, desk: Desk) -> Desk:
        """The other pupil."""
        return self.guest if desk is self.host else self.host

    def state_of(self, desk: Desk) -> Literal["inviting", "invited", "host", "guest"]:
        """What a pupil of the pair is."""
        if self.page is None:
            return "inviting" if desk is self.host else "invited"
        return "host" if desk is self.host else "guest"


# Why: docs/decisions.md, "In a shared world, the run is the host's"
class Pairs:
    """The pairs of a class; none until the teacher allows them.

    Args:
        roster: the pupils.
        desks: their desks, by their ids.
        now: returns the time of a monotonic clock in seconds.
    """

    def __init__(
        self,
        roster: Roster,
        desks: Mapping[str, Desk],
        now: Callable[[], float] = time.monotonic,
    ) -> None:
        self.allowed = False
        self._roster = roster
        self._desks = desks
        self._pairs: list[PupilPair] = []
        self._invitations = Buckets(INVITING, now)
        self._refusals = Refusals(now)
        self._leaving: dict[str, asyncio.TimerHandle] = {}
        self._ending: set[asyncio.Task[None]] = set()

    def of(self, desk: Desk) -> PupilPair | None:
        """The pair of a pupil, also of one who is only invited."""
        return next((pair for pair in self._pairs if desk in pair.desks), None)

    def as_guest(self, pupil: str) -> PupilPair | None:
        """The pair of a guest with this id."""
        pairs = (pair for pair in self._pairs if pair.page and pair.guest.pupil.id == pupil)
        return next(pairs, None)

    def news(self, desk: Desk) -> InPair:
        """With whom a pupil plays."""
        pair = self.of(desk)
        if pair is None:
            return InPair(self.allowed)
        return InPair(
            self.allowed,
            pair.state_of(desk),
            self._name(pair.other(desk)),
            pair.robot,
            away=pair.page is not None and pair.view is None,
        )

    async def heard(self, desk: Desk, page: DeskPage, message: FromPlayer) -> None:
        """Do what a pupil's page asks for.

        Raises:
            LearnBlockError: it can't be done.
        """
        match message:
            case AskClassmates():
                self._require_allowed()
                page.tell(Classmates(tuple(self._classmates(desk))))
            case Invite(pupil=pupil):
                await self._invite(desk, page, pupil)
            case AnswerInvitation(on=on):
                await self._answer(desk, page, on=on)
            case LeaveWorld():
                await self.leave(desk)
            case _:
                assert_never(message)

    def _classmates(self, desk: Desk) -> Iterator[Classmate]:
        """Who can be invited, in the order in which they joined."""
        for classmate in classmates_here(self._roster, self._desks, desk):
            if not self.of(self._desks[classmate.id]):
                yield classmate

    # Invitations.

    async def _invite(self, desk: Desk, page: DeskPage, pupil: str) -> None:
        guest = self._invited(desk, pupil)
        if self._invitations.try_take(desk.pupil.id):
            raise LearnBlockError("class-too-fast")
        robot = await page.ask(messages.FindGuestRobot(), messages.GuestRobot)
        if robot is None:
            raise LearnBlockError("class-pair-silent")
        if robot.lack:
            raise LearnBlockError(_LACKS[robot.lack])
        # Much may have happened meanwhile.
        self._invited(desk, pupil)
        pair = PupilPair(desk, guest, robot.project, robot.tab)
        pair.until = asyncio.get_running_loop().call_later(_WAITING, self._expire, pair)
        self._pairs.append(pair)
        self._tell(pair)

    def _invited(self, desk: Desk, pupil: str) -> Desk:
        """The desk of a pupil who is to be invited.

        Raises:
            LearnBlockError: the pupil can't be invited, or not now.
        """
        self._require_allowed()
        if self.of(desk):
            raise LearnBlockError("class-pair-already")
        guest = classmate_here(self._roster, self._desks, desk, pupil)
        name = self._name(guest)
        if self.of(guest):
            raise LearnBlockError("class-pair-busy", name=name)
        self._refusals.require_none(desk, guest, name)
        return guest

    async def _answer(self, desk: Desk, page: DeskPage, *, on: bool) -> None:
        self._require_allowed()
        pair = self.of(desk)
        if pair is None or pair.state_of(desk) != "invited":
            raise LearnBlockError("class-pair-no-invitation")
        if on:
            if pair.until:
                pair.until.cancel()
            pair.page = page
            self._tell(pair)
            return
        self._refusals.add(pair.host, desk)
        await self._end(pair)
        pair.host.note(Phrase("class-pair-declined", name=self._name(desk)))

    def _expire(self, pair: PupilPair) -> None:
        self._end_soon(pair, pair.host, Phrase("class-pair-silence", name=self._name(pair.guest)))

    # The end.

    async def leave(self, desk: Desk) -> None:
        """A pupil leaves the shared world, or takes an invitation back."""
        if pair := self.of(desk):
            await self._end(pair)
            if pair.page:
                pair.other(desk).note(Phrase("class-pair-left", name=self._name(desk)))

    def came(self, desk: Desk) -> None:
        """A pupil has a page again, and stays."""
        if leaving := self._leaving.pop(desk.pupil.id, None):
            leaving.cancel()

    def left(self, desk: Desk) -> None:
        """A page of a pupil has gone; with the last one the pupil leaves, after a while."""
        if not desk.own_pages and self.of(desk) and desk.pupil.id not in self._leaving:
            loop = asyncio.get_running_loop()
            self._leaving[desk.pupil.id] = loop.call_later(_GRACE, self._leave_if_gone, desk)

    def _leave_if_gone(self, desk: Desk) -> None:
        self._leaving.pop(desk.pupil.id, None)
        pair = self.of(desk)
        if pair and not desk.own_pages:
            left = Phrase("class-pair-left", name=self._name(desk))
            self._end_soon(pair, pair.other(desk), left)

    async def let(self, *, on: bool) -> None:
        """Let pupils share worlds, or no more: then all of them leave."""
        self.allowed = on
        for pair in [] if on else list(self._pairs):
            await self._end(pair)
            for desk in pair.desks:
                desk.note(Phrase("class-pair-over"))
        for desk in self._desks.values():
            desk.tell_pair()

    async def lose(self, pair: PupilPair) -> None:
        """The host's project can't be opened any more."""
        await self._end(pair)
        for desk in pair.desks:
            desk.note(Phrase("class-pair-no-world"))

    def close(self) -> None:
        """End with the class."""
        handles = [pair.until for pair in self._pairs if pair.until]
        for handle in (*handles, *self._leaving.values()):
            handle.cancel()

    async def _end(self, pair: PupilPair) -> None:
        if pair not in self._pairs:
            return
        self._pairs.remove(pair)
        if pair.until:
            pair.until.cancel()
        self._tell(pair)
        if pair.view:
            await pair.view.send_away()

    def _end_soon(self, pair: PupilPair, desk: Desk, message: Phrase) -> None:
        """End a pair, and tell one of the pupils why."""
        if pair in self._pairs:
            task = asyncio.create_task(self._end(pair))
            self._ending.add(task)
            task.add_done_callback(self._ending.discard)
            desk.note(message)

    # The run.

    def show(self, pair: PupilPair, view: WorldPage | None) -> None:
        """Note where a guest sees the world, or that nothing shows it now."""
        pair.view = view
        self._tell(pair)

    async def before_run(self, desk: Desk, page: DeskPage) -> None:
        """Fetch the guest's program before a run of the host.

        Raises:
            LearnBlockError: it can't be had.
        """
        if pair := self._hosted(desk, page):
            async with pair.lock:
                await self._fetch(pair)

    def renamed(self, desk: Desk, page: DeskPage, name: str) -> None:
        """Note that the project of a pupil's page has another name."""
        if pair := self._hosted(desk, page):
            pair.project = name

    def _hosted(self, desk: Desk, page: DeskPage) -> PupilPair | None:
        """The pair in the project that a host's page shows; the host's other projects have none."""
        pair = self.of(desk)
        if pair is None or pair.state_of(desk) != "host":
            return None
        return pair if desk.progress.work_of(page).project in ("", pair.project) else None

    async def _fetch(self, pair: PupilPair) -> None:
        name = self._name(pair.guest)
        page, view = self._page_of(pair), pair.view
        if page is None or view is None:
            raise LearnBlockError("class-pair-away", name=name)
        given = await page.ask(messages.GiveProgram(), messages.ProgramGiven)
        if given is None:
            raise LearnBlockError("class-pair-no-answer", name=name)
        if given.program is None or given.mistakes:
            pair.guest.note(Phrase("class-pair-mistakes-own", name=self._name(pair.host)))
            raise LearnBlockError("class-pair-mistakes", name=name)
        take = messages.TakeGuest(pair.guest.pupil.name, given.program)
        taken = await view.ask(take, messages.GuestTaken)
        if taken is None:
            raise LearnBlockError("class-pair-silent")
        if not taken.fits:
            pair.guest.note(Phrase("class-pair-unfit-own", robot=pair.robot))
            raise LearnBlockError("class-pair-unfit", name=name, robot=pair.robot)

    def _page_of(self, pair: PupilPair) -> DeskPage | None:
        """The page with the guest's program; after a reconnection, another one."""
        pages = pair.guest.own_pages
        if pair.page not in pages and pages:
            pair.page = pages[-1]
        return pair.page if pages else None

    # Helpers.

    def _require_allowed(self) -> None:
        if not self.allowed:
            raise LearnBlockError("class-pair-off")

    def _name(self, desk: Desk) -> str:
        return name_of(self._roster, desk)

    def _tell(self, pair: PupilPair) -> None:
        for desk in pair.desks:
            desk.tell_pair()
