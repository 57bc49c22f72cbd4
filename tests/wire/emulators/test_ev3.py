"""The emulated EV3: its files as seen by the real python-ev3dev2, and its firmware's byte code."""

import json
import socket
import struct
import subprocess
import sys

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from bricks import brick
from learnblock.devices import Base
from learnblock.emulators import emulate
from learnblock.emulators.ev3 import firmware
from learnblock.emulators.ev3.bytecode import ByteCodeError, ByteCodeMachine, ByteCodeReader
from learnblock.emulators.ev3.ev3dev import RPYC
from learnblock.emulators.ev3.sysfs import Attribute
from learnblock.errors import UnknownNameError
from learnblock.robots import connect
from twins import x_of
from waiting import wait_for

#: python-ev3dev2 on the emulator's files, as over rpyc, without rpyc.
EV3DEV2 = (
    RPYC.partition("server =")[0].replace("from rpyc", "# from rpyc")
    + """
import json, time
from ev3dev2.motor import LargeMotor, SpeedDPS
from ev3dev2.sensor.lego import ColorSensor, GyroSensor, TouchSensor, UltrasonicSensor
"""
)


def ev3dev2(emulation, program):
    """The output of a program with python-ev3dev2 on the emulated brick."""
    finished = subprocess.run(
        [sys.executable, "-c", EV3DEV2 + program, str(emulation.brick.sysfs)],
        env=emulation.brick.environment,
        stdout=subprocess.PIPE,
        check=True,
        timeout=30,
    )
    return json.loads(finished.stdout)


def test_python_ev3dev2_drives_the_twin_and_reads_its_sensors():
    with brick("agent", "obstacles") as emulation:
        begun = x_of(emulation.twin)
        read = ev3dev2(
            emulation,
            """
left, right = LargeMotor("outB"), LargeMotor("outD")
for motor in (left, right):
    motor.on(SpeedDPS(200))
while left.position < 100:
    time.sleep(0.002)
assert left.is_running
for motor in (left, right):
    motor.off()
color = ColorSensor()
print(json.dumps({
    "position": left.position,
    "speed_sp": left.speed_sp,
    "light": color.reflected_light_intensity,
    "angle": GyroSensor().angle,
    "distance": UltrasonicSensor().distance_centimeters,
    "touched": TouchSensor().is_pressed,
}))
""",
        )
        came = x_of(emulation.twin) - begun
        with emulation.twin.body() as body:
            front = body.distances()["front"][0]
    # With a radius of 30 mm, 0.52 mm per degree.
    assert came == pytest.approx(read["position"] * 0.5236, rel=0.15)
    assert read["speed_sp"] == 200
    assert read["light"] > 50
    assert abs(read["angle"]) < 3
    assert read["distance"] * 10 == pytest.approx(front if front < 2000 else 2550, rel=0.1)
    assert read["touched"] == 0


def test_python_ev3dev2_reads_what_our_agent_writes():
    read = "m = LargeMotor('outB'); print(json.dumps([m.speed_sp, m.stop_action, m.state]))"
    with brick("agent") as emulation, connect("ev3", **emulation.settings) as robot:
        # 1 mm/s is 1.9 degrees/s.
        robot.device(Base).move(100, 0)
        motor = emulation.brick.tree.motors["B"]
        wait_for(lambda: motor.speed == 191, "it turns")
        assert ev3dev2(emulation, read) == [191, "coast", ["running"]]
        robot.device(Base).stop()
        wait_for(lambda: motor.speed == 0, "it stands")
        assert ev3dev2(emulation, read) == [191, "brake", []]


def test_a_speed_takes_effect_with_the_next_command_and_one_out_of_range_not_at_all():
    with brick("agent") as emulation:
        tree = emulation.brick.tree
        motor = tree.motors["D"]

        def write(name, text):
            # In a single write, as ev3dev2 does: the brick must not find the file empty.
            with motor[name].path.open("r+b", buffering=0) as file:
                file.write(text.encode())

        write("speed_sp", "300\n")
        write("command", "run-forever\n")
        wait_for(lambda: motor.speed == 300, "it turns")
        write("speed_sp", "90\n")
        wait_for(lambda: motor["speed_sp"].value == "90", "it is taken in")
        assert motor.speed == 300
        write("command", "run-forever\n")
        wait_for(lambda: motor.speed == 90, "the same command again")
        write("speed_sp", "1051\n")
        write("command", "run-forever\n")
        wait_for(lambda: motor.speed == 0, "it is refused")


def test_a_shorter_value_replaces_a_longer_one_whole(tmp_path):
    attribute = Attribute(tmp_path / "speed_sp", 0o664, -1050)
    assert attribute.written() is None
    with (tmp_path / "speed_sp").open("r+b", buffering=0) as file:
        file.write(b"7\n")
    assert attribute.written() == "7"
    assert attribute.written() is None
    attribute.show(12)
    assert (tmp_path / "speed_sp").read_text().strip() == "12"
    attribute.close()


def test_a_user_emulates_one_connection():
    with emulate("ev3", "empty", connection="direct") as emulation:
        assert emulation.settings.keys() == {"connection", "address", "direct_port"}
    with pytest.raises(UnknownNameError, match="There is no connection 'telepathy'"):
        emulate("ev3", connection="telepathy")


# The firmware.


class FakeVehicle:
    """Records its calls."""

    def __init__(self):
        self.speeds = {}
        self.noted = []

    def turn(self, speeds):
        self.speeds = speeds

    def turned(self):
        return {"B": 90.4, "D": -20.0}

    def distance(self):
        return 254.0

    def reflection(self):
        return 45.0

    def angle(self):
        return -3.0

    def touched(self):
        return True

    def note(self, *values):
        self.noted.append(values)

    def show(self, text):
        self.noted.append(("show", text))


class Time:
    now = 0.0

    def __call__(self):
        return self.now


def message(code, size=0, kind=0x00):
    return struct.pack("<HBH", 1, kind, size) + bytes.fromhex(code)


@pytest.fixture
def vehicle():
    return FakeVehicle()


def test_a_timed_motor_turns_until_its_time_is_over(vehicle):
    now = Time()
    machine = ByteCodeMachine(vehicle, now)
    # Motor B at -50 percent for 300 ms, then brake.
    assert machine.execute(message("af000281ce00822c010001")) == b"\x01\x00\x02"
    assert vehicle.speeds == {"A": 0, "B": -525, "C": 0, "D": 0}
    now.now = 0.299
    machine.turn()
    assert vehicle.speeds["B"] == -525
    now.now = 0.301
    machine.turn()
    assert vehicle.speeds["B"] == 0


def test_a_reply_has_the_requested_values_at_the_given_positions(vehicle):
    # Type and mode at port 4, the count of motor B, and what the sensors at ports 4 and 1 read.
    code = "99050003" + "6061" + "b3000164" + "991d00030000016" + "8" + "991d0000000001" + "6c"
    reply = ByteCodeMachine(vehicle).execute(message(code, 16))
    assert reply[:3] == b"\x01\x00\x02"
    kind, mode, count, distance, touched = struct.unpack("<bb2xiff", reply[3:])
    assert (kind, mode, count, touched) == (30, 0, 90, 1)
    assert distance == pytest.approx(25.4)


@pytest.mark.parametrize(
    "code",
    ["ff", "a3", "a30002", "990500034041", "b3000161", "b3000178", "9502", "a3010201", "99ff00"],
)
def test_the_firmware_rejects_unknown_commands(vehicle, code):
    assert ByteCodeMachine(vehicle).execute(message(code, 4)) == b"\x01\x00\x04"


def test_a_command_without_a_reply_gets_none(vehicle):
    assert ByteCodeMachine(vehicle).execute(message("94010282e80382e803", kind=0x80)) == b""
    assert vehicle.noted == [("tone", 1000.0, 1000.0)]


@settings(max_examples=500)
@given(st.binary(max_size=60) | st.binary(max_size=60).map(lambda code: b"\1\0\0\x10\0" + code))
def test_no_message_upsets_the_firmware(code):
    assert isinstance(ByteCodeMachine(FakeVehicle()).execute(code), bytes)


def test_a_stranger_that_says_nothing_leaves_the_firmwares_only_place(monkeypatch):
    monkeypatch.setattr(firmware, "GREETING", 0.2)
    with brick("direct") as emulation:
        place = ("127.0.0.1", emulation.settings["direct_port"])
        with socket.create_connection(place), connect("ev3", **emulation.settings) as robot:
            robot.check_link()


def test_constants_are_decoded():
    code = ByteCodeReader(bytes.fromhex("1f20818082e80383a0860100"))
    assert [code.constant() for _ in range(5)] == [31, -32, -128, 1000, 100000]
    with pytest.raises(ByteCodeError):
        code.byte()
