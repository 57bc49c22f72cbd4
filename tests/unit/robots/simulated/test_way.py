"""What notebooks show of a simulated robot."""

import re

import pytest

from learnblock.robots.sim_ebo import Robot
from learnblock.robots.simulated.way import DrivenWay


@pytest.fixture(autouse=True)
def notebook(monkeypatch):
    """No program is running, whatever earlier tests have left in `__main__`."""
    monkeypatch.setattr("learnblock.robots.simulated.robot.main_program", lambda: None)


def shown(robot) -> str:
    return robot._repr_mimebundle_(include=None, exclude=None)["image/svg+xml"]


def test_it_is_its_world_with_a_title_for_those_who_cannot_see_it():
    with Robot(world="square") as robot:
        assert "<title>EBO: square</title>" in shown(robot)
        assert "back at the start" in shown(robot)


def test_the_way_grows_with_what_the_robot_drives():
    with Robot(world="empty") as robot:
        robot.drive_distance(200)
        once = re.search(r"([\d.]+) m in", shown(robot))
        robot.drive_distance(200)
        twice = re.search(r"([\d.]+) m in", shown(robot))
    assert float(once[1]) < 0.25 < float(twice[1])


def test_a_long_way_keeps_its_ends_and_half_of_its_points():
    way = DrivenWay()
    for second in range(20_001):
        way.pose(second, (second, 0, 0))
    assert [(0, 0, 0, 0), (20_000, 20_000, 0, 0)] == [way.points[0], way.points[-1]]
    assert 10_001 == len(way.points)
