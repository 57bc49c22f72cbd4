"""Pupils show their programs: the teacher on the wall, and classmates as copies of their own.

A copy travels as a link does. The class doesn't read the program in it: that is left to the server
of the classmate who opens it, which checks it as it checks every link.
"""

import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import assert_never

from learnblock.classroom.classmates import (
    Refusals,
    classmate_here,
    classmates_here,
    name_of,
)
from learnblock.classroom.desk import Desk, DeskPage
from learnblock.classroom.limits import MOST_OFFERS, SHOWING
from learnblock.classroom.pair_messages import Classmates
from learnblock.classroom.quota import Buckets
from learnblock.classroom.roster import Roster
from learnblock.classroom.show_messages import (
    AnswerOffer,
    AskViewers,
    FromShower,
    ProgramOffer,
    ProgramOffers,
    ShowClassmate,
    ShownToClassmate,
    ShowTeacher,
)
from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase
from learnblock.project.files.share_link import bare, linked_name
from learnblock.server import messages

#: How many of the programs that pupils have shown each other the wall has.
_MOST_SHOWN = 5


@dataclass(frozen=True)
class _Offer:
    """A copy of a project that a classmate may open.

    Args:
        desk: of the pupil who shows it.
        project: the name of the project.
        link: holds the project.
    """

    desk: Desk
    project: str
    link: str


# Why: docs/decisions.md, "Pupils show copies, and only if the teacher allows it"
class ShownPrograms:
    """What the pupils of a class show; classmates see nothing until the teacher allows it.

    Args:
        roster: the pupils.
        desks: their desks, by their ids.
        changed: called when the wall should show something else.
        now: returns the time of a monotonic clock in seconds.
    """

    def __init__(
        self,
        roster: Roster,
        desks: Mapping[str, Desk],
        changed: Callable[[], object],
        now: Callable[[], float] = time.monotonic,
    ) -> None:
        self.allowed = False
        #: What pupils have shown each other, the newest first.
        self.shown: tuple[ShownToClassmate, ...] = ()
        self._roster = roster
        self._desks = desks
        self._changed = changed
        #: What waits for an answer, by the ids of the classmate and of the pupil who shows it.
        self._offers: dict[str, dict[str, _Offer]] = {}
        self._refusals = Refusals(now)
        self._paces = Buckets(SHOWING, now)

    def news(self, desk: Desk) -> ProgramOffers:
        """What classmates show a pupil."""
        offers = (
            ProgramOffer(pupil, name_of(self._roster, offer.desk), offer.project)
            for pupil, offer in self._offers.get(desk.pupil.id, {}).items()
        )
        return ProgramOffers(self.allowed, tuple(offers))

    async def heard(self, desk: Desk, page: DeskPage, message: FromShower) -> None:
        """Do what a pupil's page asks for.

        Raises:
            LearnBlockError: it can't be done.
        """
        match message:
            case ShowTeacher():
                self._show_teacher(desk, page)
            case AskViewers():
                self._require_allowed()
                page.tell(Classmates(tuple(classmates_here(self._roster, self._desks, desk))))
            case ShowClassmate(pupil=pupil, link=link):
                self._show_classmate(desk, page, pupil, link)
            case AnswerOffer(pupil=pupil, on=on):
                await self._answer(desk, page, pupil, on=on)
            case _:
                assert_never(message)

    def let(self, *, on: bool) -> None:
        """Let pupils show each other programs, or no more: then all offers are gone."""
        self.allowed = on
        if not on:
            self._offers.clear()
        for desk in self._desks.values():
            desk.tell_offers()

    def forget(self, pupil: str) -> None:
        """Forget what a pupil has shown and was shown."""
        self._offers.pop(pupil, None)
        for classmate, offers in self._offers.items():
            if offers.pop(pupil, None):
                self._desks[classmate].tell_offers()
        self.shown = tuple(
            shown for shown in self.shown if pupil not in (shown.pupil, shown.classmate)
        )

    def _show_teacher(self, desk: Desk, page: DeskPage) -> None:
        project = desk.progress.work_of(page).project
        if not project:
            raise LearnBlockError("class-show-no-project")
        self._keep_pace(desk)
        desk.show_teacher(project)
        page.tell(messages.Noted(Phrase("class-show-teacher", project=project)))

    def _show_classmate(self, desk: Desk, page: DeskPage, pupil: str, link: str) -> None:
        self._require_allowed()
        classmate = self._viewer(desk, pupil)
        if desk.progress.work_of(page).lesson_name:
            raise LearnBlockError("class-show-lesson")
        project = linked_name(link)
        self._keep_pace(desk)
        self._offers.setdefault(pupil, {})[desk.pupil.id] = _Offer(desk, project, bare(link))
        shown = ShownToClassmate(desk.pupil.id, pupil, project)
        self.shown = (shown, *self.shown)[:_MOST_SHOWN]
        classmate.tell_offers()
        name = name_of(self._roster, classmate)
        page.tell(messages.Noted(Phrase("class-show-classmate", name=name, project=project)))
        self._changed()

    def _viewer(self, desk: Desk, pupil: str) -> Desk:
        """The desk of a classmate who can be shown a program.

        Raises:
            LearnBlockError: the classmate can't, or not now.
        """
        classmate = classmate_here(self._roster, self._desks, desk, pupil)
        name = name_of(self._roster, classmate)
        self._refusals.require_none(desk, classmate, name)
        offers = self._offers.get(pupil, {})
        if desk.pupil.id not in offers and len(offers) >= MOST_OFFERS:
            raise LearnBlockError("class-show-busy", name=name)
        return classmate

    async def _answer(self, desk: Desk, page: DeskPage, pupil: str, *, on: bool) -> None:
        offer = self._offers.get(desk.pupil.id, {}).pop(pupil, None)
        if offer is None:
            raise LearnBlockError("class-show-gone")
        desk.tell_offers()
        name = name_of(self._roster, desk)
        if on:
            await page.order(messages.OpenLink(offer.link))
            offer.desk.note(Phrase("class-show-opened", name=name, project=offer.project))
            return
        self._refusals.add(offer.desk, desk)
        offer.desk.note(Phrase("class-show-declined", name=name))

    def _keep_pace(self, desk: Desk) -> None:
        if self._paces.try_take(desk.pupil.id):
            raise LearnBlockError("class-too-fast")

    def _require_allowed(self) -> None:
        if not self.allowed:
            raise LearnBlockError("class-show-off")
