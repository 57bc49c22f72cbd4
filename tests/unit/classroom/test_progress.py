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
    return progress.seat(PUPIL, here=True, hand=False, writing="no")


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
    assert (seat(progress).scene, progress.plan_of("a").scene) == (1, 1)
    progress.see("second", AtSeat(Work(), scene=WORLD))
    progress.look_at("second")
    assert (seat(progress).scene, progress.plan_of("a").scene) == (2, 2)


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
