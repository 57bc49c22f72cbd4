"""Obstacles and brightness, by whichever device there is."""

import numpy as np
import pytest

from learnblock.devices import Bumper, Camera, DistanceSensors, LightSensor
from learnblock.testing import FakeRobot


class Noted:
    def __init__(self):
        self.lacking = []

    def called(self, skill, args, kwargs):
        pass

    def missing(self, skill, device):
        self.lacking.append((skill, device))


def test_the_nearest_of_a_side_s_distances_counts():
    with FakeRobot(only=[DistanceSensors, Bumper]) as robot:
        robot.set_reading(DistanceSensors, {"front": [300.0, 120.0], "left": [90.0]})

        assert robot.senses.distance("front") == 120
        assert robot.senses.distance("left") == 90


@pytest.mark.parametrize(("pressed", "mm"), [(True, 0), (False, 2000)])
def test_a_bumper_feels_what_it_touches(pressed, mm):
    with FakeRobot(only=[Bumper]) as robot:
        robot.set_reading(Bumper, pressed)

        assert robot.senses.distance("front") == mm


def test_a_sense_that_nothing_serves_is_reported_by_name():
    noted = Noted()
    with FakeRobot(only=[Bumper], observer=noted) as robot:
        assert robot.is_left_obstacle() is False

    assert noted.lacking == [("is_left_obstacle", "obstacle-left")]


def test_a_light_sensor_tells_the_brightness_before_a_camera_does():
    with FakeRobot(only=[LightSensor, Camera]) as robot:
        robot.set_reading(LightSensor, 700.0)

        assert robot.senses.brightness() == 700


def test_a_camera_takes_the_brightness_of_its_picture():
    with FakeRobot(only=[Camera]) as robot:
        robot.set_reading(Camera, np.full((240, 320, 3), 255, np.uint8))
        bright = robot.senses.brightness()
        robot.set_reading(Camera, np.zeros((240, 320, 3), np.uint8))

        assert bright == 1023
        assert robot.senses.brightness() == 0
