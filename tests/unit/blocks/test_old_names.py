"""The table of old and Spanish names of skills."""

import pytest

from learnblock.blocks import builtin
from learnblock.blocks.old_names import OLD_NAMES, todays_name


def test_every_old_name_leads_to_a_skill_of_today() -> None:
    unknown = {name for name in OLD_NAMES.values() if name not in builtin()}
    assert unknown == set()


def test_no_old_name_is_a_skill_of_today() -> None:
    assert [name for name in OLD_NAMES if name in builtin()] == []


@pytest.mark.parametrize(
    ("old", "today"),
    [
        ("center_black_line", "is_center_black_line"),
        ("left_blue_line", "is_left_blue_line"),
        ("front_obstacle", "is_front_obstacle"),
        ("is_there_somebody_happy", "is_any_face_happy"),
        ("linea_roja_centro", "is_center_red_line"),
        ("Mover_Recto", "move_straight"),
        ("desacelerar", "slow_down"),
        ("obstacle_free", "is_obstacle_free"),
    ],
)
def test_an_old_name_has_a_name_of_today(old: str, today: str) -> None:
    assert todays_name(old, builtin()) == today


def test_a_name_that_was_never_a_skill_has_none() -> None:
    assert todays_name("fly", builtin()) is None
