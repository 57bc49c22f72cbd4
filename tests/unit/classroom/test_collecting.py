"""What pupils have handed in or made is collected under the names that the teacher knows."""

from learnblock.classroom.collecting import collect
from learnblock.classroom.hand_ins import HandInShelf
from learnblock.classroom.pupil_folder import PROJECTS
from learnblock.classroom.roster import Roster
from learnblock.lessons.reading import find_lesson
from learnblock.project.files.carried import Carried
from learnblock.project.files.folder import ProjectFolder
from learnblock.project.files.lesson_folder import Progress
from learnblock.project.files.project import Project
from learnblock.server.messages import GivenProgram, GivenWork

SQUARE = find_lesson("1-03-square")


def test_only_pupils_who_share_a_name_have_numbers(tmp_path):
    roster = Roster(tmp_path, "7b")
    for name in ("Bo", "Ana", "Ana"):
        roster.add(name)
    expected = ["Bo", "Ana 1", "Ana 2"]
    assert [one.pupil for one in collect(roster, SQUARE, 1)] == expected


def test_a_pupil_who_has_not_begun_has_no_program(tmp_path):
    roster = Roster(tmp_path, "7b")
    roster.add("Bo")
    [bo] = collect(roster, SQUARE, 1)
    assert (bo.text, bo.absence) == ("", "not begun")


def test_what_a_pupil_has_made_is_the_text_that_it_wrote_with_the_tags_of_its_project(tmp_path):
    roster = Roster(tmp_path, "7b")
    pupil, _ = roster.add("Bo")
    folder = ProjectFolder(roster.folder_of(pupil) / PROJECTS)
    carried = Carried(home="a" * 32, tags={"door": 12})
    folder.write(Project("square", python="robot.stop()\n", tags={"sign": 3}, carried=carried))
    folder.lesson("square").keep_progress(Progress("1-03-square"))
    [bo] = collect(roster, SQUARE, 1)
    assert (bo.text, bo.is_python) == ("robot.stop()\n", True)
    assert bo.tags == {"door": 12, "sign": 3}


def begun(roster, name, text, *, step, kept=(), steps=None):
    """A pupil whose project is at a step, with the programs that were left in others."""
    pupil, _ = roster.add(name)
    folder = ProjectFolder(roster.folder_of(pupil) / PROJECTS)
    folder.write(Project("square", text))
    lesson = folder.lesson("square")
    lesson.keep_progress(Progress("1-03-square", step=step, steps=steps or {}))
    for number, left in kept:
        lesson.keep_program(number, Project("square", left))
    return pupil


def first_continued():
    """A step of the lesson that continues the program of the step before it."""
    steps = range(2, len(SQUARE.lesson.step) + 1)
    return next(step for step in steps if SQUARE.group(step) == step - 1)


def test_a_step_that_continues_the_program_of_the_one_before_has_that_program(tmp_path):
    roster, step = Roster(tmp_path, "7b"), first_continued()
    begun(roster, "Bo", "main:\nend\n", step=step)
    later = next(n for n in range(step, len(SQUARE.lesson.step) + 1) if SQUARE.group(n) > step - 1)
    begun(roster, "Eva", "", step=later, kept=[(step - 1, "main:\n    pass\nend\n")])
    bo, eva = collect(roster, SQUARE, step)
    assert (bo.text, eva.text) == ("main:\nend\n", "main:\n    pass\nend\n")


def test_who_is_a_step_before_has_not_begun_although_both_share_a_program(tmp_path):
    roster, step = Roster(tmp_path, "7b"), first_continued()
    begun(roster, "Bo", "main:\nend\n", step=step - 1)
    [bo] = collect(roster, SQUARE, step)
    assert bo.absence == "not begun"


def test_what_was_handed_in_counts_and_not_what_was_made_since(tmp_path):
    roster = Roster(tmp_path, "7b")
    bo = begun(roster, "Bo", "main:\n    pass\nend\n", step=1)
    handed_in = GivenProgram("main:\nend\n")
    HandInShelf(tmp_path).add(bo.id, GivenWork("1-03-square", 1, handed_in))
    begun(roster, "Eva", "main:\nend\n", step=1)
    roster.add("Ada")
    rows = [(row.text, row.absence) for row in collect(roster, SQUARE, 1, only_handed_in=True)]
    assert rows == [("main:\nend\n", ""), ("", "not handed in"), ("", "not begun")]
    assert [row.absence for row in collect(roster, SQUARE, 1)] == ["", "", "not begun"]
