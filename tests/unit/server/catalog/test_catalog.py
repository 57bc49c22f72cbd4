"""The choices that the page offers."""

import subprocess
import sys

from learnblock import robots, running
from learnblock.server.catalog import example, example_choices, welcome
from learnblock.simulator import world_names
from places import ROOT

ASK = """
import sys
from learnblock.server.catalog import welcome

told = {choice.name: choice.simulated for choice in welcome("").robots}
assert told["sim-ebo"] and not told["ebo"], told
print(*(name for name in sys.modules if name.startswith("learnblock.robots.")))
"""


def test_the_list_of_robots_loads_no_driver():
    done = subprocess.run(
        [sys.executable, "-c", ASK], capture_output=True, text=True, check=True
    ).stdout.split()
    assert "learnblock.robots.sim_ebo" in done
    assert {
        "learnblock.robots.ebo",
        "learnblock.robots.cozmo",
        "learnblock.robots.real",
    }.isdisjoint(done)


def test_a_robot_of_ours_is_told_from_a_users(tmp_path, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path))
    (tmp_path / "robots").mkdir()
    (tmp_path / "robots" / "mine.py").write_text("from learnblock.robots.sim_ebo import Robot\n")
    ours = {choice.name: choice.ours for choice in welcome("").robots}
    assert ours.pop("mine") is False
    assert set(ours.values()) == {True}


def test_each_robot_says_what_serves_its_senses():
    serves = {choice.name: choice.serves for choice in welcome("").robots}
    assert serves["sim-thymio"]["black-line"] == "GroundSensors:line"
    assert serves["sim-ebo"]["black-line"] == serves["ebo"]["black-line"] == "Camera"
    assert "red-line" not in serves["sim-thymio"]
    assert serves["coppeliasim"] == {}


def test_each_robot_says_what_blocks_need_and_it_lacks():
    lacks = {choice.name: choice.lacks for choice in welcome("").robots}
    assert "Animator" in lacks["sim-ebo"]
    assert "Animator" not in lacks["sim-cozmo"]
    assert set(lacks["sim-ebo"]) | {"Pen"} == set(lacks["ebo"])


def test_polygons_opens_without_a_warning():
    source = running.read(running.example("polygons.bt"))
    assert running.check(source, robots.find(example("polygons").robot)) == []


PICTURES = ROOT / "frontend/src/features/examples/pictures"
WORLD_PICTURES = ROOT / "frontend/src/features/worlds/pictures"


def test_each_example_has_its_picture_and_no_picture_is_left_over():
    pictures = {path.stem for path in PICTURES.iterdir()}
    assert pictures == {*example_choices()}, "take them anew: scripts/pictures"


def test_each_built_in_world_has_its_picture_and_no_picture_is_left_over():
    pictures = {path.stem for path in WORLD_PICTURES.iterdir()}
    assert pictures == {*world_names()}, "take them: scripts/pictures worlds"


def test_the_pictures_of_examples_are_small():
    sizes = {path.name: path.stat().st_size for path in PICTURES.iterdir()}
    assert {name: size for name, size in sizes.items() if size > 15_000} == {}
    assert sum(sizes.values()) < 500_000


def test_each_first_program_is_on_the_start_page():
    files = {path.stem for path in (ROOT / "examples/first").glob("*.bt")}
    first = [one.name for one in example_choices().values() if one.is_first]
    assert sorted(first) == sorted(f"first-{name}" for name in files)


def test_each_game_is_on_the_page_with_its_own_first_steps():
    files = {path.stem: path.read_text() for path in (ROOT / "examples/games").glob("*.bt")}
    games = [one.name for one in example_choices().values() if one.is_game]
    assert sorted(games) == sorted(f"game-{name}" for name in files)
    assert {name for name, text in files.items() if "\n# Make it yours: " not in text} == set()
