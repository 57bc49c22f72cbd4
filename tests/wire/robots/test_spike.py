"""SPIKE over Bluetooth: our agent in a real MicroPython, on a hub that moves a twin."""

import inspect
import signal
import subprocess
import sys
from contextlib import contextmanager
from importlib import import_module, resources

import mpy_cross_v6
import pytest

from bricks import assert_reads_what_the_twin_does
from emulated import emulating, on_a_link, unproven
from learnblock.devices import (
    Base,
    Bumper,
    DistanceSensors,
    GroundSensors,
    RGBLed,
    Speaker,
)
from learnblock.emulators.spike import Emulator, firmware
from learnblock.errors import RobotBusyError, RobotConnectionError
from learnblock.i18n import Phrase
from learnblock.robots import connect
from learnblock.robots.spike import Robot
from learnblock.testing import Fault, check_robot
from twins import stands_after, x_of
from twins_time import follow
from waiting import wait_for

#: How much faster than real time a quick world runs; the agent's own clock is real.
SPEED = 3


@contextmanager
def hub(world="empty", *, speed=1):
    """Emulate a hub."""
    with emulating(Emulator, "sim-spike", world, speed=speed) as emulation:
        emulation.hub = emulation.emulator.hub
        yield emulation


@contextmanager
def relayed(**others):
    """Emulate a hub on a link that can fail; yield emulation, relay and settings."""
    with hub(**others) as emulation, on_a_link(emulation) as linked:
        yield linked


def spike(settings, **others):
    return connect("spike", **{**settings, **others})


def test_a_spike_conforms(monkeypatch):
    with relayed(speed=SPEED) as (emulation, relay, settings):
        follow(emulation.twin, monkeypatch)
        certificate = check_robot(lambda: spike(settings), relay=relay)
    assert unproven(certificate) == [
        "its accelerometer shows 1 g upwards at rest",
        "its joints move to the commanded angle",
    ]


def test_its_sensors_read_what_the_twins_do():
    with hub("obstacles") as emulation, spike(emulation.settings) as robot:
        assert_reads_what_the_twin_does(robot, emulation.twin)
        assert robot.device(Bumper).read() is False
        assert robot.status().battery == 8.0


def test_it_sounds_shows_letters_and_lights_its_button():
    with hub() as emulation, spike(emulation.settings) as robot:
        assert robot.device(Speaker).tone(440, 250)
        whole = [("tone", 440, -1), ("tone", 64, 0)]
        wait_for(lambda: noted(emulation) == whole, "a tone that ends")
        robot.show_text("¡Olé!")
        wait_for(lambda: shown(emulation) == "O", "the first letter")
        wait_for(lambda: shown(emulation) == "l", "the next letter")
        robot.clear_screen()
        wait_for(lambda: shown(emulation) == "", "nothing")
        robot.device(RGBLed, "Status").set_color(255, 0, 0)
        wait_for(lambda: lit(emulation) == (255, 0, 0), "a red light")


def noted(emulation):
    with emulation.twin.body() as body:
        return [(entry.action, *entry.values) for entry in body.log if entry.device == "Speaker"]


def shown(emulation):
    with emulation.twin.body() as body:
        return body.text


def lit(emulation):
    with emulation.twin.body() as body:
        return body.leds["Status"]


# A link that fails, and a hub whose program is gone.


@pytest.mark.parametrize("fault", [Fault.CUT, Fault.SILENT])
def test_the_hub_stops_its_motors_half_a_second_after_the_last_line(fault):
    with relayed() as (emulation, relay, settings):
        robot = spike(settings)
        begun = x_of(emulation.twin)
        robot.device(Base).move(40, 0)
        wait_for(lambda: x_of(emulation.twin) > begun + 5, "it drives")
        relay.fault = fault
        assert stands_after(emulation.twin) < 0.5
        with pytest.raises(RobotConnectionError):
            robot.stop()


def test_an_agent_whose_program_is_gone_ends_and_the_next_program_starts_another():
    with hub() as emulation:
        with subprocess.Popen(
            [sys.executable, "-c", DRIVER, repr(dict(emulation.settings))], stdout=subprocess.PIPE
        ) as process:
            begun = x_of(emulation.twin)
            assert process.stdout.readline() == b"going\n"
            wait_for(lambda: x_of(emulation.twin) > begun + 5, "it drives")
            process.send_signal(signal.SIGKILL)
            assert stands_after(emulation.twin) < 0.5
        wait_for(lambda: not emulation.hub.runs, "the agent ends")
        spike(emulation.settings).stop()


DRIVER = """
import sys
from learnblock.robots import connect
robot = connect("spike", **eval(sys.argv[1]))
robot.set_move(40, 0)
print("going", flush=True)
robot.sleep(60)
"""


def test_of_two_programs_on_one_hub_the_second_is_refused_and_the_first_drives_on():
    with hub() as emulation, spike(emulation.settings) as first:
        begun = x_of(emulation.twin)
        first.device(Base).move(30, 0)
        with pytest.raises(RobotBusyError) as refusal:
            spike(emulation.settings)
        assert refusal.value.phrase == Phrase(
            "bluetooth-taken", place=emulation.settings["address"]
        )
        wait_for(lambda: x_of(emulation.twin) > begun + 20, "the first one drives on")


def test_a_pressed_button_ends_the_agent_and_the_driver_says_so():
    with hub() as emulation:
        robot = spike(emulation.settings)
        emulation.hub.press_button()
        place = emulation.settings["address"]
        assert failure(robot) == Phrase("spike-agent-ended", place=place)


@pytest.mark.parametrize(
    ("unplugged", "chosen", "phrase"),
    [
        ("A", {}, Phrase("spike-no-motor", motor="right")),
        ("B", {"right": "B"}, Phrase("spike-no-motor-at", motor="right", port="B")),
        ("C", {"distance": "C"}, Phrase("spike-no-sensor", sensor="distance", port="C")),
    ],
)
def test_what_is_not_plugged_in_is_named(unplugged, chosen, phrase):
    with hub() as emulation:
        del emulation.hub.devices.plugged[unplugged]
        with pytest.raises(RobotConnectionError) as refusal:
            spike(emulation.settings, **chosen)
        assert refusal.value.phrase == phrase


def test_a_hub_without_sensors_has_the_devices_that_it_has():
    with hub() as emulation:
        for port in "CDE":
            del emulation.hub.devices.plugged[port]
        with spike(emulation.settings) as robot:
            kinds = {type(device) for _, device in robot.devices()}
            assert not {DistanceSensors, GroundSensors, Bumper} & kinds


def test_a_motor_that_is_unplugged_meanwhile_ends_the_run():
    with hub() as emulation:
        robot = spike(emulation.settings)
        robot.device(Base).move(30, 0)
        del emulation.hub.devices.plugged["B"]
        assert failure(robot) == Phrase("spike-motor-lost", motor="right")


def failure(robot):
    """The phrase of the error that ends the run of a program."""

    def is_lost():
        try:
            robot.require_link()
        except RobotConnectionError:
            return True
        return False

    wait_for(is_lost, "the driver notices")
    with pytest.raises(RobotConnectionError):
        robot.stop()
    return robot.link_error.phrase


def test_an_emulated_hub_is_found_where_the_page_looks(monkeypatch):
    with hub() as emulation:
        address = emulation.settings["address"]
        monkeypatch.setattr("learnblock.robots.bluetooth.loopback.HOME", address)
        assert {"address": address} in list(Robot.scan(0.5))


def test_a_computer_without_bluetooth_is_told_so():
    with pytest.raises(RobotConnectionError) as refusal:
        connect("spike", patience=2.0)
    assert refusal.value.phrase == Phrase("bluetooth-none")


# The agent and the modules that it uses, as Pybricks documents them.


def test_the_compiled_agent_is_that_of_its_source():
    agent = resources.files("learnblock.robots.spike")
    source = agent.joinpath("agent.py").read_text("utf-8")
    process, compiled = mpy_cross_v6.mpy_cross_compile("agent.py", source)
    assert process.returncode == 0, process.stderr
    assert agent.joinpath("agent.mpy").read_bytes() == compiled, "Run scripts/agent."


@pytest.mark.parametrize("name", sorted(set(firmware.modules()) - {"pybricks", "uselect", "usys"}))
def test_the_emulated_modules_are_those_that_pybricks_documents(name):
    emulated, documented = firmware.modules()[name], import_module(name)
    for member in vars(emulated):
        ours, theirs = getattr(emulated, member), getattr(documented, member)
        for method in public_methods(ours):
            assert parameters(getattr(ours, method)) == parameters(getattr(theirs, method))


def public_methods(kind):
    members = inspect.getmembers(kind, inspect.isfunction)
    return [name for name, _ in members if not name.startswith("_")]


def parameters(function):
    signature = inspect.signature(function)
    return [(parameter.name, parameter.default) for parameter in signature.parameters.values()]
