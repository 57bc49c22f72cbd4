"""Projects on the command line: run and checked with what they bring, and nothing is installed."""

import json

import pytest
from click.testing import CliRunner

import homes
from learnblock.cli import main
from learnblock.extensions import custom_blocks, worlds
from learnblock.extensions.worlds import PackedWorld
from learnblock.perception import tag_names
from learnblock.project.files.packing import encode_whole
from learnblock.project.files.project import Project, ProjectPart
from learnblock.project.files.project_file import encode
from shared_worlds import OTHER_ROOM, ROOM

DRIVES = "main:\n    function.move_straight(100)\n    function.sleep(5)\nend\n"


@pytest.fixture(autouse=True)
def at_home(tmp_path, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path / "home"))


def call(*arguments):
    return CliRunner().invoke(main, [str(argument) for argument in arguments])


def report(*arguments):
    shown = call("run", *arguments, "--json")
    return json.loads(shown.stdout)


@pytest.fixture
def leave(tmp_path, monkeypatch):
    """Write a project, and go to the folder of another user."""

    def leave(project):
        path = tmp_path / f"{project.name}.learnblock"
        path.write_bytes(encode_whole(project))
        monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path / "elsewhere"))
        return path

    return leave


def test_a_project_runs_on_its_robot_in_its_world(tmp_path):
    path = tmp_path / "p.learnblock"
    path.write_bytes(encode(Project("p", DRIVES, robot="sim-thymio", world="line")))
    program = tmp_path / "p.bt"
    program.write_text(DRIVES)
    same = report(program, "--robot", "sim-thymio", "--world", "line")
    assert report(path)["trace_sha256"] == same["trace_sha256"]


def test_a_project_with_several_robots_runs_as_its_programs_together(tmp_path):
    programs = {"one": "sim-ebo", "two": "sim-thymio"}
    parts = [ProjectPart(name, DRIVES, robot=robot) for name, robot in programs.items()]
    path = tmp_path / "p.learnblock"
    path.write_bytes(encode(Project("p", world="sumo").with_parts(parts)))
    for name in programs:
        (tmp_path / f"{name}.bt").write_text(DRIVES)
    found = report(path)
    named = [f"{tmp_path / name}.bt@{robot}" for name, robot in programs.items()]
    same = report(*named, "--world", "sumo")
    assert [(one["name"], one["robot"]) for one in found["robots"]] == [*programs.items()]
    assert [one["pose"] for one in found["robots"]] == [one["pose"] for one in same["robots"]]


def test_a_project_runs_a_shared_program_in_all_its_robots(tmp_path):
    path = tmp_path / "p.learnblock"
    project = Project("p", world="empty")
    path.write_bytes(encode(project.with_parts([ProjectPart("ant", DRIVES, count=3)])))
    program = tmp_path / "ant.bt"
    program.write_text(DRIVES)
    found, same = report(path), report(f"{program}@sim-ebo:3", "--world", "empty")
    assert [one["name"] for one in found["robots"]] == ["ant-1", "ant-2", "ant-3"]
    assert [one["pose"] for one in found["robots"]] == [one["pose"] for one in same["robots"]]


def test_a_mistake_in_a_project_with_several_robots_names_the_robot(tmp_path):
    parts = [ProjectPart("one", DRIVES), ProjectPart("two", "main:\n    print(\nend\n")]
    path = tmp_path / "p.learnblock"
    path.write_bytes(encode(Project("p").with_parts(parts)))
    shown = call("run", path)
    assert shown.exit_code == 1
    assert "p.learnblock (two)" in shown.output


def test_a_project_runs_in_the_world_that_it_brings_and_installs_nothing(leave, tmp_path):
    worlds.install(PackedWorld("room", ROOM))
    project = Project("p", DRIVES, world="room")
    path = leave(project)
    there = report(path)
    assert there["ended"] == "finished"
    assert list((tmp_path / "elsewhere").rglob("*.toml")) == []
    empty = report(path, "--world", "empty")
    assert there["pose"] != empty["pose"]


def test_another_world_of_the_same_name_is_not_used(leave):
    worlds.install(PackedWorld("room", ROOM.replace("[0, 0], [500, 0]", "[200, -300], [200, 300]")))
    path = leave(Project("p", DRIVES, world="room"))
    first = report(path)["trace_sha256"]
    worlds.install(PackedWorld("room", OTHER_ROOM))
    assert report(path)["trace_sha256"] == first


def test_a_project_uses_its_numbers_of_tags_and_the_users_stay(leave):
    tag_names.save_names({"door": 12})
    path = leave(Project("p", 'main:\n    function.is_tag("door")\n    print("ok")\nend\n'))
    assert report(path)["output"] == "ok\n"
    assert tag_names.tag_names() == {}


def test_code_that_a_project_brings_is_named_and_not_installed(leave):
    homes.furnish()
    path = leave(Project("p", homes.PROGRAM, libraries={"moves": "1.0.0"}))
    shown = call("check", path)
    assert shown.exit_code == 1
    assert "brings code that is not installed here: dances, turns" in shown.output
    assert "moves" in shown.output
    assert custom_blocks.load_all() == ()


def test_a_damaged_project_is_refused(tmp_path):
    path = tmp_path / "p.learnblock"
    path.write_text('{"learnblock": 1}')
    for command in ("run", "check"):
        shown = call(command, path)
        assert shown.exit_code != 0
        assert "blocktext" in shown.output
