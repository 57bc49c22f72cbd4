"""The past of a real robot, as far as it reported it."""

from types import SimpleNamespace

import pytest

from learnblock.server.runs.reported import Reported

LINES = (
    {"t": 0.1, "odometry": [0, 0, 0]},
    {"t": 0.15, "sensed": "DistanceSensors:ROBOT", "value": {"front": [300.0]}},
    {"t": 0.2, "odometry": [10, 0, 0]},
    {"t": 0.2, "device": "Display", "key": "ROBOT", "do": "show_emotion", "args": ["joy"]},
)


def test_its_pose_its_face_and_its_sensors_are_those_of_the_moment():
    reported = Reported(SimpleNamespace(lines=LINES))
    early, late = reported.at(0.15), reported.at(0.3)
    assert early.robots[0].pose[0] == pytest.approx(5)
    assert (early.robots[0].emotion, late.robots[0].emotion) == ("none", "joy")
    assert [sensor.value for sensor in late.sensors] == [300.0]


def test_a_robot_that_never_reported_where_it_was_has_no_past():
    assert Reported(SimpleNamespace(lines=LINES[1:2])).at(0.2) is None
