import pytest

from learnblock.devices import LightSensor


def test_the_light_is_what_the_sensor_reads(robot):
    robot.set_reading(LightSensor, 321)

    assert 321 == robot.get_light()


@pytest.mark.parametrize(("light", "bright"), [(500, False), (501, True)])
def test_it_is_bright_above_500_by_default(robot, light, bright):
    robot.set_reading(LightSensor, light)

    assert bright is robot.is_illuminated()
    assert robot.is_illuminated(threshold=100) is True
