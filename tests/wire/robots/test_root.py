"""Root over Bluetooth: its packets move a twin, and so does iRobot's own program."""

import math

import pytest

from emulated import LONG, settle, unproven
from irobot_sdk import packets_of, run_sdk
from irobots import emulated, relayed
from learnblock.devices import Base, Bumper, GroundSensors, LightSensor, Pen, RGBLed, Speaker
from learnblock.errors import RobotBusyError, RobotConnectionError
from learnblock.i18n import Phrase
from learnblock.robots import connect
from learnblock.robots.irobot import messages
from learnblock.robots.irobot.packets import Packet
from learnblock.robots.root import Robot
from learnblock.testing import Fault, check_robot
from runs import run_example
from twins import let_pass, pose, stands_after, strokes, x_of
from twins_time import follow
from waiting import wait_for

#: How much faster than real time a quick world runs.
SPEED = 3


def root(settings, **others):
    return connect("root", **{**settings, **others})


def test_a_root_conforms(monkeypatch):
    with relayed("root", speed=SPEED) as (emulation, relay, settings):
        follow(emulation.twin, monkeypatch)
        # Ten times that of a radio; each of some twenty messages waits until it is confirmed.
        relay.delay = 0.15
        certificate = check_robot(lambda: root(settings), relay=relay)
    assert unproven(certificate) == [
        "its accelerometer shows 1 g upwards at rest",
        "its gyroscope reads 0 after a reset",
        "its joints move to the commanded angle",
    ]


def test_it_knows_where_its_wheels_have_brought_it():
    with emulated("root") as emulation, root(emulation.settings) as robot:
        base = robot.device(Base)
        base.move(60, 40)
        let_pass(emulation.twin, 1.5)
        base.stop()
        stands_after(emulation.twin)
        x, y, heading = pose(emulation.twin)
        wait_for(lambda: base.pose() == pytest.approx((x, y, heading), abs=3), "its pose")


def test_its_strip_sees_a_line_come_from_one_side():
    with emulated("root", "line", speed=SPEED) as emulation, root(emulation.settings) as robot:
        ground = robot.device(GroundSensors)
        readings = []
        robot.device(Base).move(0, 40)
        wait_for(lambda: _noted(readings, ground.read())["right"] < 50, "the line on its right")
        wait_for(lambda: _noted(readings, ground.read())["left"] < 50, "the line on its left")
    assert all(0 <= value <= 100 for reading in readings for value in reading.values())


def test_a_line_where_it_begins_is_seen_before_it_moves():
    with emulated("root", "line") as emulation, root(emulation.settings) as robot:
        seen = robot.device(GroundSensors).read()
        assert pose(emulation.twin)[0] == emulation.twin.path[0][1][0]
        with emulation.twin.body() as body:
            real = body.ground()
    # As bright as the floor, or dark.
    assert {side: value < 50 for side, value in seen.items()} == {
        side: value < 50 for side, value in real.items()
    }
    assert seen["central"] == 0


def test_the_papers_program_follows_a_line(monkeypatch):
    with emulated("root", "line", speed=SPEED) as emulation:
        follow(emulation.twin, monkeypatch)
        settle("root", {**emulation.settings, "patience": LONG})
        report = run_example("line-ebo.bt", "root", seconds=20).report
        path = emulation.twin.path
        line = emulation.twin._simulation.world.description.line[0].polyline()
    assert (report.error, report.ended) == (None, "time limit")
    # Past the first curve's begin, 424 mm from its start.
    assert math.dist(path[0][1][:2], path[-1][1][:2]) > 500
    assert max(line.nearest(x, y)[0] for _, (x, y, _) in path) < 40


def _noted(readings, reading):
    readings.append(reading)
    return reading


def test_it_reads_its_bumpers_and_the_light_on_its_eyes():
    with emulated("root", "bumper", speed=SPEED) as emulation, root(emulation.settings) as robot:
        with emulation.twin.body() as body:
            light = body.light()
        assert robot.device(LightSensor).read() == pytest.approx(light, abs=20)
        assert robot.device(Bumper).read() is False
        robot.device(Base).move(100, 0)
        wait_for(lambda: robot.device(Bumper).read(), "the wall")
        wait_for(lambda: robot.status().battery == 4.0, "its battery")


def test_at_an_edge_it_stops_by_itself_and_its_strip_sees_nothing():
    with emulated("root", "edge", speed=SPEED) as emulation, root(emulation.settings) as robot:
        robot.device(Base).move(80, 0)
        wait_for(lambda: robot.device(GroundSensors).read()["central"] == 0, "the edge")
        assert stands_after(emulation.twin) < 0.5
        assert set(robot.device(GroundSensors).read().values()) == {0.0}


def test_it_draws_lights_up_and_sounds():
    with emulated("root") as emulation, root(emulation.settings) as robot:
        robot.device(RGBLed, "Up").set_color(255, 128, 0)
        assert robot.device(Speaker).tone(440, 250)
        robot.device(Pen).set(down=True)
        robot.device(Base).move(60, 0)
        let_pass(emulation.twin, 1)
        robot.device(Pen).set(down=False)
        with emulation.twin.body() as body:
            assert body.leds["Up"] == (255, 128, 0)
            noted = [(entry.action, *entry.values) for entry in body.log]
            assert noted == [("tone", 440, 250)]
        (stroke,) = strokes(emulation.twin)
        assert math.dist(stroke.points[0], stroke.points[-1]) > 30


def test_it_lifts_its_marker_at_the_end():
    with emulated("root") as emulation:
        with root(emulation.settings) as robot:
            robot.device(Pen).set(down=True)
        marker = bytes(messages.marker(down=True)[:2])
        moved = [packet[3] for packet in emulation.robot.received if packet.startswith(marker)]
        assert moved == [1, 0]


def test_a_marker_that_is_stuck_is_named(monkeypatch):
    monkeypatch.setattr("learnblock.robots.root.MARKER", 0.5)
    with emulated("root") as emulation:
        robot = root(emulation.settings)
        emulation.robot.is_marker_stuck = True
        with pytest.raises(RobotConnectionError) as refusal:
            robot.device(Pen).set(down=True)
        assert refusal.value.phrase == Phrase("irobot-marker-stuck")
        robot.stop()


def test_a_lite_has_neither_a_strip_nor_its_readings():
    with emulated("root") as emulation:
        emulation.robot.boards = frozenset({messages.MAIN_BOARD})
        with root(emulation.settings) as robot:
            assert robot.device(GroundSensors) is None


def test_old_firmware_does_not_know_where_it_is():
    with emulated("root") as emulation:
        emulation.robot.protocol = (1, 1)
        with root(emulation.settings) as robot:
            assert not robot.device(Base).has_odometry


# A link that fails, and a robot that others have.


def test_a_cut_link_ends_the_run():
    with relayed("root") as (emulation, relay, settings):
        robot = root(settings)
        begun = x_of(emulation.twin)
        robot.device(Base).move(40, 0)
        wait_for(lambda: x_of(emulation.twin) > begun + 5, "it drives")
        relay.fault = Fault.CUT
        # Its protocol has no watchdog, and nothing on this computer reaches it.
        with pytest.raises(RobotConnectionError):
            robot.stop()


def test_of_two_programs_on_one_root_the_second_is_refused_and_the_first_drives_on():
    with emulated("root") as emulation, root(emulation.settings) as first:
        begun = x_of(emulation.twin)
        first.device(Base).move(30, 0)
        with pytest.raises(RobotBusyError) as refusal:
            root(emulation.settings)
        place = emulation.settings["address"]
        assert refusal.value.phrase == Phrase("bluetooth-taken", place=place)
        wait_for(lambda: x_of(emulation.twin) > begun + 20, "the first one drives on")


def test_its_button_stops_it_and_ends_the_run():
    with emulated("root") as emulation:
        robot = root(emulation.settings)
        robot.device(Base).move(30, 0)
        emulation.robot.press_button()
        assert stands_after(emulation.twin) < 0.5
        with pytest.raises(RobotConnectionError) as end:
            robot.require_link()
        place = emulation.settings["address"]
        assert end.value.phrase == Phrase("irobot-button", place=place)
        with pytest.raises(RobotConnectionError):
            robot.stop()


def test_an_emulated_root_is_found_where_the_page_looks(monkeypatch):
    with emulated("root") as emulation:
        address = emulation.settings["address"]
        monkeypatch.setattr("learnblock.robots.bluetooth.loopback.HOME", address)
        assert {"address": address} in list(Robot.scan(0.5))
        emulation.robot.manufacturer = {messages.MAKER: b"C3"}
        assert list(Robot.scan(0.5)) == []


def test_another_robot_of_irobots_is_told_apart():
    with emulated("root") as emulation:
        emulation.robot.serial = "CR3000000001"
        emulation.robot.answer(messages.PROXIMITY, bytes(16))
        with pytest.raises(RobotConnectionError) as refusal:
            root(emulation.settings)
        place = emulation.settings["address"]
        assert refusal.value.phrase == Phrase("irobot-is-create3", place=place)


# iRobot's own program.


def test_our_packets_are_those_of_irobots_own_program():
    ours = {
        "set_wheel_speeds(5, -3.5)": messages.drive(50, -35),
        "set_lights_rgb(255, 7, 0)": messages.lights(255, 7, 0),
        "set_lights_off()": messages.lights(0, 0, 0),
        "play_note(440, 0.25)": messages.note(440, 250),
        "set_marker_down()": messages.marker(down=True),
        "set_marker_up()": messages.marker(down=False),
        "get_light_values()": messages.LIGHT,
        "get_battery_level()": messages.BATTERY,
        "get_color_section(2, 4, 0)": messages.strip_levels(2, messages.ALL_LIT),
        "get_versions(0xC6)": messages.versions(messages.COLOUR_BOARD),
        "stop()": messages.STOP,
    }
    theirs = packets_of("Root", ours)
    encoded = [
        Packet(*message[:2], number, message.payload).encoded
        for number, message in enumerate(ours.values())
    ]
    assert dict(zip(ours, theirs, strict=True)) == dict(zip(ours, encoded, strict=True))


def test_irobots_own_program_drives_the_emulated_root():
    with emulated("root") as emulation:
        said = run_sdk("Root", emulation.settings["address"], SDK_PROGRAM)
        x, y, heading = pose(emulation.twin)
        assert (x, y) == pytest.approx((100, 0), abs=6)
        assert heading == pytest.approx(90, abs=3)
        assert said["bumpers"] == [False, False]
        assert said["battery"] == [4000, 75]
        assert said["version"] == "Main: 2.1\tColor: 2.1"
        assert said["serial"] == "RT0123456789"
        with emulation.twin.body() as body:
            eye = round(body.light() / 1.023)
        assert said["light"] == pytest.approx([eye / 1000] * 2, abs=0.02)
        (stroke,) = strokes(emulation.twin)
        assert len(stroke.points) > 10


SDK_PROGRAM = """
await robot.set_marker_down()
await robot.move(10)
await robot.set_marker_up()
await robot.turn_right(90)
said["bumpers"] = robot.get_bumpers_cached()
said["battery"] = await robot.get_battery_level()
said["version"] = await robot.get_version_string()
said["serial"] = await robot.get_serial_number()
said["light"] = await robot.get_light_values()
"""


def test_the_events_of_the_emulated_root_are_those_that_irobots_own_program_reads():
    with emulated("root", "line") as emulation:
        said = run_sdk("Root", emulation.settings["address"], SDK_EVENTS)
    assert len(said["colours"]) == messages.COLOURS
    assert set(said["colours"]) == {messages.WHITE, messages.BLACK}
    darkest, brightest = min(said["lit"]), max(said["lit"])
    assert len(said["lit"]) == messages.COLOURS
    assert darkest < brightest / 4
    assert max(said["unlit"]) < brightest / 10


SDK_EVENTS = """
said["lit"] = await robot.get_color_values(4, 1)
said["unlit"] = await robot.get_color_values(0, 1)
await robot.set_wheel_speeds(0, 5)
for _ in range(400):
    await asyncio.sleep(0.02)
    colours = robot.get_color_ids_cached()
    if colours and len(set(colours)) > 1:
        break
said["colours"] = [int(colour) for colour in colours]
"""
