"""Pupils show programs: to the teacher on the wall, and copies to classmates."""

import asyncio

import pytest

from learnblock.classroom.pair_messages import Classmates
from learnblock.classroom.show_messages import (
    AnswerOffer,
    AskViewers,
    ProgramOffer,
    ProgramOffers,
    ShowClassmate,
    ShownToClassmate,
    ShowTeacher,
)
from learnblock.classroom.shown_programs import ShownPrograms
from learnblock.errors import LearnBlockError
from learnblock.project.files.project import Project
from learnblock.project.files.share_link import LONGEST_LINK, SharedProject, link_of
from learnblock.server import messages
from learnblock.server.messages.base import Role
from small_classroom import Classroom, FakePage

NAMES = ("Ana", "Ben", "Eva", "Leo", "Zoe")


def link(name="Square"):
    return link_of(SharedProject(Project(name, "main:\n    pass\nend\n", robot="sim-ebo")))


class Page(FakePage):
    @property
    def news(self):
        return self.newest(ProgramOffers)


class ShowRoom(Classroom):
    """Pupils, each with a page that shows a project of the pupil's own."""

    def __init__(self, folder):
        super().__init__(NAMES)
        self.shown = ShownPrograms(self.roster, self.desks, lambda: None, lambda: self.clock)
        self.seat(folder, Page, showing=self.shown)
        for name in NAMES:
            self.work(name, project="Square")

    def work(self, name, **work):
        self.desk(name).see(self.pages[name], messages.AtSeat(messages.Work(**work)))

    def say(self, name, message):
        asyncio.run(self.desk(name).heard(self.pages[name], message))

    def show(self, name, classmate, text=None):
        self.say(name, ShowClassmate(self.desk(classmate).pupil.id, text or link()))

    def answer(self, name, classmate, *, on):
        self.say(name, AnswerOffer(self.desk(classmate).pupil.id, on))

    def refusal(self, doing, *args, **options):
        with pytest.raises(LearnBlockError) as refused:
            doing(*args, **options)
        return refused.value.phrase.code


@pytest.fixture
def classroom(tmp_path):
    return ShowRoom(tmp_path)


@pytest.fixture
def allowed(classroom):
    classroom.shown.let(on=True)
    return classroom


def test_the_wall_shows_a_project_until_the_teacher_looks(classroom):
    ana = classroom.desk("Ana")
    assert ana.seat().shows == ""
    classroom.say("Ana", ShowTeacher())
    assert (ana.seat().shows, ana.seat().shows_since > 0) == ("Square", True)
    ana.renamed(classroom.pages["Ana"], "Spiral")
    assert ana.seat().shows == "Spiral"
    classroom.work("Ana", project="Other")
    ana.renamed(classroom.pages["Ana"], "Another")
    assert ana.seat().shows == "Spiral"
    ana.joined(Page(role=Role.WATCHER))
    assert (ana.seat().shows, ana.seat().shows_since) == ("", 0)
    assert classroom.pages["Ana"].notes == ["class-show-teacher", "class-show-seen"]
    # The next look is nothing new.
    ana.joined(Page(role=Role.WATCHER))
    assert classroom.pages["Ana"].notes == ["class-show-teacher", "class-show-seen"]


def test_without_a_project_there_is_nothing_to_show(classroom):
    classroom.work("Ana", project="")
    assert classroom.refusal(classroom.say, "Ana", ShowTeacher()) == "class-show-no-project"


def test_a_classmate_opens_a_copy_as_the_link_that_it_came_in(allowed):
    allowed.say("Ana", AskViewers())
    viewers = allowed.pages["Ana"].told[-1]
    assert isinstance(viewers, Classmates)
    assert [pupil.name for pupil in viewers.pupils] == ["Ben", "Eva", "Leo", "Zoe"]
    text = link("Star")
    allowed.show("Ana", "Ben", f"http://127.0.0.1/#share={text}")
    ben = allowed.pages["Ben"]
    assert ben.news == ProgramOffers(allowed=True, offers=(ProgramOffer("a" * 10, "Ana", "Star"),))
    assert ben.orders == []
    assert allowed.shown.shown == (ShownToClassmate("a" * 10, "b" * 10, "Star"),)
    allowed.answer("Ben", "Ana", on=True)
    assert ben.orders == [messages.OpenLink(text)]
    assert ben.news == ProgramOffers(allowed=True)
    assert allowed.pages["Ana"].notes == ["class-show-classmate", "class-show-opened"]
    assert allowed.refusal(allowed.answer, "Ben", "Ana", on=True) == "class-show-gone"


def test_a_page_that_connects_again_has_the_offers(allowed):
    allowed.show("Ana", "Ben")
    page = Page()
    allowed.desk("Ben").joined(page)
    assert [offer.project for offer in page.news.offers] == ["Square"]


def test_a_classmate_who_has_declined_is_left_alone_for_a_minute(allowed):
    allowed.show("Ana", "Ben")
    allowed.answer("Ben", "Ana", on=False)
    assert allowed.pages["Ben"].orders == []
    assert allowed.pages["Ana"].notes[-1] == "class-show-declined"
    assert allowed.refusal(allowed.show, "Ana", "Ben") == "class-classmate-declined"
    allowed.show("Ana", "Eva")
    allowed.clock = 61
    allowed.show("Ana", "Ben")


def test_classmates_see_nothing_until_the_teacher_allows_it(classroom):
    assert not classroom.pages["Ana"].news.allowed
    assert classroom.refusal(classroom.say, "Ana", AskViewers()) == "class-show-off"
    assert classroom.refusal(classroom.show, "Ana", "Ben") == "class-show-off"
    classroom.shown.let(on=True)
    classroom.show("Ana", "Ben")
    classroom.shown.let(on=False)
    assert classroom.pages["Ben"].news == ProgramOffers()
    assert classroom.refusal(classroom.answer, "Ben", "Ana", on=True) == "class-show-gone"
    assert classroom.pages["Ben"].orders == []


def test_only_classmates_who_are_here_are_shown_a_program(allowed):
    assert allowed.refusal(allowed.show, "Ana", "Ana") == "class-classmate-away"
    allowed.desk("Ben").left(allowed.pages["Ben"])
    assert allowed.refusal(allowed.show, "Ana", "Ben") == "class-classmate-away"
    unknown = ShowClassmate("x" * 10, link())
    assert allowed.refusal(allowed.say, "Ana", unknown) == "class-classmate-away"


def test_in_a_lesson_everybody_works_alone(allowed):
    allowed.work("Ana", project="Square", lesson_name="1-03-square", step=1)
    assert allowed.refusal(allowed.show, "Ana", "Ben") == "class-show-lesson"
    # The teacher may see it.
    allowed.say("Ana", ShowTeacher())


def test_a_classmate_has_few_offers_at_a_time_and_one_of_each_pupil(allowed):
    for name in ("Ana", "Eva", "Leo"):
        allowed.show(name, "Ben")
    assert allowed.refusal(allowed.show, "Zoe", "Ben") == "class-show-busy"
    allowed.show("Ana", "Ben", link("Star"))
    assert {offer.project for offer in allowed.pages["Ben"].news.offers} == {"Square", "Star"}
    assert len(allowed.pages["Ben"].news.offers) == 3


def test_showing_has_a_pace(allowed):
    allowed.say("Ana", ShowTeacher())
    allowed.show("Ana", "Ben")
    allowed.show("Ana", "Eva")
    assert allowed.refusal(allowed.show, "Ana", "Leo") == "class-too-fast"
    assert allowed.refusal(allowed.say, "Ana", ShowTeacher()) == "class-too-fast"


DAMAGED = {
    "": "share-no-link",
    "Come to my house": "share-no-link",
    "1.AAAA": "share-damaged",
    "1." + "A" * (LONGEST_LINK - 2): "share-damaged",
    "9." + "A" * 30: "share-version",
    f"http://evil.example/{link()[:60]}": "share-no-link",
    f"{link()[:-20]}": "share-damaged",
    link("x" * 99).replace(".", "..", 1): "share-no-link",
}


@pytest.mark.parametrize(("text", "code"), DAMAGED.items())
def test_a_damaged_link_reaches_no_classmate(allowed, text, code):
    message = ShowClassmate("b" * 10, text)
    assert allowed.refusal(allowed.say, "Ana", message) == code
    assert allowed.pages["Ben"].news.offers == ()
    assert allowed.shown.shown == ()


def test_a_pupil_who_is_deleted_is_in_no_offer_and_no_list(allowed):
    allowed.show("Ana", "Ben")
    allowed.show("Eva", "Ana")
    allowed.show("Eva", "Leo")
    allowed.shown.forget("a" * 10)
    assert allowed.pages["Ben"].news.offers == ()
    assert allowed.shown.news(allowed.desk("Ana")).offers == ()
    assert [offer.name for offer in allowed.pages["Leo"].news.offers] == ["Eva"]
    assert allowed.shown.shown == (ShownToClassmate("e" * 10, "l" * 10, "Square"),)
