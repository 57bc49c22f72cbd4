"""Values, skills and movements in words."""

import pytest

from learnblock.i18n import translate
from learnblock.why.wording import (
    BACK,
    CURVE_LEFT,
    CURVE_RIGHT,
    FORWARD,
    SPIN_LEFT,
    SPIN_RIGHT,
    STAND,
    answer_phrase,
    movement,
    movement_phrase,
    skill_phrase,
    unpacked,
    value_phrase,
)


@pytest.mark.parametrize(
    ("advance", "rotation", "name"),
    [
        (0, 0, STAND),
        (50, 0, FORWARD),
        (-50, 0.4, BACK),
        (0, -20, SPIN_LEFT),
        (0, 20, SPIN_RIGHT),
        (30, -20, CURVE_LEFT),
        (30, 20, CURVE_RIGHT),
    ],
)
def test_a_command_to_the_wheels_has_a_name(advance, rotation, name):
    assert movement(advance, rotation) == name
    assert translate(movement_phrase(name), "es") != translate(movement_phrase(name), "en")


def test_a_skill_is_said_as_its_block_says_it():
    said = skill_phrase("turn", [45])
    assert str(said) == "turn right by 45°"
    assert said.texts["es"] == "girar 45° a la derecha"
    assert skill_phrase("my_own_skill") == "my_own_skill"


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (True, "True"),
        (False, "False"),
        (None, "nothing"),
        (1.23456, "1.23"),
        ("a", '"a"'),
        ([1, 2.5, "x"], "[1, 2.5, 'x']"),
        ({"pairs": [["a", 1]]}, "{'a': 1}"),
        ([1, {"more": 30}], "[1, ...]"),
    ],
)
def test_a_value_is_written_as_in_the_program(value, text):
    assert str(value_phrase(value)) == text


@pytest.mark.parametrize(("value", "text"), [(True, "yes"), (False, "no"), (None, "nothing")])
def test_what_a_skill_answered_is_yes_or_no(value, text):
    assert str(answer_phrase(value)) == text


def test_a_reading_is_unpacked():
    packed = {"pairs": [["front", [1.0]], ["back", []]]}
    assert unpacked(packed) == {"front": [1.0], "back": []}
