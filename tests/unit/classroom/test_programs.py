"""The programs that the wall prints: the newest one of each pupil."""

import os

import pytest

from learnblock.classroom.programs import class_programs
from learnblock.classroom.pupil_folder import PROJECTS
from learnblock.classroom.roster import Roster
from learnblock.project.files.folder import ProjectFolder
from learnblock.project.files.project import Project, ProjectPart

PROGRAM = """when start:
    function.stop_bot()
end

main:
    repeat 4:
        function.turn(90)
    end
end
"""


def write(roster, name, *projects):
    """A pupil with these projects, the oldest first."""
    pupil, _ = roster.add(name)
    folder = ProjectFolder(roster.folder_of(pupil) / PROJECTS)
    for project in projects:
        folder.write(project)
    return folder


def test_each_pupil_who_has_made_a_program_is_there_with_its_blocks_and_their_lines(tmp_path):
    roster = Roster(tmp_path, "7b")
    write(roster, "Ana", Project("square", PROGRAM))
    write(roster, "Leo")
    write(roster, "Mia", Project("draft", "main:\n    repeat\n"))
    ana, mia = class_programs(roster).programs
    assert (ana.pupil, ana.project, ana.blocktext) == ("Ana", "square", PROGRAM)
    assert ana.blocks is not None
    types = {block.id: block.type for stack in ana.blocks.stacks for block in stack}
    lines = {types[block]: (first, last) for block, first, last in ana.places if block in types}
    assert sorted(lines.values()) == [(1, 3), (5, 9)]
    assert (mia.pupil, mia.blocktext, mia.blocks) == ("Mia", "main:\n    repeat\n", None)


def test_of_several_projects_the_newest_is_printed_with_the_program_of_each_robot(tmp_path):
    roster = Roster(tmp_path, "7b")
    other = ProjectPart("second", "main:\n    pass\nend\n")
    team = Project("team", PROGRAM, others=(other,))
    folder = write(roster, "Ana", Project("old", PROGRAM), team)
    os.utime(folder.file("old"), (0, 0))
    programs = class_programs(roster).programs
    assert [one.blocktext for one in programs] == [PROGRAM, other.blocktext]


def test_a_damaged_project_does_not_keep_the_others_from_paper(tmp_path):
    roster = Roster(tmp_path, "7b")
    folder = write(roster, "Ana", Project("square", PROGRAM))
    folder.file("square").write_bytes(b"no project")
    write(roster, "Leo", Project("square", PROGRAM))
    assert [one.pupil for one in class_programs(roster).programs] == ["Leo"]


@pytest.mark.certain
@pytest.mark.realtime
def test_only_the_teacher_gets_them(room):
    ana = room.pupil("Ana")
    assert room.ask("/programs.json").status == 403
    assert room.ask("/programs.json", cookie=ana.cookie).status == 403
    answer = room.ask("/programs.json", cookie=room.teacher())
    assert (answer.status, answer.headers["cache-control"]) == (200, "no-store")
