"""What the wall shows of a pupil, from the messages that pass by."""

import json
import typing

import msgspec
import pytest

from clocks import Clock
from learnblock.classroom import progress as module
from learnblock.classroom.pins import Pin, new_pictures
from learnblock.classroom.progress import Progress
from learnblock.classroom.roster import Pupil
from learnblock.server import messages

pytestmark = pytest.mark.realtime

PUPIL = Pupil("a" * 10, "Ana", Pin.of(new_pictures()), 0.0)


@pytest.fixture
def clock():
    return Clock(1000.0)


@pytest.fixture
def progress(clock):
    return Progress(clock)


def seat(progress):
    return progress.seat(PUPIL, here=True, hand=False, writing="no")


def see(progress, kind, **values):
    progress.see(json.dumps({"kind": kind, **values}, separators=(",", ":")))


def drive(progress, clock, *places):
    for x, y in places:
        clock.time += 0.5
        robot = {"name": "ebo", "x": x, "y": y, "heading": 90.0}
        see(progress, "Telemetry", time=1.0, robots=[robot])


@pytest.mark.parametrize("kind", sorted(module._READERS))
def test_what_is_read_is_what_the_server_sends(kind):
    ours, theirs = getattr(module, kind), getattr(messages, kind)
    assert theirs in typing.get_args(messages.TO_PAGE)
    names = {field.name for field in msgspec.structs.fields(theirs)}
    assert {field.name for field in msgspec.structs.fields(ours)} <= names


def test_the_way_has_no_points_close_to_each_other(progress, clock):
    drive(progress, clock, (0, 0), (1, 0), (10, 0), (20, 0), (40, 0))
    assert seat(progress).way == (0, 0, 20, 0, 40, 0)
    assert seat(progress).pose == (40, 0, 90)


def test_the_last_place_is_shown_even_if_it_came_at_once(progress, clock):
    drive(progress, clock, (0, 0), (50, 0))
    clock.time += 0.01
    robot = {"name": "ebo", "x": 80.0, "y": 0.0, "heading": 0.0}
    see(progress, "Telemetry", time=1.0, robots=[robot])
    assert seat(progress).pose == (80, 0, 0)


def test_the_way_is_bounded(progress, clock):
    drive(progress, clock, *((20 * n, 0) for n in range(1000)))
    assert len(seat(progress).way) == 800
    assert seat(progress).way[-2:] == (20 * 999, 0)


def test_a_new_run_begins_a_new_way(progress, clock):
    drive(progress, clock, (0, 0), (50, 0))
    see(progress, "RunState", state="starting")
    assert seat(progress).way == ()


def test_a_mistake_in_the_program_is_shown_until_it_is_gone(progress):
    problem = {"code": "x", "message": {"code": "check-x"}, "severity": "error", "view": "blocks"}
    warning = {**problem, "severity": "warning"}
    see(progress, "Document", edit=1, revision=1, origin="blocks", problems=[warning])
    assert seat(progress).error is None
    see(progress, "Document", edit=1, revision=1, origin="blocks", problems=[problem])
    assert seat(progress).error == {"code": "check-x"}
    see(progress, "Document", edit=2, revision=2, origin="blocks")
    assert seat(progress).error is None


def test_a_run_that_ends_badly_is_shown_and_a_stopped_one_is_not(progress):
    see(progress, "Ended", ended="error", message={"code": "run-x"})
    assert seat(progress).error == {"code": "run-x"}
    see(progress, "Ended", ended="stopped", message={"code": "run-stopped"})
    assert seat(progress).error is None


def test_a_pupil_who_works_without_success_is_stuck(progress, clock):
    for _ in range(10):
        clock.time += 60
        progress.acted("EditText")
    assert seat(progress).stuck == 600
    see(progress, "Ended", ended="finished")
    assert seat(progress).stuck == 0


def test_a_pupil_who_does_nothing_is_quiet_but_not_stuck(progress, clock):
    progress.acted("Run")
    clock.time += 600
    progress.acted("Complete")
    assert (seat(progress).quiet, seat(progress).stuck) == (600, 0)
    progress.acted("EditText")
    assert (seat(progress).quiet, seat(progress).stuck) == (0, 0)


def test_stars_and_steps_of_a_lesson_are_shown(progress):
    steps = [{"title": "a", "phase": "run", "earned": 2}, {"title": "b", "phase": "make"}]
    see(progress, "LessonShown", name="one", title={"en": "One"}, steps=steps, step=2)
    shown = seat(progress)
    assert (shown.lesson, shown.step, shown.steps, shown.stars) == ({"en": "One"}, 2, 2, 2)
    steps[1]["earned"] = 1
    see(progress, "LessonGoals", goals=[], earned=1, steps=steps)
    assert seat(progress).stars == 3
    see(progress, "LessonShown")
    assert (seat(progress).lesson, seat(progress).step) == ("", 0)


def test_other_messages_are_not_read(progress):
    before = seat(progress)
    for text in ("", "[]", "{}", '{"kind":"Printed","text":"x"}', '{"x":1,"kind":"Opened"}', "\0"):
        progress.see(text)
    assert seat(progress) == before
