"""LEGO Education over Bluetooth: its devices as their maker's own package knows them."""

import signal
import socket
import subprocess
import sys
from contextlib import contextmanager

import legoeducation
import pytest
from legoeducation import ble_transport

from emulated import emulating, on_a_link, unproven
from learnblock.devices import (
    Base,
    Controller,
    GroundSensors,
    Gyroscope,
    JointMotor,
    RGBLed,
    Speaker,
)
from learnblock.emulators import emulate
from learnblock.emulators.legoed import Emulator
from learnblock.emulators.legoed.transport import LoopbackTransport
from learnblock.errors import RobotBusyError, RobotConnectionError
from learnblock.i18n import Phrase
from learnblock.robots import connect
from learnblock.robots.legoed import Robot
from learnblock.robots.legoed.messages import Product
from learnblock.testing import Fault, check_robot
from twins import stands_after, x_of
from twins_time import follow
from waiting import wait_for


@contextmanager
def kit(world="empty"):
    """Emulate the devices."""
    with emulating(Emulator, "sim-legoed", world) as emulation:
        emulation.devices = emulation.emulator.devices
        yield emulation


@contextmanager
def relayed():
    """Emulate the devices, the Double Motor on a link that can fail."""
    with kit() as emulation, on_a_link(emulation) as linked:
        yield linked


def legoed(settings, **others):
    return connect("legoed", **{**settings, **others})


def test_a_kit_conforms(monkeypatch):
    # In real time: a command to drive lasts 0.4 s of the world.
    with relayed() as (emulation, relay, settings):
        follow(emulation.twin, monkeypatch)
        certificate = check_robot(lambda: legoed(settings), relay=relay)
    assert unproven(certificate) == ["its accelerometer shows 1 g upwards at rest"]


def test_its_sensors_read_what_the_twins_do():
    with kit("line") as emulation, legoed(emulation.settings) as robot:
        base = robot.device(Base)
        base.move(0, 60)
        wait_for(lambda: robot.read(Gyroscope, "Z_AXIS") > 200, "more than half a turn")
        base.stop()
        stands_after(emulation.twin)
        with emulation.twin.body() as body:
            ground, angle = body.ground()["central"], body.gyroscope()
        assert robot.device(Gyroscope, "Z_AXIS").read() == pytest.approx(angle, abs=1.5)
        assert robot.device(GroundSensors).read()["central"] == pytest.approx(ground, abs=6)
        assert robot.status().charge == 0.8


def test_the_levers_of_the_controller_are_buttons():
    with kit() as emulation, legoed(emulation.settings) as robot:
        emulation.devices[Product.CONTROLLER].levers = (100, -60)
        wait_for(lambda: robot.read(Controller)["lUp"], "a lever")
        pressed = [name for name, is_down in robot.read(Controller).items() if is_down]
        assert pressed == ["lUp", "rDown"]


def test_it_sounds_and_lights_its_button():
    with kit() as emulation, legoed(emulation.settings) as robot:
        robot.device(Speaker).tone(440, 250)
        robot.device(Speaker).tone(9000, 250)
        assert emulation.devices[Product.DOUBLE_MOTOR].sounds == [440, 2700]
        robot.device(RGBLed, "Status").set_color(128, 0, 0)
        with emulation.twin.body() as body:
            assert body.leds["Status"] == (127, 0, 0)


def test_with_its_other_end_in_front_it_drives_the_other_way():
    with kit() as emulation, legoed(emulation.settings, front="backward") as robot:
        begun = x_of(emulation.twin)
        robot.device(Base).move(40, 0)
        wait_for(lambda: x_of(emulation.twin) < begun - 20, "it drives backwards")
        assert robot.device(Base).pose()[0] > 15


@pytest.mark.parametrize("product", [Product.COLOUR_SENSOR, Product.SINGLE_MOTOR])
def test_a_device_that_does_not_belong_to_it_is_left_alone(product):
    absent = {Product.COLOUR_SENSOR: "colour", Product.SINGLE_MOTOR: "motor"}[product]
    with kit() as emulation, legoed(emulation.settings, **{absent: "none"}) as robot:
        kinds = {type(device) for _, device in robot.devices()}
        assert (GroundSensors in kinds) == (product is not Product.COLOUR_SENSOR)
        assert (JointMotor in kinds) == (product is not Product.SINGLE_MOTOR)


# A link that fails, and a computer that is gone.


@pytest.mark.parametrize("fault", [Fault.CUT, Fault.SILENT])
def test_the_wheels_stop_half_a_second_after_the_last_command(fault):
    with relayed() as (emulation, relay, settings):
        robot = legoed(settings)
        begun = x_of(emulation.twin)
        robot.device(Base).move(40, 0)
        wait_for(lambda: x_of(emulation.twin) > begun + 5, "it drives")
        relay.fault = fault
        assert stands_after(emulation.twin) < 0.5
        with pytest.raises(RobotConnectionError):
            robot.stop()


@pytest.mark.parametrize("end", [signal.SIGKILL, signal.SIGSTOP])
def test_the_wheels_stop_when_the_program_is_killed_or_frozen(end):
    with (
        kit() as emulation,
        subprocess.Popen(
            [sys.executable, "-c", DRIVER, repr(dict(emulation.settings))], stdout=subprocess.PIPE
        ) as process,
    ):
        begun = x_of(emulation.twin)
        assert process.stdout.readline() == b"going\n"
        wait_for(lambda: x_of(emulation.twin) > begun + 5, "it drives")
        process.send_signal(end)
        assert stands_after(emulation.twin) < 0.5
        process.kill()


DRIVER = """
import sys
from learnblock.robots import connect
robot = connect("legoed", **eval(sys.argv[1]))
robot.set_move(40, 0)
print("going", flush=True)
robot.sleep(60)
"""


def test_of_two_programs_the_second_is_refused():
    with kit() as emulation, legoed(emulation.settings):
        with pytest.raises(RobotBusyError) as refusal:
            legoed(emulation.settings)
        place = emulation.settings["address"]
        assert refusal.value.phrase == Phrase("bluetooth-taken", place=place)


@pytest.mark.parametrize(("version", "newer"), [((2, 4, 0), "true"), ((2, 1, 7), "false")])
def test_a_device_whose_messages_have_another_version_is_refused(version, newer):
    with kit() as emulation:
        emulation.devices[Product.CONTROLLER].version = version
        with pytest.raises(RobotConnectionError) as refusal:
            legoed(emulation.settings)
        assert refusal.value.phrase.code == "legoed-other-version"
        assert refusal.value.phrase.values["newer"] == newer


def test_a_device_of_another_kind_is_refused():
    with kit() as emulation:
        wrong = {"colour": emulation.settings["motor"], "motor": "none"}
        with pytest.raises(RobotConnectionError) as refusal:
            legoed(emulation.settings, **wrong)
        assert refusal.value.phrase.code == "legoed-garbled"


def test_it_is_found_where_the_page_looks_with_its_other_devices(monkeypatch):
    with kit() as emulation:
        address = emulation.settings["address"]
        monkeypatch.setattr("learnblock.robots.bluetooth.loopback.HOME", address)
        assert {"address": address} in list(Robot.scan(0.5))
        with legoed({"address": address}) as robot:
            assert {GroundSensors, Controller, JointMotor} <= {
                type(device) for _, device in robot.devices()
            }


def test_a_port_that_is_taken_makes_a_device_listen_elsewhere():
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = taken.getsockname()[1] - 1
        with emulate("legoed", port=port) as emulation, legoed(emulation.settings) as robot:
            assert emulation.settings["colour"] != f"127.0.0.1:{port + 1}"
            assert robot.read(GroundSensors)["central"] is not None


# The maker's own client, over its transport that can be replaced, drives the same devices.


@pytest.fixture
def makers(monkeypatch):
    """LEGO's package, whose transport reaches the emulated devices."""
    with kit() as emulation:
        monkeypatch.setattr(LoopbackTransport, "home", emulation.settings["address"])
        ble_transport.register_transport(LoopbackTransport)
        yield emulation


def test_the_makers_own_client_drives_and_reads_the_emulated_devices(makers):
    motor, sensor = legoeducation.DoubleMotor(), legoeducation.ColorSensor()
    arm = legoeducation.SingleMotor()
    for device in (motor, sensor, arm):
        device.connect(device_notification_delay=20)
        assert device.connected
    try:
        begun = x_of(makers.twin)
        # Slowly, because a busy machine stops a movement late.
        motor.movement_move_tank_for_degrees(90, speed_left=10, speed_right=10)
        # 90 degrees of a wheel of 31 mm.
        assert x_of(makers.twin) - begun == pytest.approx(48.7, abs=8)
        right = legoeducation.MOVEMENT_TURN_DIRECTION_RIGHT
        motor.movement_turn_for_degrees(45, direction=right, speed=10)
        wait_for(lambda: motor.imu_device.yaw == pytest.approx(450, abs=100), "a turn")
        arm.motor_run_to_relative_position(30)
        wait_for(lambda: arm.motor.position == pytest.approx(30, abs=2), "the arm")
        with makers.twin.body() as body:
            assert sensor.sensor.reflection == pytest.approx(body.ground()["central"], abs=6)
    finally:
        for device in (motor, sensor, arm):
            device.disconnect()


def test_the_driver_writes_byte_by_byte_what_the_makers_client_does(makers, monkeypatch):
    written = []
    firmware = makers.devices[Product.DOUBLE_MOTOR]
    take = firmware.write

    def noting(uuid, value):
        written.append(value)
        take(uuid, value)

    monkeypatch.setattr(firmware, "write", noting)
    motor = legoeducation.DoubleMotor()
    motor.connect(device_notification_delay=30)
    motor.movement_set_end_state(legoeducation.MOTOR_END_STATE_BRAKE)
    motor.movement_set_acceleration(100, 100)
    motor.light_color(legoeducation.LEGO_COLOR_RED, intensity=50)
    motor.beep(frequency=440)
    motor.movement_stop()
    motor.disconnect()
    theirs = b"".join(written)
    written.clear()
    with legoed(makers.settings) as robot:
        robot.device(RGBLed, "Status").set_color(128, 0, 0)
        robot.device(Speaker).tone(440, 100)
        robot.device(Base).stop()
    assert b"".join(written).startswith(theirs)
