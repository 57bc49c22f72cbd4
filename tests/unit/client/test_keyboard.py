import pytest

from learnblock.client.keyboard import KEYS, Keyboard
from learnblock.errors import UnknownNameError


def test_only_the_keys_that_are_held_down_are_pressed():
    keyboard = Keyboard(lambda: ["up", "a"])
    assert [key for key in KEYS if keyboard.is_pressed(key)] == ["up", "a"]


def test_nobody_presses_the_keys_of_a_robot_without_a_keyboard():
    assert not any(map(Keyboard().is_pressed, KEYS))


@pytest.mark.parametrize(("name", "near"), [("spce", "space"), ("UP", "up"), (3, "3")])
def test_a_misspelt_key_is_refused_with_the_right_name(name, near):
    with pytest.raises(UnknownNameError, match=f"Did you mean '{near}'"):
        Keyboard().is_pressed(name)
