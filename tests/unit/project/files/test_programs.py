"""The programs in a file are read with what its project says of them, and nothing is installed."""

import pytest

import homes
from learnblock.errors import FileError
from learnblock.extensions import custom_blocks
from learnblock.project.files.carried import Carried, Code
from learnblock.project.files.programs import opened, opened_all, read, robots_in
from learnblock.project.files.project import Project, ProjectPart
from learnblock.project.files.project_file import encode

DRIVES = "main:\n    function.move_straight(100)\nend\n"


@pytest.fixture
def write(tmp_path):
    def write(project):
        path = tmp_path / f"{project.name}.learnblock"
        path.write_bytes(encode(project))
        return path

    return write


def test_a_program_alone_has_no_robot_world_or_tags(tmp_path):
    path = tmp_path / "p.bt"
    path.write_text(DRIVES)
    with opened(path, pytest.fail) as found:
        assert (found.source.text, found.robot, found.world, found.tags) == (DRIVES, None, None, {})
    assert robots_in(path) == 1


def test_a_project_gives_the_text_that_its_author_wrote(write):
    python = "from learnblock.robots.sim_ebo import Robot\n\nrobot = Robot()\nrobot.stop_bot()\n"
    path = write(Project("p", DRIVES, python=python, robot="sim-thymio", world="line"))
    with opened(path, pytest.fail) as found:
        assert (found.source.text, found.source.is_python) == (python, True)
        assert (found.robot, found.world) == ("sim-thymio", "line")


def test_each_robot_of_a_project_has_its_program(write):
    parts = (ProjectPart("one", DRIVES), ProjectPart("two", DRIVES, robot="sim-ev3", count=3))
    path = write(Project("p", world="line").with_parts(parts))
    with opened_all(path, pytest.fail) as found:
        assert [(one.name, one.robot, one.count) for one in found] == [
            ("one", "sim-ebo", 1),
            ("two", "sim-ev3", 3),
        ]
    assert robots_in(path) == 4


def test_code_that_a_project_brings_is_reported_and_not_installed(write):
    code = Code({"dances": {"learnblock_block": 1, "source": homes.WALTZ.split("\n")}}, {})
    path = write(Project("p", DRIVES, carried=Carried(home="a" * 32, code=code)))
    reports = []
    read(path, reports.append)
    assert [(one.code, one.values["names"]) for one in reports] == [("project-code", ("dances",))]
    assert [*custom_blocks.load_all()] == []


def test_a_mistake_names_the_file(tmp_path):
    path = tmp_path / "p.learnblock"
    path.write_text("{")
    with pytest.raises(FileError), opened(path, pytest.fail):
        pass
    assert robots_in(path) == 1
