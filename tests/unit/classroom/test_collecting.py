"""What pupils of a class have made is collected under the names that the teacher knows."""

from learnblock.classroom.collecting import collect
from learnblock.classroom.pupil_folder import PROJECTS
from learnblock.classroom.roster import Roster
from learnblock.project.files.carried import Carried
from learnblock.project.files.folder import ProjectFolder
from learnblock.project.files.lesson_folder import Progress
from learnblock.project.files.project import Project


def test_only_pupils_who_share_a_name_have_their_ids_in_it(tmp_path):
    roster = Roster(tmp_path, "7b")
    _, first, second = (roster.add(name)[0] for name in ("Bo", "Ana", "Ana"))
    expected = ["Bo", f"Ana ({first.id})", f"Ana ({second.id})"]
    assert [one.pupil for one in collect(roster, "1-03-square", 1)] == expected


def test_a_pupil_who_has_not_begun_has_no_program(tmp_path):
    roster = Roster(tmp_path, "7b")
    roster.add("Bo")
    [bo] = collect(roster, "1-03-square", 1)
    assert (bo.text, bo.absence) == ("", "not begun")


def test_what_a_pupil_has_made_is_the_text_that_it_wrote_with_the_tags_of_its_project(tmp_path):
    roster = Roster(tmp_path, "7b")
    pupil, _ = roster.add("Bo")
    folder = ProjectFolder(roster.folder_of(pupil) / PROJECTS)
    carried = Carried(home="a" * 32, tags={"door": 12})
    folder.write(Project("square", python="robot.stop()\n", tags={"sign": 3}, carried=carried))
    folder.lesson("square").keep_progress(Progress("1-03-square"))
    [bo] = collect(roster, "1-03-square", 1)
    assert (bo.text, bo.is_python) == ("robot.stop()\n", True)
    assert bo.tags == {"door": 12, "sign": 3}
