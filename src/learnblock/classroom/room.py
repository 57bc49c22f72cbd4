"""The classroom: the pupils' desks, and what the teacher does for all of them."""

import asyncio
import time
from collections.abc import Iterable
from pathlib import Path
from typing import Protocol

from learnblock.classroom.desk import Desk
from learnblock.classroom.hand_in_messages import HandInRun
from learnblock.classroom.hand_in_runs import HandInRuns, wanted_run
from learnblock.classroom.hand_ins import HandInShelf
from learnblock.classroom.lesson_works import LessonWorkFile
from learnblock.classroom.lesson_worlds import LessonWorlds
from learnblock.classroom.marking import Marking
from learnblock.classroom.messages import LessonOffer, Plan
from learnblock.classroom.offers import give_lesson, lesson_gift
from learnblock.classroom.pairs import Pairs
from learnblock.classroom.pins import Picture
from learnblock.classroom.pupil_folder import PROJECTS
from learnblock.classroom.roster import Pupil, Roster
from learnblock.classroom.servers import PupilServers, ServerAddress, Servers
from learnblock.classroom.shown_programs import ShownPrograms
from learnblock.errors import LearnBlockError
from learnblock.project.files.folder import ProjectFolder
from learnblock.server import messages

#: The most names of new pupils who have asked to be let in; there are not that many children.
_MOST_KNOCKING = 10
#: Seconds after which the server of a pupil without pages is stopped.
_GRACE = 120.0


class RoomBoard(Protocol):
    """A page that shows the class: a wall, or a projector."""

    def wake(self) -> None:
        """Look at the class again."""


class Room:
    """A class that is open.

    Args:
        roster: the pupils.
        address: by which pupils reach the class.
        offers: the lessons that can be handed out.
        servers: what starts the servers of pupils whom a hub lets in; None if they come by the word
            of the class, and their servers run here.
    """

    def __init__(
        self,
        roster: Roster,
        address: str,
        offers: Iterable[LessonOffer] = (),
        servers: PupilServers | None = None,
    ) -> None:
        self.roster = roster
        self.hand_ins = HandInShelf(roster.folder)
        self.marking = Marking(roster, self.hand_ins, self.changed)
        self.address = address
        self.offers = tuple(offers)
        #: The name of the lesson on; empty without one.
        self.lesson = roster.lesson or ""
        #: When a lesson was handed out last, in seconds since 1970.
        self.began = 0.0
        self._lesson_worlds = LessonWorlds()
        #: What opens lessons that were handed out to pupils who were not here, by their ids.
        self._late: dict[str, tuple[messages.Message, ...]] = {}
        self.eyes_up = False
        self.projected: str | None = None
        #: The first names of new pupils whom the teacher has to let in.
        self.knocking: list[str] = []
        #: The walls and projectors that are open.
        self.boards: set[RoomBoard] = set()
        self.desks: dict[str, Desk] = {}
        self.pairs = Pairs(roster, self.desks)
        self.shown_programs = ShownPrograms(roster, self.desks, self.changed)
        #: Whether a hub lets pupils in and starts their servers.
        self.is_hubs = servers is not None
        self._servers = servers or Servers(lambda _: self.changed(), roster.blocks)
        #: Where hand-ins run: here, too, when a hub starts the servers of pupils.
        self._run_servers = Servers(lambda _: None) if servers else self._servers
        self.hand_in_runs = HandInRuns(roster.folder, self._run_servers, self._give)
        self._ending: dict[str, asyncio.Task[None]] = {}
        for pupil in roster.pupils:
            self._seat(pupil)

    async def open(self) -> None:
        """Get ready to start pupils' servers."""
        # A class that was killed has left it.
        await asyncio.to_thread(self.hand_in_runs.delete)
        await self._lesson_worlds.read(self.lesson)
        for servers in self._all_servers:
            await servers.open()

    @property
    def _all_servers(self) -> tuple[PupilServers, ...]:
        return (self._servers, self._run_servers) if self.is_hubs else (self._servers,)

    @property
    def is_saved(self) -> bool:
        """Whether every server has saved everything, once the class is closed."""
        return self._servers.are_saved

    def end(self) -> None:
        """Start no more servers, because the class is about to close."""
        for servers in self._all_servers:
            servers.refuse()

    async def close(self) -> None:
        """Have every server save everything and end."""
        for task in self._ending.values():
            task.cancel()
        self.pairs.close()
        await self.marking.checking.close()
        for servers in self._all_servers:
            await servers.close()
        await self.hand_in_runs.close()

    def hurry(self) -> None:
        """Have every server save and end at once; from another thread than the event loop's."""
        for servers in self._all_servers:
            servers.hurry()

    def changed(self) -> None:
        """Have the walls look at the class again."""
        for board in self.boards:
            board.wake()

    def knock(self, name: str) -> None:
        """A new pupil has asked to be let in."""
        if name not in self.knocking and len(self.knocking) < _MOST_KNOCKING:
            self.knocking.append(name)
            self.changed()

    def desk(self, pupil: Pupil) -> Desk:
        """The desk of a pupil; a new pupil gets one."""
        return self.desks.get(pupil.id) or self._seat(pupil)

    def plan(self, desk: Desk) -> Plan | None:
        """The world of a pupil, or until it is known that of the lesson that was handed out."""
        if known := desk.progress.plan_of(desk.pupil.id):
            return known
        scene = self._lesson_worlds.of(*desk.handed_out)
        return Plan(desk.pupil.id, 0, scene) if scene else None

    async def place(self, pupil: Pupil) -> ServerAddress:
        """The place of a pupil's server, which is started if it is not running.

        Raises:
            LearnBlockError: it does not start, or the class ends.
        """
        if ending := self._ending.pop(pupil.id, None):
            ending.cancel()
        return await self._servers.place(pupil.id, self.roster.folder_of(pupil))

    async def hand_out(
        self, lesson: messages.StartLesson, pupils: Iterable[Pupil] | None = None
    ) -> None:
        """Open a lesson on pupils' pages; of those who are not here, when they come.

        Args:
            lesson: the lesson.
            pupils: who gets it; None for all.

        Raises:
            LearnBlockError: it is one of the teacher's own, and can't be read.
            OSError: it can't be given to the pupils.
        """
        receiving = tuple(self.roster.pupils if pupils is None else pupils)
        orders = await self._handing_out(lesson, receiving)
        # What a few get besides is not the lesson of the class.
        if pupils is None or 2 * len(receiving) > len(self.roster.pupils):
            self.lesson, self.began = lesson.lesson, time.time()
        self._late |= {pupil.id: orders for pupil in receiving if not self.desk(pupil).own_pages}
        step = lesson.step or 1
        for pupil in receiving:
            self.desk(pupil).hand_out(lesson.lesson, step)
        await asyncio.gather(
            *(self.desk(pupil).order(*orders) for pupil in receiving),
            self._lesson_worlds.read(lesson.lesson, step),
        )

    async def first_lesson(self, pupil: Pupil) -> tuple[messages.Message, ...]:
        """What opens the lesson with which a pupil begins; empty without one, or with a project.

        Raises:
            LearnBlockError: it is one of the teacher's own, and can't be read.
            OSError: it can't be given to the pupil.
        """
        if handed_out := self._late.pop(pupil.id, None):
            return handed_out
        lesson, project = self.roster.lesson, self.roster.project
        if lesson is None or await asyncio.to_thread(self._has_begun, pupil):
            return ()
        return await self._handing_out(messages.StartLesson(lesson, project or lesson), [pupil])

    async def _handing_out(
        self, start: messages.StartLesson, pupils: Iterable[Pupil]
    ) -> tuple[messages.Message, ...]:
        """Give pupils a lesson if it is the teacher's own; return what opens it on their servers.

        At a hub their folders are elsewhere, so the lesson is part of what their servers are sent.
        """
        if not self.is_hubs:
            await self._give(start.lesson, map(self.roster.folder_of, pupils))
        elif self._is_own(start.lesson):
            return await asyncio.to_thread(lesson_gift, start.lesson), start
        return (start,)

    async def _give(self, lesson: str, folders: Iterable[Path]) -> None:
        """Put a lesson into folders of servers here if it is one of the teacher's own."""
        if self._is_own(lesson):
            await asyncio.to_thread(give_lesson, lesson, folders)

    def _is_own(self, lesson: str) -> bool:
        return any(offer.own for offer in self.offers if offer.name == lesson)

    def left(self, pupil: Pupil) -> None:
        """Record that a page has gone; after the last one, the server is stopped with a delay."""
        self.pairs.left(self.desk(pupil))
        if not self.desk(pupil).pages and pupil.id not in self._ending:
            self._ending[pupil.id] = asyncio.create_task(self._end_later(pupil))

    def known(self, id: str) -> Pupil:  # noqa: A002 - as in `Pupil`
        """The pupil with this id.

        Raises:
            LearnBlockError: there is none, or not any more.
        """
        pupil = self.roster.find(id)
        if pupil is None:
            raise LearnBlockError("class-no-pupil")
        return pupil

    def wanted_run(
        self, pupil: str, lesson: str, step: str, *, is_teacher: bool
    ) -> tuple[Pupil, HandInRun]:
        """Whose hand-in it is, and what its reader sees run of it; this reads a file.

        Raises:
            LearnBlockError: it is not there.
            ValueError: the step is no number.
        """
        known = self.known(pupil)
        place = lesson, int(step)
        # The name of a lesson is the name of a file only if it is one that was handed in.
        if place not in self.hand_ins.of_pupil(known.id):
            raise LearnBlockError("class-not-handed-in")
        file = self.hand_ins.known(known.id, *place)
        return known, wanted_run(file, is_teacher=is_teacher)

    async def rest(self, *, eyes_up: bool) -> None:
        """Pause all pages because the teacher speaks, or resume them."""
        self.eyes_up = eyes_up
        await asyncio.gather(*(desk.rest(eyes_up=eyes_up) for desk in self.desks.values()))

    @property
    def word(self) -> str:
        """The word by which pupils join; empty if a hub lets them in."""
        return "" if self.is_hubs else self.roster.word

    async def gather(self, lesson: str, step: int) -> None:
        """Have pupils' servers hand in the programs that are open in a step, if none was handed in.

        Where pupils' folders are here, they are read instead.
        """
        if not self.is_hubs:
            return
        desks = [
            desk
            for desk in self.desks.values()
            if desk.progress.place == (lesson, step)
            and (lesson, step) not in self.hand_ins.of_pupil(desk.pupil.id)
        ]
        await asyncio.gather(*(desk.order(messages.HandIn()) for desk in desks))

    @property
    def taught(self) -> tuple[str, ...]:
        """The names of the lessons on which the class works."""
        works = (desk.progress.lesson_name for desk in self.desks.values())
        return tuple(sorted({name for name in (*works, self.roster.lesson) if name}))

    async def order(self, message: messages.Message, pupils: Iterable[Pupil] | None = None) -> None:
        """Send pupils' servers a message on behalf of their pages; None for all of them."""
        desks = self.desks.values() if pupils is None else map(self.desk, pupils)
        await asyncio.gather(*(desk.order(message) for desk in desks))

    async def renew_pin(self, pupil: Pupil) -> tuple[Picture, ...]:
        """Give a pupil other pictures, and return them; the pupil's pages are closed.

        Raises:
            OSError: the class's file can't be written.
        """
        pictures = await asyncio.to_thread(self.roster.renew_pin, pupil)
        desk = self.desk(pupil)
        # The pupil's badge has changed.
        desk.pupil = self.known(pupil.id)
        for page in desk.own_pages:
            await page.send_away()
        return pictures

    async def remove(self, pupil: Pupil) -> None:
        """Delete a pupil with everything that the pupil has made.

        Raises:
            OSError: some of it can't be deleted.
        """
        await self.pairs.leave(self.desk(pupil))
        await self.desk(pupil).send_away()
        await self._servers.stop(pupil.id)
        await self.hand_in_runs.forget(pupil.id)
        await self.marking.forget(pupil.id)
        await asyncio.to_thread(self.roster.remove, pupil)
        await asyncio.to_thread(self.marking.forget_runs)
        self.shown_programs.forget(pupil.id)
        self.desks.pop(pupil.id, None)
        if self.projected == pupil.id:
            self.projected = None

    def _has_begun(self, pupil: Pupil) -> bool:
        folder = ProjectFolder(self.roster.folder_of(pupil) / PROJECTS, read_only=True)
        return any(folder.entries())

    def _seat(self, pupil: Pupil) -> Desk:
        desk = self.desks[pupil.id] = Desk(
            pupil, self.changed, self.hand_ins, self.roster.title, self.lesson
        )
        desk.eyes_up = self.eyes_up
        desk.sharing = self.pairs
        desk.showing = self.shown_programs
        if self.is_hubs:
            desk.lesson_works = LessonWorkFile(self.roster.folder_of(pupil))
        return desk

    async def _end_later(self, pupil: Pupil) -> None:
        await asyncio.sleep(_GRACE)
        del self._ending[pupil.id]
        if not self.desk(pupil).pages:
            await self._servers.stop(pupil.id)
