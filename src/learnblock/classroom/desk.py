"""A pupil's desk: the pages that show the program, and what the teacher sees of it."""

import asyncio
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from typing import Protocol, assert_never

import msgspec
from msgspec.structs import replace

from learnblock.classroom import messages as ours
from learnblock.classroom.hand_in_messages import ImproveHandIn, OwnHandIns, own_hand_in
from learnblock.classroom.hand_ins import HandInShelf
from learnblock.classroom.lesson_works import LessonWorkFile
from learnblock.classroom.limits import OPEN_PAGES
from learnblock.classroom.messages import InClass, Seat, Writing
from learnblock.classroom.pair_messages import FromPlayer, InPair
from learnblock.classroom.progress import Progress
from learnblock.classroom.questions import A
from learnblock.classroom.quota import Paces
from learnblock.classroom.roster import Pupil
from learnblock.classroom.show_messages import FromShower, ProgramOffers
from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase
from learnblock.server import messages
from learnblock.server.messages.base import Role


class TooManyPagesError(LearnBlockError):
    """A pupil has too many pages open."""


class DeskPage(Protocol):
    """A page that shows the program of a pupil."""

    #: Whether it is the teacher's.
    is_teacher: bool

    @property
    def role(self) -> Role:
        """What the page is to the program now."""

    def tell(self, message: msgspec.Struct) -> None:
        """Send the page a message of the classroom."""

    async def order(self, message: messages.Message) -> None:
        """Send the pupil's server a message on behalf of this page."""

    async def ask(self, question: messages.Message, answer: type[A]) -> A | None:
        """Ask the pupil's server on behalf of this page; None without an answer."""

    async def send_away(self) -> None:
        """Close the page's connection."""


class Sharing(Protocol):
    """Lets pupils play in each other's worlds."""

    def news(self, desk: "Desk") -> InPair:
        """With whom a pupil plays."""

    def came(self, desk: "Desk") -> None:
        """Note that a pupil has a page again."""

    async def heard(self, desk: "Desk", page: DeskPage, message: FromPlayer) -> None:
        """Do what a pupil's page asks for.

        Raises:
            LearnBlockError: it can't be done.
        """

    def renamed(self, desk: "Desk", page: DeskPage, name: str) -> None:
        """Note that the project of a pupil's page has another name."""

    async def before_run(self, desk: "Desk", page: DeskPage) -> None:
        """Fetch the guest's program before a run of the host.

        Raises:
            LearnBlockError: it can't be had.
        """


class Showing(Protocol):
    """Lets pupils show their programs."""

    def news(self, desk: "Desk") -> ProgramOffers:
        """What classmates show a pupil."""

    async def heard(self, desk: "Desk", page: DeskPage, message: FromShower) -> None:
        """Do what a pupil's page asks for.

        Raises:
            LearnBlockError: it can't be done.
        """


class Desk:
    """The place of one pupil.

    Args:
        pupil: the pupil.
        changed: called when the wall should show something else.
        shelf: the hand-ins of the class.
        title: the name of the class.
        lesson: the name of the lesson that was handed out last; empty without one.
    """

    def __init__(
        self,
        pupil: Pupil,
        changed: Callable[[], object],
        shelf: HandInShelf,
        title: str = "",
        lesson: str = "",
    ) -> None:
        self.pupil = pupil
        self._title = title
        #: The lesson that was handed out last, and the step with which it begins.
        self.handed_out = (lesson, 1)
        self._shelf = shelf
        self.progress = Progress()
        self.writing: Writing = "no"
        #: What the pupil needs help with.
        self.question = ""
        self.eyes_up = False
        #: What the teacher has said, the newest last.
        self.hints: list[str] = []
        self.pages: list[DeskPage] = []
        self.paces = Paces()
        #: At a hub: the work in lessons, as the pupil's server has reported it.
        self.lesson_works: LessonWorkFile | None = None
        #: Where the pupil can play with others; None at a desk where only a hand-in runs.
        self.sharing: Sharing | None = None
        #: Where the pupil can show programs; None there, too.
        self.showing: Showing | None = None
        #: The project that the pupil shows the teacher, empty without one, and since when, in
        #: seconds since 1970.
        self._shows, self._shows_since = "", 0.0
        #: Whether the pupil's program is paused because the teacher speaks.
        self._rests = False
        #: Whether the pupil's server has refused the lesson that was handed out last.
        self._lacks_lesson = False
        self._opening = 0
        self._uploading = False
        self._changed = changed

    @property
    def own_pages(self) -> list[DeskPage]:
        """The pages of the pupil."""
        return [page for page in self.pages if not page.is_teacher]

    def seat(self) -> Seat:
        """What the wall shows."""
        seat = self.progress.seat(
            self.pupil,
            here=bool(self.own_pages),
            question=self.question,
            writing=self.writing,
        )
        file = self._shelf.of_pupil(self.pupil.id).get((seat.lesson_name, seat.step))
        return replace(
            seat,
            hand_in=file.state if file else "",
            lacks_lesson=self._lacks_lesson,
            shows=self._shows,
            shows_since=self._shows_since,
        )

    @contextmanager
    def opening(self) -> Iterator[None]:
        """Open a page of the pupil, until it is closed.

        Raises:
            TooManyPagesError: too many are open.
        """
        if self._opening >= OPEN_PAGES:
            raise TooManyPagesError("class-too-many-pages", most=OPEN_PAGES)
        self._opening += 1
        try:
            yield
        finally:
            self._opening -= 1

    @contextmanager
    def uploading(self) -> Iterator[None]:
        """Upload a file for the pupil.

        Raises:
            LearnBlockError: another one is being uploaded.
        """
        if self._uploading:
            raise LearnBlockError("class-uploading")
        self._uploading = True
        try:
            yield
        finally:
            self._uploading = False

    def joined(self, page: DeskPage) -> None:
        """A page is connected to the pupil's server."""
        self.pages.append(page)
        self._look()
        page.tell(self._news(page))
        if page.is_teacher:
            self._seen()
        else:
            page.tell(self._own_hand_ins())
            if self.sharing:
                self.sharing.came(self)
            self.tell_pair(page)
            self.tell_offers(page)
        self._changed()

    def left(self, page: DeskPage) -> None:
        """A page has gone."""
        self.pages.remove(page)
        self._look()
        self.progress.forget(page)
        if page.is_teacher and not any(other.is_teacher for other in self.pages):
            self.writing = "no"
        self.tell()

    def see(self, page: DeskPage, now: messages.AtSeat) -> None:
        """Note what a page works on; the wall shows a page of the pupil, if there is one."""
        self.progress.see(page, now)
        self._look()
        self._changed()

    def _look(self) -> None:
        self.progress.are_here(on=bool(self.own_pages))
        self.progress.look_at(next(iter(self.own_pages or self.pages), None))

    async def hand_in(self, work: messages.GivenWork) -> None:
        """Hand in what the pupil's server has given.

        Raises:
            LearnBlockError: the pupil has handed in too much.
            OSError: it can't be saved.
            ValueError: the program is too large.
        """
        await asyncio.to_thread(self._shelf.add, self.pupil.id, work)
        self.tell_hand_ins()

    async def heard(self, page: DeskPage, message: ours.FromPupil) -> None:
        """Do what a page asks the classroom for; its rights have been checked.

        Raises:
            LearnBlockError: it can't be done.
            OSError: it can't be saved.
        """
        if isinstance(message, FromPlayer):
            if self.sharing:
                await self.sharing.heard(self, page, message)
            return
        if isinstance(message, FromShower):
            if self.showing:
                await self.showing.heard(self, page, message)
            return
        match message:
            case ours.AskNews():
                self._tell_pages()
                return
            case ImproveHandIn(lesson=lesson, step=step):
                await asyncio.to_thread(self._shelf.improve, self.pupil.id, lesson, step)
                self.tell_hand_ins()
            case ours.AskForHelp(on=on, question=question):
                self._raise(on=on, question=question)
            case ours.LetTeacherWrite(on=on):
                self.writing = "yes" if on else "no"
            case ours.AskToWrite(on=on):
                self.writing = "asked" if on else "no"
            case _:
                assert_never(message)
        self.tell()

    def show_teacher(self, project: str) -> None:
        """Show a project on the wall, until the teacher looks at what the pupil does."""
        self._shows, self._shows_since = project, time.time()
        self._changed()

    def _seen(self) -> None:
        if self._shows:
            self.note(Phrase("class-show-seen", project=self._shows))
            self._shows, self._shows_since = "", 0.0

    def renamed(self, page: DeskPage, name: str) -> None:
        """Note that the project of a page has another name."""
        if self._shows and self._shows == self.progress.work_of(page).project:
            self._shows = name
        if self.sharing:
            self.sharing.renamed(self, page, name)

    def hand_out(self, lesson: str, step: int = 1) -> None:
        """A lesson has been handed out to the pupil, from this step."""
        self.handed_out = (lesson, step)
        self._lacks_lesson = False
        self.tell()

    def lesson_refused(self) -> None:
        """The pupil's server has refused a lesson of the teacher's own; the wall says so."""
        self._lacks_lesson = True
        self._changed()

    async def rest(self, *, eyes_up: bool) -> None:
        """Pause or resume the pupil's pages and program."""
        self.eyes_up = eyes_up
        self.tell()
        # A run that the pupil has paused stays paused.
        if eyes_up and self.progress.is_running:
            self._rests = True
            await self.order(messages.Pause())
        elif not eyes_up and self._rests:
            self._rests = False
            await self.order(messages.Resume())

    def help(self, hint: str) -> None:
        """Show a hint of the teacher, which also answers a raised hand."""
        self.hints.append(hint)
        self._raise(on=False)
        self.tell()

    def _raise(self, *, on: bool, question: str = "") -> None:
        self.question = question.strip() if on else ""
        self.progress.raise_hand(on=on)

    async def order(self, *orders: messages.Message) -> None:
        """Send the pupil's server messages on behalf of the pupil's page, if one is open."""
        for page in self.own_pages[:1]:
            for message in orders:
                await page.order(message)

    async def send_away(self) -> None:
        """Close all pages, since they may not be here any more."""
        for page in list(self.pages):
            await page.send_away()

    def tell(self) -> None:
        """Tell the pages what is going on in the class, and the wall that something has changed."""
        self._tell_pages()
        self._changed()

    def _tell_pages(self) -> None:
        for page in self.pages:
            page.tell(self._news(page))

    def tell_pair(self, *pages: DeskPage) -> None:
        """Tell pages of the pupil, by default all, with whom the pupil plays."""
        self._tell_own(self.sharing, pages)

    def tell_offers(self, *pages: DeskPage) -> None:
        """Tell pages of the pupil, by default all, what classmates show."""
        self._tell_own(self.showing, pages)

    def _tell_own(self, source: Sharing | Showing | None, pages: Sequence[DeskPage]) -> None:
        if source:
            news = source.news(self)
            for page in pages or self.own_pages:
                page.tell(news)

    def note(self, message: Phrase) -> None:
        """Show a sentence on the pupil's pages."""
        for page in self.own_pages:
            page.tell(messages.Noted(message))

    def tell_hand_ins(self) -> None:
        """Tell the pupil's pages what is handed in, and what is back."""
        for page in self.own_pages:
            page.tell(self._own_hand_ins())
        self._changed()

    def _own_hand_ins(self) -> OwnHandIns:
        files = sorted(self._shelf.of_pupil(self.pupil.id).values(), key=lambda file: file.at)
        return OwnHandIns(tuple(map(own_hand_in, files)))

    def _news(self, page: DeskPage) -> InClass:
        return InClass(
            name=self.pupil.name,
            role=page.role.value,
            eyes_up=self.eyes_up and not page.is_teacher,
            hand=self.progress.has_raised_hand,
            writing=self.writing,
            question=self.question,
            hint=self.hints[-1] if self.hints else "",
            hints=len(self.hints),
            title=self._title,
            lesson=self.handed_out[0],
        )
