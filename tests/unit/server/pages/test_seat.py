"""What a class's wall shows of a page, from the messages that the page is sent."""

import pytest

from learnblock.i18n import Phrase
from learnblock.monitor.monitor import Robot
from learnblock.project.document.views import Problem
from learnblock.server import messages
from learnblock.server.pages.seat import PageSeat


@pytest.fixture
def seat():
    return PageSeat(lambda _: None)


def work(seat):
    return seat.news().work


def drive(seat, *places):
    for x, y in places:
        robot = Robot("ebo", x=x, y=y, heading=90.0)
        seat.see(messages.Telemetry(time=1.0, robots=(robot,)))


def document(*problems):
    return messages.Document(edit=1, revision=1, origin="blocks", problems=problems)


def problem(severity):
    return Problem("x", Phrase("check-x"), severity, "blocks")


def test_the_way_has_no_points_close_to_each_other(seat):
    drive(seat, (0, 0), (1, 0), (10, 0), (20, 0), (40, 0))
    assert work(seat).way == (0, 0, 20, 0, 40, 0)
    assert work(seat).pose == (40, 0, 90)


def test_the_way_is_bounded(seat):
    drive(seat, *((20 * n, 0) for n in range(1000)))
    assert len(work(seat).way) == 800
    assert work(seat).way[-2:] == (20 * 999, 0)


def test_a_new_run_begins_a_new_way(seat):
    drive(seat, (0, 0), (50, 0))
    seat.see(messages.RunState("starting"))
    assert work(seat).way == ()


def test_a_mistake_in_the_program_is_shown_until_it_is_gone(seat):
    seat.see(document(problem("warning")))
    assert work(seat).error is None
    seat.see(document(problem("error")))
    assert work(seat).error["code"] == "check-x"
    seat.see(document())
    assert work(seat).error is None


def test_a_run_that_ends_badly_is_shown_and_a_stopped_one_is_not(seat):
    seat.see(messages.Ended("error", Phrase("run-x")))
    assert work(seat).error["code"] == "run-x"
    seat.see(messages.Ended("stopped", Phrase("run-stopped")))
    assert work(seat).error is None


def test_a_run_that_ends_well_is_a_success_and_a_tried_block_is_not(seat):
    seat.see(messages.Ended("finished", tried=True))
    seat.see(messages.Ended("stopped"))
    assert seat.news().successes == 0
    seat.see(messages.Ended("finished"))
    assert seat.news().successes == 1


def test_stars_and_steps_of_a_lesson_are_shown(seat):
    steps = [messages.LessonStep("a", "run", earned=2), messages.LessonStep("b", "make")]
    seat.see(messages.LessonShown("one", {"en": "One"}, steps=tuple(steps), step=2))
    shown = work(seat)
    assert (shown.lesson, shown.step, shown.steps, shown.stars) == ({"en": "One"}, 2, 2, 2)
    steps[1] = messages.LessonStep("b", "make", earned=1)
    seat.see(messages.LessonGoals((), earned=1, steps=tuple(steps)))
    assert work(seat).stars == 3
    seat.see(messages.LessonShown())
    assert (work(seat).lesson, work(seat).step) == ("", 0)


def test_a_world_is_sent_once(seat):
    world = messages.Scene("field", {}, (), ())
    seat.see(world)
    assert seat.news().scene is world
    assert seat.news().scene is None


def test_other_messages_are_not_read(seat):
    before = work(seat)
    seat.see(messages.Done(1))
    assert work(seat) == before
