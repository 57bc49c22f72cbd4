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
    way = work(seat).way
    assert 400 < len(way) <= 800
    # It is coarser, but shown from its beginning to its end.
    assert (way[:2], way[-2:]) == ((0, 0), (20 * 999, 0))


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


def goal(state, reason=None):
    return messages.LessonGoal(messages.LessonWords("Reach it"), state, reason=reason)


def lesson(*steps, step=1):
    return messages.LessonShown("one", {"en": "One"}, steps=steps, step=step)


def test_tries_are_counted_by_step(seat):
    seat.see(lesson(messages.LessonStep("a", "run"), step=1))
    seat.see(messages.Ended("finished"))
    seat.see(messages.Ended("error", Phrase("run-x")))
    assert work(seat).tries == 2
    seat.see(lesson(messages.LessonStep("a", "run"), step=2))
    assert work(seat).tries == 0


def test_what_the_last_run_missed_is_shown_with_its_reason_until_a_run_passes(seat):
    seat.see(messages.LessonGoals((goal("met"), goal("failed", Phrase("short", mm=100)))))
    missed = work(seat).missed
    assert missed.goal["text"] == "Reach it"
    assert missed.reason["code"] == "short"
    seat.see(messages.LessonGoals((goal("met"), goal("met"))))
    assert work(seat).missed is None


def test_what_a_run_may_still_reach_is_not_missed(seat):
    seat.see(messages.LessonGoals((goal("failed"),), live=True))
    assert work(seat).missed is None


def test_a_step_is_done_with_a_star_or_once_it_is_behind_if_it_has_none(seat):
    steps = (
        messages.LessonStep("a", "predict"),
        messages.LessonStep("b", "run", stars=1),
        messages.LessonStep("c", "modify", stars=2, earned=1),
        messages.LessonStep("d", "make"),
    )
    seat.see(lesson(*steps, step=3))
    shown = work(seat)
    assert shown.done == (True, False, True, False)
    assert (shown.stars, shown.all_stars, shown.lesson_name) == (1, 3, "one")
