import math
import re
from pathlib import Path

import cv2
import numpy as np
import pytest

from learnblock.errors import WorldError
from learnblock.i18n import Phrase
from learnblock.simulator import load_world, textures, world_names
from learnblock.simulator.description_types import EMOTIONS
from places import ROOT

EXPECTED = {
    "arena",
    "bumper",
    "distance",
    "edge",
    "empty",
    "face-ahead",
    "faces",
    "heading",
    "convoy",
    "football",
    "race",
    "run-away",
    "labyrinth",
    "relay",
    "sumo",
    "swarm",
    "line",
    "line-and-box",
    "lines",
    "obstacles",
    "parking",
    "applause",
    "patrol",
    "people",
    "polygons",
    "flower",
    "red-line",
    "square",
    "stage",
    "table",
    "tag-ahead",
    "tags",
    "walls",
    "maze-clock",
    "landing",
    "drawing",
    "simon",
    "race-track",
    "tag",
    "delivery",
    "penalty",
    "sumo-barrels",
    "stars",
}


def test_all_worlds_of_the_docs_are_built_in() -> None:
    assert set(world_names()) == EXPECTED


@pytest.mark.parametrize("name", sorted(EXPECTED))
def test_every_shipped_world_loads_with_a_title_and_a_start(name: str) -> None:
    world = load_world(name)

    assert world.name == name
    assert world.title
    assert world.start


def test_a_folder_takes_precedence_over_our_worlds(tmp_path: Path) -> None:
    (tmp_path / "empty.toml").write_text('title = "mine"')
    (tmp_path / "garden.toml").write_text("")

    assert load_world("empty", [tmp_path]).title == "mine"
    assert set(world_names([tmp_path])) == EXPECTED | {"garden"}


def test_an_empty_file_is_a_floor_of_two_by_two_metres_with_a_border(tmp_path: Path) -> None:
    (tmp_path / "w.toml").write_text("")

    floor = load_world(tmp_path / "w.toml").floor

    assert floor.size == (2000, 2000)
    assert floor.border == 100


def test_a_world_is_a_playground_unless_it_names_another_theme(tmp_path: Path) -> None:
    (tmp_path / "plain.toml").write_text("")
    (tmp_path / "own.toml").write_text('theme = "space"')

    assert load_world(tmp_path / "plain.toml").theme == "playground"
    assert load_world(tmp_path / "own.toml").theme == "space"


def test_an_unknown_theme_is_refused_with_its_place_and_the_themes_that_exist(
    tmp_path: Path,
) -> None:
    (tmp_path / "w.toml").write_text('title = "x"\ntheme = "jungle"\n')

    with pytest.raises(WorldError, match=r"w\.toml:2:1: .*\"jungle\".* maze, night, playground"):
        load_world(tmp_path / "w.toml")


def test_the_line_bends_gently_and_both_ways() -> None:
    (line,) = load_world("line").line
    turns = [part.turn for part in line.path if part.turn]

    assert min(turns) < 0 < max(turns)
    assert all(part.radius >= 250 for part in line.path if part.radius)
    assert math.isclose(360, sum(turns))
    assert line.closed


@pytest.mark.parametrize("name", ["line", "line-and-box", "red-line"])
def test_a_robot_starts_on_the_line_and_faces_along_it(name: str) -> None:
    world = load_world(name)
    (line,), (start, *_) = world.line, world.start
    middle = line.polyline()
    distance, along = middle.nearest(start.x, start.y)
    ahead = start.x + 20 * math.cos(math.radians(start.heading))

    assert distance == pytest.approx(0, abs=0.01)
    assert middle.nearest(ahead, start.y)[0] == pytest.approx(0, abs=0.01)
    assert middle.nearest(ahead, start.y)[1] > along


def test_a_path_turns_right_for_positive_turns(tmp_path: Path) -> None:
    (tmp_path / "w.toml").write_text(
        "[[line]]\nstart = [0, 0, 0]\npath = [{ forward = 100 }, { turn = 90, radius = 300 }]"
    )
    (line,) = load_world(tmp_path / "w.toml").line

    assert line.polyline().points[-1] == pytest.approx((400, -300))


def test_a_file_is_read_again_when_it_has_changed(tmp_path: Path) -> None:
    file = tmp_path / "w.toml"
    for title in ("before", "after"):
        file.write_text(f'title = "{title}"')
        assert load_world(file).title == title


def test_a_picture_that_has_gone_since_is_missed(tmp_path: Path) -> None:
    file, picture = tmp_path / "w.toml", tmp_path / "floor.png"
    file.write_text('floor.picture = "floor.png"')
    cv2.imwrite(str(picture), np.zeros((8, 8, 3), np.uint8))
    assert load_world(file).floor.picture == "floor.png"
    picture.unlink()
    with pytest.raises(WorldError):
        load_world(file)


def test_lines_that_are_alike_share_what_is_near_and_others_do_not(tmp_path: Path) -> None:
    lines = []
    for name, end in (("first", 500), ("again", 500), ("other", 600)):
        file = tmp_path / f"{name}.toml"
        file.write_text(f"[[line]]\npoints = [[0, 0], [{end}, 0]]")
        lines.extend(line.polyline() for line in load_world(file).line)
    first, again, other = lines
    assert first is again
    assert (first.length, other.length) == (500, 600)


def test_the_emotions_of_posters_are_those_that_can_be_drawn() -> None:
    assert set(textures.EMOTIONS) == set(EMOTIONS)


def test_each_tag_is_near_the_robots_last_stop() -> None:
    world = load_world("tags")
    place = world.start[0].x, world.start[0].y

    assert [tag.id for tag in world.tag] == [1, 2, 5]
    for tag in world.tag:
        x, y = tag.x - place[0], tag.y - place[1]
        assert math.hypot(x, y) < 900
        place = tag.x - 230 * x / math.hypot(x, y), tag.y - 230 * y / math.hypot(x, y)


def test_a_damaged_picture_is_reported_when_it_is_drawn(tmp_path: Path) -> None:
    from learnblock.simulator import World

    header = b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\x08\0\0\0\x08"
    (tmp_path / "map.png").write_bytes(header)
    (tmp_path / "w.toml").write_text('[floor]\npicture = "map.png"')
    world = World(load_world(tmp_path / "w.toml"))

    with pytest.raises(WorldError) as refused:
        world.floor_at(0, 0)
    (problem,) = refused.value.diagnostics
    assert problem.message == Phrase("world-picture-damaged", picture="map.png")


@pytest.mark.parametrize("language", ["en", "es"])
def test_the_page_has_words_for_every_title_and_goal_of_our_worlds(language: str) -> None:
    words = (ROOT / "src" / "learnblock" / "i18n" / language / "page" / "catalog.ftl").read_text(
        "utf-8"
    )
    for world in map(load_world, world_names()):
        for name in (world.title, *(goal.name for _, _, goal in world.goal.all())):
            # As in frontend/src/i18n/index.ts.
            code = "name-" + re.sub(r"[^a-z0-9]+", "-", name.lower())
            code = "goal-tag" if re.fullmatch(r"tag \d+", name) else code
            assert f"page-catalog-{code} =" in words, name
