"""What a project's file carries: it runs elsewhere as it did, and nothing is replaced there."""

import json
from dataclasses import replace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import homes
from learnblock.errors import ProjectError
from learnblock.extensions import custom_blocks, libraries, worlds
from learnblock.extensions.worlds import PackedWorld
from learnblock.perception import tag_names
from learnblock.project.files import unpacking
from learnblock.project.files.carried import Carried, CarriedWorld, Code
from learnblock.project.files.exchange import export
from learnblock.project.files.packing import encode_whole, fits, packed
from learnblock.project.files.project import Project
from learnblock.project.files.project_file import LARGEST, decode, encode
from learnblock.project.files.unpacking import only_read, unpacked
from learnblock.robots.simulated import find_world
from learnblock.storage.home import home, home_id
from shared_worlds import MAT, OTHER_ROOM, ROOM, png

PROJECT = Project("dance", homes.PROGRAM, world="mat", libraries={"moves": "1.0.0"})


@pytest.fixture(autouse=True)
def at_home(tmp_path, monkeypatch):
    """The folder where the projects are made."""
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path / "home"))


@pytest.fixture
def go(tmp_path, monkeypatch):
    """Go to the folder of another user."""

    def there(name="elsewhere"):
        monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path / name))

    return there


@pytest.fixture
def file():
    homes.furnish()
    return encode_whole(PROJECT)


def codes(phrases):
    return [phrase.code for phrase in phrases]


def test_a_file_carries_what_its_program_needs_and_nothing_else(file):
    carried = decode(file, "dance").carried
    assert carried.home == home_id() != ""
    assert carried.world == CarriedWorld("mat", MAT.split("\n"), png(20, 10))
    assert carried.tags == {"door": 12}
    assert sorted(carried.code.blocks) == ["dances", "turns"]
    assert list(carried.code.libraries) == ["moves"]


def test_a_project_that_needs_nothing_is_saved_as_before():
    project = Project("square", "main:\n    function.stop_bot()\nend\n", world="line")
    data = encode_whole(project)
    assert data == encode(project)
    assert json.loads(data)["learnblock"] == 1


def test_a_file_that_carries_something_needs_a_newer_version(file):
    assert json.loads(file)["learnblock"] == 2


def test_elsewhere_the_world_is_there_at_once_with_its_picture(file, go):
    go()
    found = unpacked(decode(file, "dance"))
    assert found.project.world == "mat"
    assert worlds.find("mat") == PackedWorld("mat", MAT, png(20, 10))
    assert codes(found.notes) == ["project-world-added", "project-tags-added"]
    assert found.remarks == ()


def test_elsewhere_the_tag_names_are_there_at_once(file, go):
    go()
    tag_names.save_names({"ball": 3})
    found = unpacked(decode(file, "dance"))
    assert tag_names.tag_names() == {"ball": 3, "door": 12}
    assert found.project.tags == {}


def test_a_server_that_only_reads_adds_nothing_and_uses_the_tag_names(file, go):
    go()
    project = only_read(decode(file, "dance")).project
    assert (project.world, project.tags) == ("mat", {"door": 12})
    assert not home().exists()


def test_elsewhere_code_is_offered_and_nothing_is_installed(file, go):
    go()
    found = unpacked(decode(file, "dance")).project.carried
    assert sorted(found.offered.blocks) == ["dances", "turns"]
    assert list(found.offered.libraries) == ["moves"]
    assert custom_blocks.load_all() == ()
    assert libraries.shelved() == ()


def test_accepted_code_is_installed_as_it_was(file, go):
    before = {one.name: one.source for one in custom_blocks.load_all()}
    library = libraries.installed("moves").files
    go()
    project = unpacked(decode(file, "dance")).project
    unpacking.install(project.carried.offered)
    assert {one.name: one.source for one in custom_blocks.load_all()}.items() <= before.items()
    assert libraries.installed("moves").files == library
    assert not unpacked(decode(file, "dance")).project.carried.offered


def test_code_that_is_not_accepted_stays_in_the_file(file, go):
    offered = decode(file, "dance").carried.code
    go()
    project = unpacked(decode(file, "dance")).project
    again = decode(encode_whole(project), "dance")
    assert again.carried.offered == offered
    assert unpacked(again).project.carried.offered == offered


def test_another_world_of_the_same_name_stays_as_it_is():
    worlds.install(PackedWorld("room", ROOM))
    project = Project("p", world="room")
    coming = replace(project, carried=carrying_world(OTHER_ROOM))
    for _ in range(2):
        found = unpacked(coming)
        assert found.project.world == "room-2"
        assert codes(found.remarks) == ["project-world-renamed"]
    assert find_world("room").wall[0].points[1] == (500, 0)
    assert find_world("room-2").wall[0].points[1] == (400, 0)
    assert worlds.own_names() == ("room", "room-2")


def test_the_same_world_needs_nothing():
    worlds.install(PackedWorld("room", ROOM))
    found = unpacked(Project("p", world="room", carried=carrying_world(ROOM)))
    assert (found.project.world, found.remarks, found.notes) == ("room", (), ())


def test_at_home_the_users_world_is_newer_than_the_copy():
    worlds.install(PackedWorld("room", ROOM))
    found = unpacked(Project("p", world="room", carried=carrying_world(OTHER_ROOM, home_id())))
    assert found.project.world == "room"
    assert find_world("room").wall[0].points[1] == (500, 0)


def test_at_home_a_deleted_world_comes_back_from_the_copy():
    found = unpacked(Project("p", world="room", carried=carrying_world(ROOM, home_id())))
    assert codes(found.notes) == ["project-world-added"]
    assert worlds.own_names() == ("room",)


@pytest.mark.parametrize(
    "world",
    [
        CarriedWorld("room", ["wall = 3"]),
        CarriedWorld("room", MAT.split("\n")),
        CarriedWorld("room", MAT.replace("mat.png", "../mat.png").split("\n"), png(4, 4)),
    ],
)
def test_a_damaged_world_is_reported_and_nothing_is_written(world, tmp_path):
    found = unpacked(Project("p", world="room", carried=Carried(world=world)))
    assert codes(found.remarks) == ["project-world-damaged"]
    assert list(tmp_path.rglob("*.toml")) == list(tmp_path.rglob("*.png")) == []


def test_a_world_can_not_lead_outside_its_folder(tmp_path):
    carried = Carried(world=CarriedWorld("../room", ROOM.split("\n")))
    found = unpacked(Project("p", world="../room", carried=carried))
    assert codes(found.remarks) == ["project-world-damaged"]
    assert list(tmp_path.rglob("*.toml")) == []


def test_other_numbers_of_tags_are_used_in_this_project_only(file, go):
    go()
    tag_names.save_names({"door": 7})
    found = unpacked(decode(file, "dance"))
    assert found.project.tags == {"door": 12}
    assert tag_names.tag_names() == {"door": 7}
    assert codes(found.remarks) == ["project-tag-differs"]
    again = unpacked(decode(encode_whole(found.project), "dance"))
    assert again.project.tags == {"door": 12}


def test_at_home_the_users_tag_names_are_newer_than_the_copies(file):
    tag_names.save_names({"door": 7})
    found = unpacked(decode(file, "dance"))
    assert (found.project.tags, found.remarks) == ({}, ())


def test_at_home_changed_code_is_newer_than_the_copies(file):
    custom_blocks.save("dances", homes.WALTZ + "    robot.stop_bot()\n", replaces="dances")
    assert not unpacked(decode(file, "dance")).project.carried.offered


def test_elsewhere_different_code_is_offered_and_what_it_replaces_is_in_the_trash(file, go):
    go()
    custom_blocks.save("dances", homes.WALTZ + "    robot.stop_bot()\n")
    homes.install_library("0.9.0", homes.STEPS.replace("print(1)", "print(2)"))
    offered = unpacked(decode(file, "dance")).project.carried.offered
    unpacking.install(offered)
    assert custom_blocks.find("dances").source == homes.WALTZ
    assert libraries.installed("moves").manifest.version == "1.0.0"
    trash = home() / "libraries" / ".trash" / "moves" / "library.toml"
    assert "0.9.0" in trash.read_text()
    assert "stop_bot" in (home() / "skills" / "deleted" / "dances.py").read_text()


def test_a_block_that_can_not_be_installed_replaces_nothing(file, go):
    go()
    custom_blocks.save("dances", homes.WALTZ + "    robot.stop_bot()\n")
    block = json.loads(custom_blocks.export("dances")[1])
    broken = {**block, "source": ["def stop_bot(robot): pass"]}
    with pytest.raises(Exception, match="stop_bot"):
        unpacking.install(Code(blocks={"dances": broken}))
    assert "stop_bot()" in custom_blocks.find("dances").source


def test_a_downloaded_file_is_foreign_everywhere(file):
    _, text = export(PROJECT, "learnblock")
    carried = decode(text.encode(), "dance").carried
    assert carried.home == ""
    assert carried.code.blocks


def test_a_project_too_large_to_carry_its_world_is_saved_all_the_same():
    worlds.install(PackedWorld("mat", MAT, png(20, 10) + bytes(LARGEST)))
    tag_names.save_names({"door": 12})
    project = replace(PROJECT, libraries={})
    found = decode(encode_whole(project), "dance")
    assert found.blocktext == PROJECT.blocktext
    assert found.carried.world is None
    assert found.carried.tags == {"door": 12}
    assert not fits(project)


def test_what_can_not_be_read_does_not_prevent_a_save(file):
    (home() / "worlds" / "mat.toml").write_text("wall = 3")
    (home() / "tags.toml").write_text("[")
    (home() / "libraries" / "moves" / "library.toml").write_text("[")
    carried = packed(PROJECT, "").carried
    assert (carried.world, carried.tags, carried.code.libraries) == (None, {}, {})


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"wrld": 1}, "wrld"),
        ({"world": {"name": "a"}}, "file"),
        ({"world": {"name": "a", "file": [], "picture": "no base 64"}}, "carried"),
        ({"tags": {"door": 587}}, "carried"),
        ({"tags": {"door": "12"}}, "carried"),
        ({"code": {"block": {}}}, "block"),
        ({"code": {"libraries": {"../x": {}}}}, "carried"),
        ({"code": {"blocks": {str(i): {} for i in range(101)}}}, "carried"),
        ([], "carried"),
    ],
)
def test_a_wrong_part_is_refused_with_its_place(wrong, message):
    data = json.dumps({"learnblock": 2, "blocktext": [], "carried": wrong}).encode()
    with pytest.raises(ProjectError, match=message):
        decode(data, "p")


def test_deeply_nested_code_is_refused():
    deep = '{"a":' * 100_000 + "1" + "}" * 100_000
    data = '{"learnblock": 2, "blocktext": [], "carried": {"code": {"blocks": {"a": ' + deep
    with pytest.raises(ProjectError):
        decode((data + "}}}}").encode(), "p")


names = st.text(st.characters(exclude_categories=["Cs"]), min_size=1, max_size=20)
lines = st.lists(st.text(st.characters(exclude_categories=["Cs"]), max_size=20), max_size=3)
values = st.recursive(st.none() | st.integers(0, 9) | names, lambda one: st.lists(one, max_size=2))
code = st.builds(
    Code,
    blocks=st.dictionaries(names, st.dictionaries(names, values, max_size=2), max_size=2),
    libraries=st.dictionaries(
        st.sampled_from(["moves", "b2"]), st.dictionaries(names, lines, max_size=2)
    ),
)
things = st.builds(
    Carried,
    home=st.text("0123456789abcdef", max_size=32),
    world=st.none() | st.builds(CarriedWorld, names, lines, st.none() | st.binary(max_size=20)),
    tags=st.dictionaries(names, st.integers(0, 586), max_size=3),
    code=code,
    offered=code,
)


@settings(max_examples=50)
@given(things.filter(bool), st.dictionaries(names, st.integers(0, 586), max_size=3))
def test_what_a_project_carries_comes_back_from_its_file(carried, tags):
    project = Project("p", carried=carried, tags=tags)
    assert decode(encode(project), "p") == project


@settings(max_examples=20)
@given(things)
def test_any_carried_things_are_unpacked_without_an_error_or_code(carried):
    world = carried.world.name if carried.world else "room"
    unpacked(Project("p", world=world, carried=carried))
    assert custom_blocks.load_all() == ()
    assert libraries.shelved() == ()


def carrying_world(text, home=""):
    return Carried(home=home, world=CarriedWorld("room", text.split("\n")))
