"""Direct commands of LEGO's firmware: byte for byte, invalid replies, and wires besides Wi-Fi."""

import os
import socket
import struct
import sys
from contextlib import contextmanager

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from emulated import LONG
from ev3_wires import Bytes
from learnblock.devices import LONGEST_TEXT, Base, Gyroscope
from learnblock.emulators.ev3.firmware import Firmware
from learnblock.emulators.ev3.motors import LEFT, RIGHT
from learnblock.emulators.twin import Twin
from learnblock.emulators.vehicle import Vehicle
from learnblock.errors import RobotConnectionError
from learnblock.robots import connect
from learnblock.robots.ev3 import direct, scan
from learnblock.robots.ev3.brick import Look
from learnblock.robots.ev3.direct_link import DirectMotor
from learnblock.robots.ev3.link import BrickLink
from learnblock.robots.ev3.screen import LARGE, NORMAL, laid_out
from twins import stands_after, x_of
from waiting import wait_for

# Examples of LEGO's "EV3 Communication Developer Kit", chapter 4.


def test_numbers_take_as_few_bytes_as_in_legos_examples():
    written = {0: "00", 1: "01", -1: "3f", 31: "1f", -32: "20"}
    written |= {32: "8120", 50: "8132", -50: "81ce", 180: "82b400", 900: "828403", 1000: "82e803"}
    written |= {100000: "83a0860100"}
    assert {value: direct.number(value).hex() for value in written} == written


def test_a_tone_is_legos_example():
    assert direct.tone(1000, 1000, volume=2).hex() == "94010282e80382e803"


def test_text_is_written_line_by_line_on_an_empty_screen():
    shown = direct.show(LARGE, ("Hi", "you"))
    emptied = "841200" + "8413000000" + "841102"
    lines = "8405010000" + "84486900" + "8405010012" + "84796f7500"
    assert shown.hex() == emptied + lines + "8400"


def test_a_screen_without_text_shows_the_top_line_of_the_menu():
    assert direct.show(LARGE, ()).hex() == "841201" + "8413000000" + "841102" + "8400"


@pytest.mark.parametrize(
    ("text", "font", "lines"),
    [
        ("hello", LARGE, ("hello",)),
        ("¿Dónde estás?", LARGE, ("Donde", "estas?")),
        ("one\ntwo", LARGE, ("one", "two")),
        ("名", LARGE, ("?",)),
        ("", LARGE, ()),
        ("word " * 20, NORMAL, ("word word word word",) * 5),
    ],
)
def test_a_text_is_laid_out_in_the_largest_font_in_which_it_fits(text, font, lines):
    assert laid_out(text) == (font, lines)


@settings(max_examples=100)
@given(st.text(max_size=LONGEST_TEXT))
def test_any_text_fits_on_the_screen_and_into_a_message(text):
    font, lines = laid_out(text)
    assert len(lines) <= font.rows
    assert all(len(line) <= font.columns for line in lines)
    assert len(direct.show(font, lines)) < direct.LARGEST - 200


def test_a_motor_is_turned_for_a_time_and_stopped():
    assert direct.turn(1, 50, 300).hex() == "af00028132" + "00822c0100" + "01"
    assert direct.stop(3).hex() == "a3000801"


def test_a_command_names_the_positions_of_its_results_each_at_a_multiple_of_its_size():
    question = direct.Question([direct.kind_of(2), direct.turned(1), direct.reading(3, 0)])
    code = "99050002" + "6061" + "b30001" + "64" + "991d0003000001" + "68"
    body = struct.pack("<HBH", 7, 0, 12) + bytes.fromhex("01" + code)
    assert direct.command(7, bytes.fromhex("01"), question) == struct.pack("<H", len(body)) + body


def test_a_reply_gives_the_results_in_order():
    question = direct.Question([direct.kind_of(2), direct.turned(1), direct.reading(3, 0)])
    body = struct.pack("<HB", 7, 2) + struct.pack("<bb2xif", 30, 1, -720, 12.5)
    assert direct.answered(body, 7, question) == (30, 1, -720, 12.5)


def test_the_reply_to_an_earlier_command_is_skipped_and_a_rejection_is_reported():
    assert direct.answered(struct.pack("<HB", 6, 2), 7, direct.Question([])) is None
    with pytest.raises(direct.CommandFailedError):
        direct.answered(struct.pack("<HB", 7, 4), 7, direct.Question([]))


@settings(max_examples=250)
@given(st.binary(max_size=40) | st.binary(max_size=40).map(lambda rest: b"\x07\0\x02" + rest))
def test_a_reply_is_read_or_refused(body):
    question = direct.Question([direct.kind_of(2), direct.turned(1), direct.reading(3, 0)])
    try:
        results = direct.answered(body, 7, question)
    except (ValueError, direct.CommandFailedError):
        return
    assert results is None or len(results) == 4


@settings(max_examples=150)
@given(st.binary(max_size=60))
def test_bytes_of_a_wire_are_messages_or_refused(data):
    wire = Bytes(data)
    try:
        while True:
            assert len(wire.receive(1)) >= 3
    except (OSError, ValueError):
        return


def test_the_rounding_of_a_speed_is_corrected_later():
    motor = DirectMotor(1)
    turns = [motor.turn(2.4) for _ in range(10)]
    assert sum(one == direct.turn(1, 3, 300) for one in turns) == 4
    assert sum(one == direct.turn(1, 2, 300) for one in turns) == 6
    assert motor.turn(250.0) == direct.turn(1, 100, 300)
    assert motor.turn(0.0) == direct.stop(1)
    assert motor.turn(0.3) == direct.stop(1)
    assert motor.turn(0.3) == direct.turn(1, 1, 300)


class Silence(BrickLink):
    """A link that is closed while a thread is waiting to send."""

    def exchange(self, word):
        raise AssertionError("a wire that was let go is used")

    def hang_up(self):
        """Do nothing: there is no wire."""


def test_a_closed_link_sends_nothing_more_and_is_not_broken():
    link = Silence("there", lambda state: None)
    link.close()
    with pytest.raises(RobotConnectionError, match="is closed"):
        link.say(Look())
    link.check()


# Beacons.


@settings(max_examples=150)
@given(st.binary() | st.from_regex(scan._BEACON))
def test_a_beacon_is_read_or_skipped(data):
    port = scan.read_beacon(data)
    assert port is None or 0 < port < 65536


def test_a_brick_that_sends_beacons_is_found():
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    with Twin("sim-ev3", "empty") as twin:
        firmware = Firmware(Vehicle(twin, LEFT, RIGHT), beacon=("127.0.0.1", port))
        try:
            found = next(scan.beacons(60.0, port))
        finally:
            firmware.close()
    expected = {"connection": "direct", "address": "127.0.0.1", "direct_port": firmware.port}
    assert found == expected


# Other wires.


@contextmanager
def cable(path, *, reports):
    """A brick at a device file; yields the twin."""
    tty = pytest.importorskip("tty", reason="this system has no such files")
    ours, theirs = os.openpty()
    tty.setraw(theirs)
    path.symlink_to(os.ttyname(theirs))
    with Twin("sim-ev3", "empty") as twin:
        firmware = Firmware(Vehicle(twin, LEFT, RIGHT))
        firmware.attach(ours, reports=reports)
        try:
            yield twin
        finally:
            firmware.close()
            os.close(theirs)


@pytest.mark.parametrize(("name", "reports"), [("rfcomm0", False), ("hidraw0", True)])
def test_a_brick_is_driven_over_bluetooth_and_usb(tmp_path, name, reports):
    with cable(tmp_path / name, reports=reports) as twin:
        with connect("ev3", device=str(tmp_path / name), patience=LONG) as robot:
            begun = x_of(twin)
            robot.device(Base).move(100, 0)
            wait_for(lambda: x_of(twin) > begun + 20, "it drives")
            assert abs(robot.device(Gyroscope, "Z_AXIS").read()) < 2
        assert stands_after(twin) < 0.5


@pytest.mark.skipif(sys.platform == "win32", reason="files of POSIX")
def test_a_missing_or_silent_device_is_reported(tmp_path):
    with pytest.raises(RobotConnectionError, match=r"rfcomm9 can't be opened \(No such file"):
        connect("ev3", device=str(tmp_path / "rfcomm9"))
    ours, theirs = os.openpty()
    try:
        with pytest.raises(RobotConnectionError, match="does not respond like an EV3"):
            connect("ev3", device=os.ttyname(theirs), patience=0.5)
    finally:
        os.close(ours)
        os.close(theirs)
