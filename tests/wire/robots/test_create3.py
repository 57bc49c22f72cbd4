"""Create 3 over Bluetooth: its packets move a twin, and so does iRobot's own program."""

import pytest

from emulated import unproven
from irobot_sdk import packets_of, run_sdk
from irobots import emulated, relayed
from learnblock.devices import Base, Bumper, DistanceSensors, GroundSensors, RGBLed, Speaker
from learnblock.errors import RobotConnectionError
from learnblock.i18n import Phrase
from learnblock.robots import connect
from learnblock.robots.irobot import messages
from learnblock.robots.irobot.packets import Packet
from learnblock.testing import check_robot
from twins import let_pass, pose, stands_after, x_of
from twins_time import follow
from waiting import wait_for

#: How much faster than real time a quick world runs.
SPEED = 3


def create3(settings):
    return connect("create3", **settings)


def test_a_create3_conforms(monkeypatch):
    with relayed("create3", speed=SPEED) as (emulation, relay, settings):
        follow(emulation.twin, monkeypatch)
        certificate = check_robot(lambda: create3(settings), relay=relay)
    assert unproven(certificate) == [
        "its accelerometer shows 1 g upwards at rest",
        "its gyroscope reads 0 after a reset",
        "its joints move to the commanded angle",
    ]


def test_it_knows_where_its_wheels_have_brought_it():
    with emulated("create3") as emulation, create3(emulation.settings) as robot:
        base = robot.device(Base)
        base.move(150, -40)
        let_pass(emulation.twin, 1.5)
        base.stop()
        stands_after(emulation.twin)
        x, y, heading = pose(emulation.twin)
        wait_for(lambda: base.pose() == pytest.approx((x, y, heading), abs=4), "its pose")


def test_it_sees_a_wall_before_it_touches_it():
    with (
        emulated("create3", "bumper", speed=SPEED) as emulation,
        create3(emulation.settings) as robot,
    ):
        assert robot.device(DistanceSensors).read()["front"] == [2000.0] * 3
        assert robot.device(Bumper).read() is False
        robot.device(Base).move(100, 0)
        wait_for(lambda: min(robot.device(DistanceSensors).read()["front"]) < 150, "the wall")
        robot.device(Base).stop()
        stands_after(emulation.twin)
        with emulation.twin.body() as body:
            seen = body.distances()["front"]
        read = robot.device(DistanceSensors).read()["front"]
        assert read == pytest.approx(seen, rel=0.15)
        robot.device(Base).move(100, 0)
        wait_for(lambda: robot.device(Bumper).read(), "the touch")


def test_at_an_edge_it_stops_by_itself():
    with (
        emulated("create3", "edge", speed=SPEED) as emulation,
        create3(emulation.settings) as robot,
    ):
        assert set(robot.device(GroundSensors).read().values()) == {100.0, None}
        robot.device(Base).move(150, 0)
        wait_for(lambda: 0.0 in robot.device(GroundSensors).read().values(), "the edge")
        assert stands_after(emulation.twin) < 0.8


def test_it_lights_up_and_sounds():
    with emulated("create3") as emulation, create3(emulation.settings) as robot:
        robot.device(RGBLed, "Up").set_color(0, 128, 255)
        assert robot.device(Speaker).tone(880, 100)
        with emulation.twin.body() as body:
            assert body.leds["Up"] == (0, 128, 255)
            assert [entry.values for entry in body.log] == [(880, 100)]


def test_a_root_is_told_apart():
    with emulated("root") as emulation:
        with pytest.raises(RobotConnectionError) as refusal:
            create3(emulation.settings)
        place = emulation.settings["address"]
        assert refusal.value.phrase == Phrase("irobot-is-root", place=place)


# iRobot's own program.


def test_our_packets_are_those_of_irobots_own_program():
    ours = {
        "set_wheel_speeds(30.6, -12.3)": messages.drive(306, -123),
        "get_7x_ir_proximity()": messages.PROXIMITY,
        "get_position()": messages.POSITION,
        "reset_navigation()": messages.RESET_POSITION,
        "stop()": messages.STOP,
    }
    theirs = packets_of("Create3", ours)
    encoded = [
        Packet(*message[:2], number, message.payload).encoded
        for number, message in enumerate(ours.values())
    ]
    assert dict(zip(ours, theirs, strict=True)) == dict(zip(ours, encoded, strict=True))


def test_irobots_own_program_drives_the_emulated_create3():
    with emulated("create3", "bumper") as emulation:
        begun = x_of(emulation.twin)
        said = run_sdk("Create3", emulation.settings["address"], SDK_PROGRAM)
        x, _, heading = pose(emulation.twin)
        with emulation.twin.body() as body:
            seen = body.distances()
    assert x - begun == pytest.approx(200, abs=8)
    assert heading == pytest.approx(-90, abs=3)
    # Its own axes: to the right, ahead, and from 90 degrees anticlockwise.
    assert said["position"] == pytest.approx([0, 20, 180], abs=3)
    levels = [
        messages.intensity(distance) for distance in (*seen["left"], *seen["front"], *seen["right"])
    ]
    assert said["proximity"] == pytest.approx(levels, abs=40)
    assert said["version"] == "2.6.0"


SDK_PROGRAM = """
await robot.move(20)
await robot.turn_left(90)
there = await robot.get_position()
said["position"] = [there.x, there.y, there.heading]
said["proximity"] = (await robot.get_7x_ir_proximity()).sensors
said["version"] = await robot.get_version_string()
"""
