"""What the gallery says about a world follows from what is in it."""

import pytest

from learnblock.errors import WorldError
from learnblock.simulator import load_world, world_names
from learnblock.simulator.world_guide import group_of, needs_of, robots_for

LINE = "[[line]]\npoints = [[0, 0], [500, 0]]\n"
WORLDS = {
    "empty": "",
    "drive": "[[goal.stop]]\nx = 300\ny = 0\n",
    "obstacles": "[[box]]\nx = 300\ny = 0\n[[goal.reach]]\nx = 600\ny = 0\n",
    "lines": LINE + "[[goal.follow]]\n",
    "tags": "[[tag]]\nid = 3\nx = 500\ny = 0\nheading = 180\n[[goal.show]]\nemotion = 'joy'\n",
    "faces": "[[face]]\nemotion = 'joy'\nx = 500\ny = 0\nheading = 180\n",
    "several": "[[start]]\nname = 'a'\nx = 0\ny = 0\n[[start]]\nname = 'b'\nx = 0\ny = 400\n"
    "[[goal.reach]]\nx = 300\ny = 0\ntogether = true\n",
}


@pytest.fixture
def world(tmp_path):
    def make(text):
        file = tmp_path / "made.toml"
        file.write_text(text, encoding="utf-8")
        return load_world(file)

    return make


@pytest.mark.parametrize("group", WORLDS)
def test_a_world_is_in_the_group_of_what_is_in_it(world, group):
    assert group_of(world(WORLDS[group])) == group


def test_a_world_that_only_asks_for_feelings_is_beside_the_faces(world):
    assert group_of(world("[[goal.show]]\nemotion = 'joy'\n")) == "faces"


def test_its_file_may_choose_another_group_that_fits(world):
    assert group_of(world("group = 'games'\n" + WORLDS["several"])) == "games"


@pytest.mark.parametrize(
    "group", ["games", "drive", "obstacles", "lines", "tags", "faces", "several"]
)
def test_a_group_that_promises_what_is_missing_is_refused(world, group):
    with pytest.raises(WorldError, match="group"):
        world(f"group = '{group}'\n")


def test_unknown_groups_and_difficulties_are_refused(world):
    with pytest.raises(WorldError, match="group"):
        world("group = 'puzzles'\n")
    with pytest.raises(WorldError, match="difficulty"):
        world("difficulty = 'hard'\n")


@pytest.mark.parametrize(
    ("text", "needs"),
    [
        (WORLDS["drive"], ()),
        (WORLDS["lines"], ("black-line",)),
        (LINE + "colour = [215, 25, 25]\n[[goal.follow]]\n", ("red-line",)),
        (WORLDS["tags"], ("Camera", "Display")),
        (WORLDS["faces"], ("Camera", "Camera:emotions")),
    ],
)
def test_what_a_robot_needs_follows_from_goals_tags_and_faces(world, text, needs):
    assert needs_of(world(text)) == needs


def test_a_world_with_a_goal_for_all_is_for_as_many_robots_as_it_has_starts(world):
    assert robots_for(world(WORLDS["several"])) == 2
    assert robots_for(world(WORLDS["drive"])) == 1


def test_each_built_in_world_with_a_goal_says_how_difficult_it_is():
    worlds = [load_world(name) for name in world_names()]
    assert [
        world.name for world in worlds if world.difficulty is None and any(world.goal.all())
    ] == []
