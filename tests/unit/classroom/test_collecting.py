"""What pupils of a class have made is collected under the names that the teacher knows."""

from learnblock.classroom.collecting import collect
from learnblock.classroom.roster import Roster


def test_only_pupils_who_share_a_name_have_their_ids_in_it(tmp_path):
    roster = Roster(tmp_path, "7b")
    _, first, second = (roster.add(name)[0] for name in ("Bo", "Ana", "Ana"))
    expected = ["Bo", f"Ana ({first.id})", f"Ana ({second.id})"]
    assert [one.pupil for one in collect(roster, "1-03-square", 1)] == expected


def test_a_pupil_who_has_not_begun_has_neither_a_program_nor_a_problem(tmp_path):
    roster = Roster(tmp_path, "7b")
    roster.add("Bo")
    [bo] = collect(roster, "1-03-square", 1)
    assert (bo.project, bo.problem) == (None, None)
