from pathlib import Path

import pytest

from learnblock.simulator import load_robot, load_world, robot_names

DEVICES = {
    "ebo": {
        "Base:ROBOT",
        "Camera:ROBOT",
        "Display:ROBOT",
        "DistanceSensors:ROBOT",
        "JointMotor:CAMERA",
    },
    "thymio": {
        "Accelerometer:ROBOT",
        "Base:ROBOT",
        "Display:ROBOT",
        "DistanceSensors:ROBOT",
        "GroundSensors:ROBOT",
        "RGBLed:Left",
        "RGBLed:Right",
        "RGBLed:Up",
        "Speaker:ROBOT",
    },
    "ev3": {
        "Base:ROBOT",
        "Bumper:ROBOT",
        "DistanceSensors:ROBOT",
        "GroundSensors:ROBOT",
        "Gyroscope:Z_AXIS",
        "Speaker:ROBOT",
    },
    "cozmo": {
        "Accelerometer:ROBOT",
        "Animator:ROBOT",
        "Base:ROBOT",
        "Camera:ROBOT",
        "Display:ROBOT",
        "GroundSensors:ROBOT",
        "Gyroscope:Z_AXIS",
        "JointMotor:ARM",
        "JointMotor:CAMERA",
        "RGBLed:Center",
        "RGBLed:Front",
        "RGBLed:Left",
        "RGBLed:Rear",
        "RGBLed:Right",
        "Speaker:ROBOT",
    },
    "legoed": {
        "Base:ROBOT",
        "GroundSensors:ROBOT",
        "Gyroscope:Z_AXIS",
        "JointMotor:ARM",
        "RGBLed:Status",
        "Speaker:ROBOT",
    },
    "create3": {
        "Base:ROBOT",
        "Bumper:ROBOT",
        "DistanceSensors:ROBOT",
        "GroundSensors:ROBOT",
        "RGBLed:Up",
        "Speaker:ROBOT",
    },
    "root": {
        "Base:ROBOT",
        "Bumper:ROBOT",
        "GroundSensors:ROBOT",
        "LightSensor:ROBOT",
        "RGBLed:Up",
        "Speaker:ROBOT",
    },
    "spike": {
        "Base:ROBOT",
        "Bumper:ROBOT",
        "DistanceSensors:ROBOT",
        "GroundSensors:ROBOT",
        "Gyroscope:Z_AXIS",
        "RGBLed:Status",
        "Speaker:ROBOT",
    },
}


def test_our_robots_are_built_in() -> None:
    assert set(robot_names()) == set(DEVICES)


@pytest.mark.parametrize("name", sorted(DEVICES))
def test_a_robot_has_the_devices_of_the_real_one(name: str) -> None:
    assert set(load_robot(name).devices()) == DEVICES[name]


@pytest.mark.parametrize("name", sorted(DEVICES))
def test_the_default_world_of_a_robot_exists(name: str) -> None:
    assert load_world(load_robot(name).world).title


def test_ebo_groups_its_five_readings_as_the_real_one() -> None:
    sensors = load_robot("ebo").distance

    assert [90 + sensor.direction for sensor in sensors] == [40, 80, 103, 123, 161]
    assert ["left" in sensor.sides for sensor in sensors] == [True, True, False, False, False]
    assert ["front" in sensor.sides for sensor in sensors] == [False, True, True, True, False]
    assert ["right" in sensor.sides for sensor in sensors] == [False, False, False, True, True]


def test_a_custom_robot_can_name_every_device(tmp_path: Path) -> None:
    (tmp_path / "mine.toml").write_text(
        """
        outputs = ["MP3"]
        [body]
        shape = "disc"
        radius = 50
        height = 60
        mass = 0.5
        [wheels]
        radius = 20
        track = 90
        maximum_speed = 200
        [light]
        [[led]]
        slot = "nose"
        kind = "single"
        """
    )
    robot = load_robot("mine", [tmp_path])

    assert robot.name == "mine"
    assert set(robot.devices()) == {
        "Base:ROBOT",
        "LightSensor:ROBOT",
        "Led:nose",
        "MP3:ROBOT",
    }
