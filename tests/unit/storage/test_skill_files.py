import os

import pytest

from learnblock.errors import ProgramError
from learnblock.storage import skill_files


@pytest.fixture
def mine(own_home):
    (own_home / "skills").mkdir()
    return own_home / "skills" / "mine.py"


def test_the_skills_of_a_file_are_its_public_functions_that_take_the_robot(mine):
    mine.write_text(
        "def waltz(robot): ...\ndef _help(robot): ...\ndef g(): ...\nraise SystemExit\n"
    )

    assert ("waltz",) == skill_files.names(mine)


def test_names_are_found_even_in_a_file_that_is_not_valid_python(mine):
    mine.write_text("def waltz(robot, x=(:\n    pass\ndef rumba( robot ): ...\ndef g(): ...\n")

    assert ("waltz", "rumba") == skill_files.names(mine)


def test_a_changed_file_is_read_again(mine):
    mine.write_text("def waltz(robot): ...\n")
    assert ("waltz",) == skill_files.names(mine)
    mine.write_text("def rumba(robot): ...\n")
    os.utime(mine, ns=(0, 0))
    assert ("rumba",) == skill_files.names(mine)


def test_only_python_files_are_files_of_skills(mine):
    mine.write_text("")
    mine.with_name("folder.py").mkdir()
    mine.with_name("notes.txt").write_text("")

    assert (mine,) == skill_files.own_files()


def test_a_file_that_is_too_large_has_no_skills(mine):
    mine.write_text("def waltz(robot): ...\n" + "#" * skill_files.LARGEST)

    assert () == skill_files.names(mine)
    with pytest.raises(ProgramError, match="too-large"):
        skill_files.read(mine)


def test_a_mistake_is_reported_with_its_position():
    with pytest.raises(ProgramError, match=r"mine\.py:2:6: syntax-error This is not valid Python"):
        skill_files.parse("x = 1\ndef f(robot:\n", "mine.py")
