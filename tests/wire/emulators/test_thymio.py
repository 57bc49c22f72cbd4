"""Our worlds as scenes of Aseba's playground."""

import math
import re
from xml.etree import ElementTree as Xml

import pytest

from learnblock.devices import GroundSensors
from learnblock.emulators import emulate, thymio
from learnblock.emulators.playground import GROUND, place, pose, write_scene
from learnblock.errors import MissingPackageError, UnknownNameError
from learnblock.robots import connect
from learnblock.robots.settings import describe
from learnblock.robots.thymio import Robot, ThymioSettings
from learnblock.simulator import load_world
from learnblock.simulator.geometry import Pose
from places import ROOT
from playground import missing

WORLD = """
floor = { size = [1000, 600] }
wall = [{ points = [[0, 0], [0, 100], [50, 100]], thickness = 10 }]
box = [{ x = 100, y = 50, heading = 90, length = 60, width = 40, mass = 0.5 }]
cylinder = [{ x = -100, y = -50, radius = 30 }]
"""


@pytest.fixture
def world(tmp_path):
    file = tmp_path / "world.toml"
    file.write_text(WORLD)
    return load_world(file)


@pytest.fixture
def scene(world, tmp_path):
    file = write_scene(world, tmp_path, 4321, Pose(100, -50, 90))
    return Xml.parse(file).getroot()  # noqa: S314 - our own


def numbers(element, *names):
    return pytest.approx([float(element.get(name)) for name in names])


def test_a_pose_survives_conversion_and_back(world):
    there = Pose(-120.0, 30.0, 75.0)
    back = pose(world, *place(world, there))
    assert (back.x, back.y, back.heading) == pytest.approx((there.x, there.y, there.heading))


def test_positions_are_in_cm_from_the_corner_and_angles_anticlockwise(scene):
    robot = scene.find("robot")
    assert [60, 25, -math.pi / 2] == numbers(robot, "x", "y", "angle")
    assert (robot.get("type"), robot.get("port")) == ("thymio2", "4321")


def test_the_floor_is_a_picture_with_the_shape_of_the_world(scene, tmp_path):
    floor = scene.find("world")
    assert [100, 60] == numbers(floor, "w", "h")
    assert floor.get("groundTexture") == GROUND
    assert (tmp_path / GROUND).read_bytes().startswith(b"\x89PNG")


def test_each_straight_piece_of_a_wall_is_a_box_with_its_corners(scene):
    first, second, _ = scene.findall("wall")
    assert [50, 35, math.pi / 2, 11, 1] == numbers(first, "x", "y", "angle", "l1", "l2")
    assert [52.5, 40, 0, 6, 1] == numbers(second, "x", "y", "angle", "l1", "l2")
    assert first.get("mass") == "-1"


def test_a_box_with_a_mass_can_be_pushed(scene):
    *_, box = scene.findall("wall")
    assert [60, 35, -math.pi / 2, 6, 4, 500] == numbers(box, "x", "y", "angle", "l1", "l2", "mass")


def test_a_cylinder_without_mass_is_fixed(scene):
    (cylinder,) = scene.findall("cylinder")
    assert [40, 25, 3, -1] == numbers(cylinder, "x", "y", "r", "mass")


def test_every_used_colour_is_defined(scene):
    known = {colour.get("name") for colour in scene.findall("color")}
    used = {element.get("color") for element in scene if element.get("color")}
    assert used <= known


def test_without_the_playground_the_error_explains_how_to_install_it(monkeypatch):
    monkeypatch.setattr(thymio.shutil, "which", lambda name: None)
    with pytest.raises(MissingPackageError, match="apt-get install aseba"):
        emulate("thymio")


def test_a_missing_world_is_rejected(monkeypatch):
    monkeypatch.setattr(thymio.shutil, "which", lambda name: "/bin/false")
    with pytest.raises(UnknownNameError, match="world"):
        emulate("thymio", "nowhere")


def test_a_playground_that_ends_at_once_is_reported(monkeypatch):
    monkeypatch.setattr(thymio.shutil, "which", lambda name: "/bin/false")
    with pytest.raises(OSError, match="ended immediately"):
        emulate("thymio", "empty")


@pytest.mark.skipif(bool(missing()), reason=missing())
def test_a_program_can_connect_to_an_emulated_thymio(monkeypatch):
    monkeypatch.setenv("QT_QPA_PLATFORM", "offscreen")
    with emulate("thymio") as emulation:
        assert emulation.twin is None
        with connect("thymio", **emulation.settings) as robot:
            reading = robot.device(GroundSensors).read()
    # It is on the black line of the twin's default world.
    assert max(reading["left"], reading["right"]) < 50


@pytest.mark.skipif(bool(missing()), reason=missing())
def test_the_example_of_its_page_runs(monkeypatch):
    monkeypatch.setenv("QT_QPA_PLATFORM", "offscreen")
    page = (ROOT / "docs" / "robots" / "thymio.md").read_text("utf-8")
    (example,) = re.findall(r"```python\n(.*?)```", page, re.DOTALL)
    exec(compile(example, "thymio.md", "exec"), {})  # noqa: S102 - our own page


def test_its_page_has_every_setting_with_its_default_and_every_device():
    page = (ROOT / "docs" / "robots" / "thymio.md").read_text("utf-8")
    rows = dict(re.findall(r"^\| `(\w+)` \| (?:`(.*?)`)? ?\|", page, re.MULTILINE))
    assert rows == {one.name: str(one.default) for one in describe("thymio", ThymioSettings)}
    named = set(re.findall(r"^\| `(\w+):", page, re.MULTILINE))
    assert named == {name.partition(":")[0] for name in Robot.device_names()}
