"""What a lesson has for its teacher, as it is shown."""

import pytest

import small_lesson
from learnblock.i18n import Phrase, languages, translate
from learnblock.language import parse
from learnblock.lessons.reading import for_pupils, read_files, shipped
from learnblock.lessons.teachers_part import teachers_part
from lesson_tries import read_once

TEACHER = """solutions = { 2 = "two.py" }

[[wrong]]
step = 2
program = "none.bt"
check = "drives"
hint = "hint-never-moved"

[[wrong]]
step = 2
program = "none.bt"
check = "uses"
hint = "teacher-1"
"""
PYTHON = """from learnblock.robots.sim_cozmo import Robot

robot = Robot()

robot.turn(90)
"""
IDLE = "main:\n    function.sleep(1)\nend\n"


@pytest.fixture
def opened():
    written = {
        **small_lesson.FILES,
        "teacher/teacher.toml": TEACHER,
        "teacher/solutions/two.py": PYTHON,
        "teacher/wrong/none.bt": IDLE,
        "teacher/notes.es.md": "Una nota",
    }
    del written["teacher/solutions/two.bt"]
    return read_files("small", {path: text.encode() for path, text in written.items()})


def test_notes_are_in_every_language_that_they_are_written_in(opened):
    assert teachers_part(opened).notes == {"en": small_lesson.SECRET, "es": "Una nota"}


def test_a_solution_in_python_is_shown_as_block_text(opened):
    first, second, _ = teachers_part(opened).steps
    assert first.solution == ""
    assert second.solution == "function.turn(90)\n"


def test_a_wrong_program_has_its_check_in_words_and_its_hint(opened):
    ours, teachers = teachers_part(opened).steps[1].wrong
    assert ours.program == IDLE
    assert str(ours.check) == "Drive at least 100 mm."
    assert ours.hint == (Phrase("hint-never-moved-how"),)
    assert teachers.hint[0] == "Look at the number in the wait block."


def test_pupils_have_nothing_of_it(opened):
    part = teachers_part(for_pupils(opened))
    assert part.notes == {}
    assert not any(one.solution or one.wrong for one in part.steps)


@pytest.mark.parametrize("name", shipped())
def test_every_lesson_of_ours_has_notes_readable_solutions_and_hints_with_words(name):
    part = teachers_part(read_once(name))
    assert set(languages()) <= part.notes.keys()
    assert all(parse(one.solution) for one in part.steps if one.solution)
    wrong = [one for step in part.steps for one in step.wrong]
    assert len(wrong) >= 3
    for one in wrong:
        assert one.hint
        for level in one.hint:
            if isinstance(level, Phrase):
                # A phrase without words is returned as its code.
                assert translate(level, "es") != level.code
