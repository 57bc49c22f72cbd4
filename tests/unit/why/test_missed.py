"""By how much a run missed a goal of its world, also if the log lacks what tells."""

import math
from dataclasses import replace

import pytest

from learnblock.i18n import Phrase
from learnblock.why.missed import first_missed, goal_missed
from logged_runs import logged_text

SQUARE = "repeat(4):\n    function.drive_distance({})\n    function.turn(90)\nend\n"


@pytest.fixture(scope="module")
def recorded(tmp_path_factory):
    folder = tmp_path_factory.mktemp("run")
    return logged_text(folder, SQUARE.format(300), "sim-ev3", world="square", seconds=60).recorded


def test_the_first_goal_that_a_run_missed_has_its_place_and_how_near_the_robot_came(recorded):
    miss = first_missed(recorded)
    assert miss.words.code == "miss-corner"
    assert miss.words.values["gap"] == Phrase("miss-gap-left", mm=100)
    assert miss.place == (100, -100)
    assert miss.nearest == pytest.approx((200, -100), abs=10)


def test_a_goal_is_measured_up_to_the_moment_that_is_asked_about(recorded):
    at_start = goal_missed(recorded, "four corners", 0.5)
    assert at_start.words.values["number"] == 1


def test_a_run_that_reached_its_goals_has_missed_none(tmp_path):
    run = logged_text(tmp_path, SQUARE.format(200), "sim-ev3", world="square", seconds=60)
    assert first_missed(run.recorded) is None


def test_nothing_is_said_of_a_run_without_its_world(recorded):
    lines = tuple(line for line in recorded.lines if not isinstance(line.get("robot"), dict))
    assert first_missed(replace(recorded, lines=lines)) is None


def test_a_run_that_goes_on_has_missed_nothing_yet(recorded):
    assert first_missed(replace(recorded, ending={})) is None


def test_a_miss_tells_when_the_robot_was_nearest(recorded):
    miss = first_missed(recorded)
    path = [(line["t"], line["pose"]) for line in recorded.lines if "pose" in line]
    x, y = miss.nearest
    time, _ = min(path, key=lambda seen: math.dist(seen[1][:2], (x, y)))
    assert miss.time == pytest.approx(time, abs=0.5)
    assert miss.time < recorded.ending["time"] - 1
