"""What the wall shows of a pupil, as the pupil's server and pages tell it."""

import pytest

from clocks import Clock
from learnblock.classroom.pins import Pin, new_pictures
from learnblock.classroom.progress import Progress
from learnblock.classroom.roster import Pupil
from learnblock.server.messages import AtSeat, Scene, Work

pytestmark = pytest.mark.realtime

PUPIL = Pupil("a" * 10, "Ana", Pin.of(new_pictures()), 0.0)
WORLD = Scene("field", {}, (), ())


@pytest.fixture
def clock():
    return Clock(1000.0)


@pytest.fixture
def progress(clock):
    return Progress(clock)


def seat(progress):
    return progress.seat(PUPIL, here=True, writing="no")


def test_what_a_page_works_on_is_shown_once_it_is_looked_at(progress):
    progress.see("first", AtSeat(Work("square", "sim-ebo", stars=2)))
    assert seat(progress).project == ""
    progress.look_at("first")
    assert (seat(progress).name, seat(progress).project, seat(progress).stars) == (
        "Ana",
        "square",
        2,
    )


def test_another_page_is_shown_when_the_first_has_gone(progress):
    for page in ("first", "second"):
        progress.see(page, AtSeat(Work(page)))
    progress.look_at("first")
    progress.look_at("second")
    progress.forget("first")
    assert seat(progress).project == "second"


def test_what_the_last_page_showed_stays_when_it_has_gone(progress):
    progress.see("first", AtSeat(Work("square")))
    progress.look_at("first")
    progress.forget("first")
    progress.look_at(None)
    assert seat(progress).project == "square"


def test_a_world_is_kept_until_the_next_one_and_each_has_a_number(progress):
    progress.see("first", AtSeat(Work(), scene=WORLD))
    progress.see("first", AtSeat(Work("square")))
    progress.look_at("first")
    assert (seat(progress).scene, progress.plan_of("a").number) == (1, 1)
    progress.see("second", AtSeat(Work(), scene=WORLD))
    progress.look_at("second")
    assert (seat(progress).scene, progress.plan_of("a").number) == (2, 2)


def test_a_pupil_who_works_without_success_is_stuck(progress, clock):
    for _ in range(10):
        clock.time += 60
        progress.acted("EditText")
    assert seat(progress).stuck == 600
    progress.see("first", AtSeat(Work(), successes=1))
    assert seat(progress).stuck == 0


def test_a_pupil_who_does_nothing_is_quiet_but_not_stuck(progress, clock):
    progress.acted("Run")
    clock.time += 600
    progress.acted("Complete")
    assert (seat(progress).quiet, seat(progress).stuck) == (600, 0)
    progress.acted("EditText")
    assert (seat(progress).quiet, seat(progress).stuck) == (0, 0)


def test_a_pupil_has_begun_with_the_first_thing_that_is_not_done_by_the_page(progress):
    progress.acted("ListProjects")
    assert not seat(progress).begun
    progress.acted("EditText")
    assert seat(progress).begun


def test_a_raised_hand_waits_since_it_was_raised_first(progress, clock):
    progress.raise_hand(on=True)
    clock.time += 60
    progress.raise_hand(on=True)
    assert (seat(progress).hand, seat(progress).waits) == (True, 60)
    progress.raise_hand(on=False)
    assert (seat(progress).hand, seat(progress).waits) == (False, 0)


def test_a_pupil_is_gone_since_the_last_page_was_closed(progress, clock):
    progress.are_here(on=True)
    clock.time += 60
    progress.are_here(on=False)
    clock.time += 30
    progress.are_here(on=False)
    assert seat(progress).gone == 30
    progress.are_here(on=True)
    assert seat(progress).gone == 0


def test_times_change_every_five_seconds_so_that_the_wall_is_not_told_more_often(progress, clock):
    progress.raise_hand(on=True)
    clock.time += 4
    before = seat(progress)
    clock.time += 0.9
    assert seat(progress) == before
    clock.time += 0.1
    assert seat(progress).waits == 5


def test_a_pupil_whose_server_does_not_answer_is_silent_until_it_does(progress, clock):
    clock.time += 60
    progress.answered()
    clock.time += 4
    assert seat(progress).silent == 0
    clock.time += 1
    assert seat(progress).silent == 5
    progress.answered()
    assert seat(progress).silent == 0


def test_a_pupil_without_a_page_is_not_silent(progress, clock):
    clock.time += 60
    assert progress.seat(PUPIL, here=False, writing="no").silent == 0
