"""Names of new robots and skills: they become names of files, modules and functions."""

import pytest

from learnblock.errors import NewNameError
from learnblock.new.names import check_robot_name, check_skill_name

HOSTILE = ("", "../up", "a/b", "a\\b", "a b", "a\n", "ñandú", "-a", "a-", "a--b", "1st", "x" * 41)


@pytest.mark.parametrize("name", ["pathfinder", "pi-rover-2", "x"])
def test_a_robot_name_has_lower_case_letters_digits_and_hyphens(name):
    check_robot_name(name)


@pytest.mark.parametrize("name", [*HOSTILE, "Rover", "my_rover", "class", "con", "lpt1"])
def test_an_invalid_robot_name_is_refused(name):
    with pytest.raises(NewNameError, match=r"A robot cannot be named (.|\n)* at most 40"):
        check_robot_name(name)


def test_a_similar_name_is_suggested():
    with pytest.raises(NewNameError, match="such as my-rover-2"):
        check_robot_name("My rover 2!")


@pytest.mark.parametrize("name", ["ebo", "thymio", "sim-ebo", "sim-mine"])
def test_a_name_that_is_taken_is_refused(name):
    with pytest.raises(NewNameError, match=r"already|Leave out sim-"):
        check_robot_name(name)


def test_a_custom_robot_may_be_replaced(own_home):
    (own_home / "robots").mkdir()
    (own_home / "robots" / "mine.py").touch()
    check_robot_name("mine")


@pytest.mark.parametrize("name", [*HOSTILE, "Waltz", "a-b", "while", "con"])
def test_an_invalid_skill_name_is_refused(name, tmp_path):
    with pytest.raises(NewNameError, match=r"A skill cannot be named (.|\n)* at most 40"):
        check_skill_name(name, tmp_path / "skill.py")


@pytest.mark.parametrize("name", ["stop", "move_straight", "is_tag"])
def test_a_skill_of_every_robot_is_not_written_again(name, tmp_path):
    with pytest.raises(NewNameError, match=f"Every robot already has a '{name}'"):
        check_skill_name(name, tmp_path / "skill.py")


def test_a_custom_skill_may_be_replaced(own_home):
    file = own_home / "skills" / "waltz.py"
    file.parent.mkdir()
    file.write_text("def waltz(robot): pass")
    check_skill_name("waltz", file)
    with pytest.raises(NewNameError, match="Every robot already has a 'waltz'"):
        check_skill_name("waltz", file.with_name("other.py"))
