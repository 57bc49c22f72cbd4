"""`learnblock new` on the command line."""

import pytest
from click.testing import CliRunner

from learnblock.cli import main
from learnblock.robots.simulated import find_world
from new_robots import guide


def new(*arguments):
    return CliRunner().invoke(main, ["new", *map(str, arguments)])


@pytest.fixture
def description(tmp_path):
    (tmp_path / "pathfinder.toml").write_text(guide())
    return tmp_path / "pathfinder.toml"


def test_a_robot_is_created_and_the_next_steps_are_shown(own_home, description):
    result = new("robot", "--from", description)
    assert result.exit_code == 0
    for file in ("robots/pathfinder.py", "robots/sim_pathfinder.py", "tests/test_pathfinder.py"):
        assert f"Wrote {own_home / file}\n" in result.output
        assert (own_home / file).is_file()
    assert "learnblock run PROGRAM --robot sim-pathfinder\n" in result.output
    assert f"pytest -rs {own_home / 'tests' / 'test_pathfinder.py'}" in result.output


def test_a_robot_gets_the_name_from_the_option_the_description_or_its_file(own_home, description):
    assert "sim-rover\n" in new("robot", "rover", "--from", description).output
    description.write_text(f'name = "walker"\n{guide()}')
    assert "sim-walker\n" in new("robot", "--from", description).output


def test_a_package_is_written_into_its_folder(tmp_path, description):
    result = new("robot", "--from", description, "--folder", tmp_path / "mine")
    assert f"pip install -e '{tmp_path / 'mine'}[test]'" in result.output
    assert (tmp_path / "mine" / "src" / "learnblock_pathfinder" / "pathfinder.toml").is_file()


def test_nothing_is_replaced_without_force(own_home, description):
    new("robot", "--from", description)
    (own_home / "robots" / "pathfinder.py").write_text("mine")
    refused = new("robot", "--from", description)
    assert refused.exit_code == 2
    assert "These files already exist" in refused.output
    assert (own_home / "robots" / "pathfinder.py").read_text() == "mine"
    assert new("robot", "--from", description, "--force").exit_code == 0
    assert (own_home / "robots" / "pathfinder.py").read_text() != "mine"


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("robot", "../up"), "A robot cannot be named '../up'"),
        (("robot", "ebo"), "There is already a robot 'ebo'"),
        (("skill", "../up"), "A skill cannot be named '../up'"),
        (("skill", "move_straight"), "Every robot already has a 'move_straight'"),
        (("world", "../up"), "A world cannot be called '../up'"),
        (("world", "line"), "There is already a world 'line'"),
    ],
)
def test_an_invalid_name_is_refused_with_a_message(own_home, arguments, message):
    result = new(*arguments)
    assert result.exit_code in {1, 2}
    assert message in result.output
    assert "Traceback" not in result.output
    assert list(own_home.iterdir()) == []


def test_a_mistake_in_a_description_is_reported_with_its_line(own_home, description):
    description.write_text(guide().replace("radius = 33", "radius = 0"))
    result = new("robot", "--from", description)
    assert result.exit_code == 1
    assert (
        "pathfinder.toml:17:1: wrong-value 'wheels.radius' is 0, but must be a number"
        in result.output
    )
    assert "    radius = 0\n    ^" in result.output


def test_a_skill_is_a_block_at_once(own_home):
    from learnblock.blocks.known import all_configurations

    assert new("skill", "sway_twice").exit_code == 0
    block = all_configurations()["sway_twice"]
    assert [parameter.name for parameter in block.parameters] == ["times", "speed"]
    assert block.tooltip["EN"] == "Sway to the right and to the left."


def test_a_robot_can_drive_in_the_world_at_once(own_home):
    result = new("world", "my garden")
    assert "learnblock run PROGRAM --world 'my garden'" in result.output
    world = find_world("my garden")
    assert world.title == "My garden"
    assert [goal.name for goal in world.goal.follow] == ["follow the path"]


def test_a_world_in_another_folder_is_named_by_its_file(tmp_path):
    result = new("world", "garden", "--folder", tmp_path)
    assert f"--world {tmp_path / 'worlds' / 'garden.toml'}" in result.output


def test_a_world_from_a_template_is_the_same_for_the_same_seed(own_home):
    for name in ("one", "two"):
        result = new("world", name, "--template", "maze", "--size", 4, "--seed", 9)
        assert result.exit_code == 0
    assert find_world("one").wall == find_world("two").wall
    assert find_world("one").title == "One"
    assert find_world("one").theme == "maze"


def test_sizes_of_templates_are_limited(own_home):
    refused = new("world", "one", "--template", "field", "--size", 40)
    assert refused.exit_code == 2
    assert "3<=x<=8" in refused.output
