"""The way of a robot at any time, from where it was now and then."""

import math

import pytest

from learnblock.why.ways import Way, odometry, turned


def test_between_two_poses_the_robot_is_in_between():
    way = Way.of([(0, (0, 0, 0)), (0.1, (10, 0, 20))])
    assert way.at(0.05) == pytest.approx((5, 0, 10))
    assert (way.at(-1), way.at(9)) == ((0, 0, 0), (10, 0, 20))


def test_a_robot_that_reported_nothing_stood_still_until_a_moment_ago():
    way = Way.of([(0, (0, 0, 0)), (5, (10, 0, 0))])
    assert way.at(4.8) == (0, 0, 0)


def test_headings_count_full_turns():
    way = Way.of([(0.1 * number, (0, 0, (170 + 20 * number) % 360 - 180)) for number in range(19)])
    assert way.turn(0, 1.8) == pytest.approx(360)


def test_driving_backward_counts_as_negative():
    way = Way.of([(0, (0, 0, 0)), (0.1, (30, 0, 0)), (0.2, (10, 0, 0))])
    assert way.travel(0, 0.1) == 30
    assert way.travel(0, 0.2) == 10


def test_a_way_can_be_moved_to_another_start():
    # Headings are clockwise: heading 90 looks along -y.
    way = Way.of([(0, (5, 5, 0)), (0.1, (15, 5, 0)), (0.2, (15, 8, -90))]).moved_to((1, 2, 90))
    assert way.poses[1] == pytest.approx((1, -8, 90))
    assert way.poses[2] == pytest.approx((4, -8, 0))


def test_the_way_that_a_robot_reported_is_in_its_log():
    lines = [
        {"t": 0.1, "odometry": [1, 2, 3]},
        {"t": 0.2, "line": 4},
        {"t": 0.2, "odometry": [4, 5, 6]},
    ]
    assert odometry(lines).poses == ((1, 2, 3), (4, 5, 6))


def test_a_reset_of_the_gyroscope_is_no_turn():
    lines = [
        {"t": 1.0, "sensed": "Gyroscope:Z_AXIS", "value": 90.0},
        {"t": 1.05, "device": "Gyroscope", "key": "Z_AXIS", "do": "reset", "args": []},
        {"t": 1.06, "sensed": "Gyroscope:Z_AXIS", "value": 90.0},
        {"t": 1.3, "sensed": "Gyroscope:Z_AXIS", "value": 10.0},
    ]
    assert turned(lines).at(1.3)[2] == 100
    assert math.isclose(max(pose[2] for pose in turned(lines).poses), 100)
