import pytest

from learnblock.devices import Controller
from learnblock.errors import UnknownNameError


def test_a_pressed_button_is_distinguished_from_the_others(robot):
    robot.set_reading(Controller, {"lUp": False, "rDown": True})

    assert {"lUp": False, "rDown": True} == robot.get_8_button_controller()
    assert robot.is_press_8_button_controller("rDown")
    assert not robot.is_press_8_button_controller()


def test_an_unknown_button_is_refused_with_the_nearest_one(robot):
    with pytest.raises(UnknownNameError, match=r"no button 'lup'. Did you mean 'lUp'"):
        robot.is_press_8_button_controller("lup")
