"""The table of senses."""

import pytest

from learnblock import robots
from learnblock.client.senses import Senses
from learnblock.devices import DEVICE_TYPES
from learnblock.perception.settings import TABLE
from learnblock.senses import (
    ABILITIES,
    DECORATIONS,
    METHODS,
    SENSES,
    STAND_INS,
    UNSERVED,
    equipment,
    is_decoration,
    sense_of,
    served_by,
)


def test_the_table_names_devices_and_abilities_that_exist():
    for ways in SENSES.values():
        for way in ways:
            kind, _, key = way.partition(":")
            assert kind in DEVICE_TYPES
            assert kind not in ABILITIES or not key or key in ABILITIES[kind]
    assert {one.partition(":")[0] for one in DECORATIONS} | set(ABILITIES) <= set(DEVICE_TYPES)


def test_every_method_of_senses_asks_for_a_sense():
    methods = {name for name in vars(Senses) if not name.startswith("_")}
    assert set(METHODS) == methods
    # Those with a place for an argument ask for one of several.
    for method, sense in METHODS.items():
        assert sense_of(method) is None if "{}" in sense else sense_of(method) in SENSES


def test_a_robot_has_its_devices_their_types_and_what_they_can_do():
    found = equipment(["Base:ROBOT", "Speaker:ROBOT"], frozenset({"Speaker:say"}))
    assert found == {"Base:ROBOT", "Speaker:ROBOT", "Base", "Speaker", "Speaker:say"}


def test_a_robot_that_lists_no_abilities_has_all_of_its_devices():
    found = equipment(["DistanceSensors:ROBOT"], None)
    assert {"DistanceSensors:front", "DistanceSensors:back"} < found
    assert "Speaker:say" not in found


def test_an_ability_of_a_missing_device_does_not_count():
    assert equipment(["Base:ROBOT"], frozenset({"Speaker:say"})) == {"Base:ROBOT", "Base"}


@pytest.mark.parametrize(
    ("robot", "sense", "way"),
    [
        ("sim-ebo", "heading", "Base"),
        ("sim-ev3", "heading", "Gyroscope:Z_AXIS"),
        ("sim-ebo", "black-line", "Camera"),
        ("sim-thymio", "black-line", "GroundSensors:line"),
        # Its only ground sensor detects cliffs.
        ("sim-cozmo", "ground-line", "Camera"),
        ("sim-thymio", "red-line", None),
        ("sim-ev3", "obstacle-front", "DistanceSensors:front"),
        ("sim-ev3", "obstacle-left", None),
        ("sim-ebo", "obstacle-back", None),
        ("sim-cozmo", "brightness", "Camera"),
        ("sim-thymio", "Speaker:say", None),
    ],
)
def test_the_best_device_of_a_robot_serves_a_sense(robot, sense, way):
    assert served_by(sense, robots.find(robot).load().known_equipment()) == way


def test_a_bumper_serves_for_obstacles_where_there_is_no_distance_sensor():
    assert served_by("obstacle-front", equipment(["Bumper:ROBOT"], None)) == "Bumper"


@pytest.mark.parametrize("twin", ["ebo", "thymio", "ev3", "cozmo"])
def test_a_twin_has_the_equipment_of_its_robot(twin):
    kinds = {"Controller:ROBOT", "Controller"}  # which the simulator does not have
    real = robots.find(twin).load().known_equipment() - kinds
    # Every robot has them in a world.
    world = {"Pen:ROBOT", "Pen", "Screen:ROBOT", "Screen"}
    # Its camera sees only drawn faces.
    have = robots.find(f"sim-{twin}").load().known_equipment() - {"Camera:emotions"}
    assert have == real | world


def test_emotions_are_seen_on_real_cameras_only_if_an_adult_has_allowed_it():
    def can_tell(robot):
        return "Camera:emotions" in robots.find(robot).load().known_equipment()

    assert can_tell("sim-cozmo")
    assert not can_tell("cozmo")
    TABLE.change("emotions_on_cameras", "true")
    assert can_tell("cozmo")
    assert not can_tell("thymio")


@pytest.mark.parametrize(
    ("need", "decorates"),
    [
        ("Speaker:say", True),
        ("JointMotor:CAMERA", True),
        ("JointMotor:ARM", False),
        ("Base", False),
    ],
)
def test_faces_sounds_lights_and_the_camera_s_tilt_decorate(need, decorates):
    assert is_decoration(need) is decorates


def test_the_devices_that_no_robot_has_are_known():
    entries = robots.entries().values()
    devices = {name for entry in entries for name in entry.load().device_names() or ()}
    served = {name.partition(":")[0] for name in devices}
    served |= {kind for kind, stand_in in STAND_INS.items() if stand_in in served}
    assert set(DEVICE_TYPES) - served == UNSERVED


def test_a_coloured_led_serves_as_a_plain_one():
    found = equipment(["RGBLed:Left"], None)
    assert [served_by(need, found) for need in ("Led", "Led:Left", "Led:Right", "RGBLed")] == [
        "RGBLed",
        "RGBLed:Left",
        None,
        "RGBLed",
    ]


def test_a_sense_that_only_decorations_serve_is_a_decoration():
    assert is_decoration("text-display")
    assert not is_decoration("brightness")
