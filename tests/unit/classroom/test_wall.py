"""What the wall is sent, and what its orders do to pupils' desks."""

import asyncio
from types import SimpleNamespace

import pytest

from learnblock.classroom import marking
from learnblock.classroom import messages as ours
from learnblock.classroom.hand_in_messages import HandBack, HandInSteps, WaitingHandIns
from learnblock.classroom.pupil_folder import HOME
from learnblock.classroom.room import Room
from learnblock.classroom.roster import Roster
from learnblock.classroom.teaching import do
from learnblock.classroom.wall import WallView
from learnblock.server.catalog import copy_lesson, find_lesson
from learnblock.server.messages import (
    AtSeat,
    GivenProgram,
    GivenWork,
    Scene,
    StartLesson,
    Work,
)
from learnblock.server.messages.base import Role

pytestmark = pytest.mark.realtime

LESSON = "1-03-square"
OFFER = ours.LessonOffer(LESSON, "A square", 1, 30, ("sim-ebo",), ("a", "b"))


class Page:
    """A page of a pupil."""

    is_teacher = False
    role = Role.PUPIL

    def __init__(self):
        self.told = []
        self.orders = []

    def tell(self, message):
        self.told.append(message)

    async def order(self, message):
        self.orders.append(message)


@pytest.fixture
def room(tmp_path):
    roster = Roster(tmp_path / "7b", "7b")
    for name in ("Ana", "Leo"):
        roster.add(name)
    return Room(roster, "http://a", [OFFER])


@pytest.fixture
def desk(room):
    return next(iter(room.desks.values()))


@pytest.fixture
def page(desk):
    page = Page()
    desk.joined(page)
    return page


def seats(view, room):
    """What is new about pupils."""
    return [
        seat
        for message in view.news(room)
        if isinstance(message, ours.Seats)
        for seat in message.seats
    ]


def plans(view, room):
    return {m.pupil: m.scene.name for m in view.news(room) if isinstance(m, ours.Plan)}


def test_who_has_no_page_open_is_shown_in_the_world_of_the_lesson_that_was_handed_out(room, desk):
    view = WallView()
    assert plans(view, room) == {}
    ana, leo = room.roster.pupils
    asyncio.run(room.hand_out(StartLesson(LESSON, "A square")))
    assert plans(view, room) == {ana.id: "square", leo.id: "square"}
    assert plans(view, room) == {}
    asyncio.run(room.hand_out(StartLesson("4-04-tag-map", "A map"), [leo]))
    assert plans(view, room) == {leo.id: "town"}
    now = AtSeat(Work(), scene=Scene("line", {}, (), ()))
    desk.see(None, now)
    desk.progress.look_at(None)
    assert plans(view, room) == {ana.id: "line"}


def test_lessons_are_offered_once_and_pupils_are_told_when_they_change(room, desk, page):
    view = WallView()
    first = list(view.news(room))
    kinds = [ours.Offers, ours.Wall, ours.Seats, WaitingHandIns, HandInSteps]
    assert [type(message) for message in first] == kinds
    assert list(view.news(room)) == []
    desk.see(page, AtSeat(Work("square")))
    assert [(seat.id, seat.project) for seat in seats(view, room)] == [(desk.pupil.id, "square")]


def test_of_a_way_only_the_new_points_are_sent(room, desk, page):
    view = WallView()
    desk.see(page, AtSeat(Work(way=(0, 0))))
    seats(view, room)
    desk.see(page, AtSeat(Work(way=(0, 0, 20, 0))))
    [longer] = seats(view, room)
    assert (longer.kept, longer.way) == (2, (20, 0))
    desk.see(page, AtSeat(Work(way=(5, 5))))
    [other] = seats(view, room)
    assert (other.kept, other.way) == (0, (5, 5))


def test_another_wall_gets_the_whole_way(room, desk, page):
    desk.see(page, AtSeat(Work(way=(0, 0, 20, 0))))
    seats(WallView(), room)
    shown = next(seat for seat in seats(WallView(), room) if seat.id == desk.pupil.id)
    assert (shown.kept, shown.way) == (0, (0, 0, 20, 0))


def test_a_world_is_sent_with_its_robots_once(room, desk, page):
    view = WallView()
    world = Scene("field", {}, (), (("ebo", {}),))
    desk.see(page, AtSeat(Work(), scene=world))
    plans = [message for message in view.news(room) if isinstance(message, ours.Plan)]
    assert [(plan.pupil, plan.scene) for plan in plans] == [(desk.pupil.id, world)]
    assert not any(isinstance(message, ours.Plan) for message in view.news(room))


def test_a_question_is_on_the_wall_until_the_teacher_has_answered(room, desk, page):
    view = WallView()
    asyncio.run(desk.heard(page, ours.AskForHelp(on=True, question=" It is too small ")))
    shown = next(seat for seat in seats(view, room) if seat.hand)
    assert (shown.name, shown.question) == ("Ana", "It is too small")
    assert page.told[-1].question == "It is too small"
    desk.help("Look at the corner.")
    [shown] = seats(view, room)
    assert (shown.hand, shown.question) == (False, "")


def test_the_same_hint_twice_is_two_hints(desk, page):
    for _ in range(2):
        desk.help("Look at the corner.")
    hints = [told for told in page.told if isinstance(told, ours.InClass) and told.hint]
    assert [(told.hint, told.hints) for told in hints] == [
        ("Look at the corner.", 1),
        ("Look at the corner.", 2),
    ]


def test_a_lesson_reaches_pupils_who_come_later_once(room, desk, page):
    late = room.roster.pupils[1]
    asyncio.run(do(room, ours.HandOut(LESSON, "A square")))
    assert page.orders == [StartLesson(LESSON, "A square")]
    assert (room.lesson, room.began > 0) == (LESSON, True)
    assert asyncio.run(room.first_lesson(late)) == (StartLesson(LESSON, "A square"),)
    assert asyncio.run(room.first_lesson(late)) == ()
    assert asyncio.run(room.first_lesson(desk.pupil)) == ()


def test_a_lesson_for_one_of_many_pupils_is_not_the_lesson_of_the_class(room, desk, page):
    other = room.roster.pupils[1].id
    asyncio.run(do(room, ours.HandOut(LESSON, "A square", pupils=(desk.pupil.id,), step=2)))
    assert page.orders == [StartLesson(LESSON, "A square", step=2)]
    assert (room.lesson, room.began) == ("", 0.0)
    asyncio.run(do(room, ours.HandOut(LESSON, "A square", pupils=(desk.pupil.id, other))))
    assert room.lesson == LESSON


def waiting(room):
    """What waits to be handed back, as a wall that is opened now shows it."""
    [shown] = [message for message in WallView().news(room) if isinstance(message, WaitingHandIns)]
    return shown


def works_at(desk, page, lesson, step):
    """Let a pupil have a step open."""
    desk.see(page, AtSeat(Work(lesson_name=lesson, step=step)))


def test_work_that_was_handed_in_waits_while_its_pupil_does_the_next_lesson(room, desk, page):
    works_at(desk, page, LESSON, 4)
    program = GivenProgram("main:\nend\n")
    asyncio.run(desk.hand_in(GivenWork(LESSON, 4, program, tries=3)))
    assert waiting(room) == WaitingHandIns()
    following = ours.HandOut("1-04-feelings", "Feelings", pupils=(desk.pupil.id,))
    asyncio.run(do(room, following))
    assert page.orders == [StartLesson("1-04-feelings", "Feelings")]
    works_at(desk, page, "1-04-feelings", 1)
    [left] = waiting(room).hand_ins
    assert (left.pupil, left.lesson, left.step, left.tries) == (desk.pupil.id, LESSON, 4, 3)
    assert left.title["en"] == "A square with a loop"
    asyncio.run(do(room, HandBack(LESSON, 4, (desk.pupil.id,))))
    assert waiting(room) == WaitingHandIns()


def test_the_newest_of_much_work_that_waits_is_on_the_wall_and_the_rest_is_counted(
    room, desk, page, monkeypatch
):
    monkeypatch.setattr(marking, "_MOST_WAITING", 2)
    other = room.roster.pupils[1].id
    for pupil, step in ((desk.pupil.id, 2), (other, 4), (desk.pupil.id, 5)):
        room.hand_ins.add(pupil, GivenWork(LESSON, step, GivenProgram("main:\nend\n")))
    works_at(desk, page, LESSON, 1)
    shown = waiting(room)
    assert [(left.pupil, left.step) for left in shown.hand_ins] == [(desk.pupil.id, 5), (other, 4)]
    assert shown.more == 1


def test_work_of_a_lesson_that_is_gone_can_not_be_handed_back(room, desk):
    room.hand_ins.add(desk.pupil.id, GivenWork("gone", 1, GivenProgram("main:\nend\n")))
    assert waiting(room) == WaitingHandIns()


def test_the_wall_tells_pupils_of_one_name_apart_by_numbers(room):
    ana = room.roster.pupils[0]
    namesake, _ = room.roster.add("Ana")
    room.desk(namesake)
    named = {seat.id: seat.name for seat in seats(WallView(), room)}
    assert (named[ana.id], named[namesake.id]) == ("Ana 1", "Ana 2")


@pytest.fixture
def own():
    """The name of a lesson of the teacher's own."""
    return copy_lesson(LESSON).name


@pytest.fixture
def taught(tmp_path, own):
    """A class with a pupil, which can be handed that lesson."""
    roster = Roster(tmp_path / "7b", "7b")
    roster.add("Ana")
    offer = ours.LessonOffer(own, "Mine", 1, 30, ("sim-ebo",), (), own=True)
    return Room(roster, "http://a", [offer])


def has_own(room, own, monkeypatch):
    """Find the lesson as the pupil's server does; it has nothing that only the teacher has."""
    [pupil] = room.roster.pupils
    monkeypatch.setenv("LEARNBLOCK_HOME", str(room.roster.folder_of(pupil) / HOME))
    given = find_lesson(own)
    return given.name == own and not any(path.startswith("teacher") for path in given.files)


def test_pupils_get_a_teachers_own_lesson_without_the_teachers_part(taught, own, monkeypatch, page):
    asyncio.run(do(taught, ours.HandOut(own, "Mine")))
    assert has_own(taught, own, monkeypatch)


def test_pupils_begin_with_a_teachers_own_lesson(taught, own, monkeypatch):
    taught.roster.prepare(own, "Mine", "basics")
    (first,) = asyncio.run(taught.first_lesson(taught.roster.pupils[0]))
    assert first == StartLesson(own, "Mine")
    assert has_own(taught, own, monkeypatch)


@pytest.mark.parametrize(
    ("state", "orders"), [("running", ["Pause", "Resume"]), ("paused", []), ("ended", [])]
)
def test_eyes_up_pauses_a_program_that_runs_and_resumes_it(room, desk, page, state, orders):
    desk.see(page, AtSeat(Work(state=state)))
    asyncio.run(do(room, ours.EyesUp(on=True)))
    desk.see(page, AtSeat(Work(state="paused")))
    asyncio.run(do(room, ours.EyesUp(on=False)))
    assert [type(order).__name__ for order in page.orders] == orders


def test_a_page_knows_the_class_and_the_lesson_that_was_handed_out(room, page):
    assert (page.told[0].title, page.told[0].lesson) == ("7b", "")
    asyncio.run(do(room, ours.HandOut(LESSON, "A square")))
    assert page.told[-1].lesson == LESSON


def test_a_page_that_asks_whether_the_class_answers_wakes_no_wall(room, desk, page):
    woken = []
    room.boards = [SimpleNamespace(wake=lambda: woken.append("wall"))]
    told = len(page.told)
    asyncio.run(desk.heard(page, ours.AskNews()))
    assert [type(message) for message in page.told[told:]] == [ours.InClass]
    assert woken == []
