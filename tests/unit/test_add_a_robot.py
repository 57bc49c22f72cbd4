"""The guide to a custom robot: its code is run as it is in the guide."""

import asyncio
import os
import re
import subprocess
import sys
from types import SimpleNamespace

import pytest

from learnblock import robots
from learnblock.devices import Base, DistanceSensors, GroundSensors, Led
from learnblock.errors import RobotConnectionError, SettingsError
from learnblock.robots.event_loop import EventLoop
from places import ROOT
from runs import EXAMPLES, run_example
from waiting import wait_for

gpiozero = pytest.importorskip("gpiozero", reason="pip install gpiozero: the guide's robot has it")

pytestmark = [
    pytest.mark.realtime,
    # The guide's advice to access the pins differently, which measures distances better.
    pytest.mark.filterwarnings("ignore::gpiozero.PWMSoftwareFallback"),
    pytest.mark.filterwarnings("ignore::gpiozero.DistanceSensorNoEcho"),
    # gpiozero's DistanceSensor.close takes the trigger away from a measurement that still runs.
    pytest.mark.filterwarnings(
        r"ignore:Exception in thread .*\(fill\):pytest.PytestUnhandledThreadExceptionWarning"
    ),
]

GUIDE = (ROOT / "docs" / "add-a-robot.md").read_text(encoding="utf-8")


def code(name):
    """Return a file of the guide, whose parts follow one another."""
    parts = re.findall(rf"^```python title={re.escape(name)}\n(.*?)^```", GUIDE, re.M | re.S)
    return "".join(parts)


@pytest.fixture
def folder(own_home):
    (own_home / "robots").mkdir()
    (own_home / "robots" / "pi_rover.py").write_text(code("pi_rover.py"))
    return own_home


@pytest.fixture
def pins(monkeypatch):
    """The pins of a Raspberry Pi, with an object 0.5 m from its ultrasonic sensor."""
    from gpiozero.pins.mock import MockFactory, MockPWMPin, MockTriggerPin

    class SonarPin(MockTriggerPin, MockPWMPin):
        pass

    factory = MockFactory(pin_class=MockPWMPin)
    monkeypatch.setattr(gpiozero.Device, "pin_factory", factory)
    factory.pin("GPIO23", pin_class=SonarPin, echo_pin=factory.pin("GPIO24"), echo_time=0.003)
    yield factory
    factory.reset()


@pytest.fixture
def rover(folder, pins):
    with robots.connect("pi-rover") as rover:
        yield rover


def powers(pins):
    """Return the forward and backward power of the left and the right motor."""
    return tuple(round(pins.pin(f"GPIO{number}").state, 3) for number in (4, 14, 17, 18))


def test_the_whole_robot_has_as_many_lines_as_the_guide_says():
    assert f"in {len(code('pi_rover.py').splitlines())} lines" in GUIDE


def test_the_guides_example_of_a_driver_that_waits_prints_what_it_says(capsys):
    exec(code("check_repeating.py"), {})  # noqa: S102 - our own guide
    [said] = re.findall(r"print\(sent\)  # (.*)", code("check_repeating.py"))
    assert capsys.readouterr().out == f"{said}\n"


def test_the_guides_asynchronous_robot_is_told_and_tells_what_the_guide_says(own_home, capsys):
    (own_home / "robots").mkdir()
    (own_home / "robots" / "pi_ball.py").write_text(code("pi_ball.py"))
    exec(code("check_pi_ball.py"), {})  # noqa: S102 - our own guide
    said = re.findall(r"print\(.*\)  # (.*)", code("check_pi_ball.py"))
    assert capsys.readouterr().out.splitlines() == said


def test_a_contained_run_drives_the_guides_asynchronous_robot(own_home, tmp_path):
    (own_home / "robots").mkdir()
    (own_home / "robots" / "pi_ball.py").write_text(code("pi_ball.py"))
    program = tmp_path / "program.py"
    program.write_text(
        "from learnblock_home.robots.pi_ball import Robot\n\n"
        "robot = Robot()\n"
        "robot.move_straight(100)\n"
        "print(robot.get_min_distance())\n"
    )
    commands = []

    async def ball(reader, writer):
        writer.write(b"250\n")
        while line := await reader.readline():
            commands.append(line.decode().strip())
        writer.close()

    with EventLoop("the ball") as loop:
        server = loop.run(asyncio.start_server(ball, "127.0.0.1", 0), seconds=5)
        loop.enter(server, seconds=5)
        port = server.sockets[0].getsockname()[1]
        (own_home / "settings.toml").write_text(f"[robots.pi-ball]\nport = {port}\n")
        done = subprocess.run(
            [sys.executable, "-m", "learnblock", "run", program, "--robot=pi-ball", "--for=5"],
            capture_output=True,
            text=True,
            check=False,
        )
        wait_for(lambda: commands[-1:] == ["0 0"], "the ball is stopped")
    assert (done.returncode, done.stdout) == (0, "250.0\n"), done.stderr
    assert commands[0] == "100 0"


#: The environment that the guide advises without a Raspberry Pi.
ADVISED = dict(re.findall(r"`(GPIOZERO_\w+|PYTHONWARNINGS)=(\w+)`", GUIDE))


def test_the_guides_own_check_passes(folder, tmp_path):
    (tmp_path / "check_pi_rover.py").write_text(code("check_pi_rover.py"))
    environment = {**os.environ, "PYTHONWARNINGS": ADVISED["PYTHONWARNINGS"]}
    done = subprocess.run(
        [sys.executable, "check_pi_rover.py"],
        cwd=tmp_path,
        env=environment,
        capture_output=True,
        text=True,
        check=True,
    )
    assert done.stdout.startswith("pi_rover conforms\n")
    # A thread of gpiozero may still fail while it is closed, which is no warning.
    assert "warnings.warn" not in done.stderr


@pytest.mark.slow
def test_a_run_with_mock_pins_as_advised_prints_no_warning_of_gpiozero(folder):
    program = EXAMPLES / "first/there-and-back.bt"
    done = subprocess.run(
        [sys.executable, "-m", "learnblock", "run", program, "--robot=pi-rover", "--for=1"],
        env={**os.environ, **ADVISED},
        capture_output=True,
        text=True,
        check=True,
    )
    assert "ended" in done.stderr
    assert "warnings.warn" not in done.stderr


def test_it_is_in_the_list_with_its_devices(folder):
    found = robots.find("pi-rover")
    assert found.module == "learnblock_home.robots.pi_rover"
    assert "GroundSensors:ROBOT" in found.load().device_names()


@pytest.mark.parametrize(
    ("speed", "expected"),
    [
        ((150, 0), (0.5, 0, 0.5, 0)),
        ((-75, 0), (0, 0.25, 0, 0.25)),
        ((0, 90), (0.314, 0, 0, 0.314)),
        ((0, -90), (0, 0.314, 0.314, 0)),
        ((600, 0), (1, 0, 1, 0)),
        ((300, 45), (1, 0, 0.728, 0)),
    ],
)
def test_speeds_become_powers(rover, pins, speed, expected):
    rover.device(Base).move(*speed)
    assert powers(pins) == expected


def test_its_readings_are_in_our_units(rover, pins):
    pins.pin("GPIO5").drive_high()
    ground = rover.device(GroundSensors).read
    wait_for(lambda: ground() == {"left": 100, "central": None, "right": 0}, "the floor")
    distances = rover.device(DistanceSensors).read
    # The echo of these pins is more precise on an idle machine.
    wait_for(lambda: 0 < distances()["front"][0] < 2000, "a distance")
    rover._sonar = SimpleNamespace(distance=0.5)
    assert distances() == {"front": [500]}
    rover._sonar = SimpleNamespace(distance=0.0)
    assert distances() == {"front": [2000]}


def test_its_lamp_shines(rover, pins):
    rover.device(Led, "Front").set(True)
    assert pins.pin("GPIO12").state == 1


def test_without_pins_it_says_where_to_start_it(folder, monkeypatch):
    monkeypatch.setattr(gpiozero.Device, "pin_factory", None)
    # One that this computer lacks.
    monkeypatch.setenv("GPIOZERO_PIN_FACTORY", "nothing")
    with pytest.raises(RobotConnectionError, match=r"has no pins .* Raspberry Pi"):
        robots.connect("pi-rover")


def test_a_second_one_is_refused_with_a_sentence(rover):
    with pytest.raises(RobotConnectionError, match=r"The rover's pins can't be used .* in use"):
        robots.connect("pi-rover")


def test_an_invalid_setting_is_refused_by_name(folder, pins):
    with pytest.raises(SettingsError, match=r"'lamp' is 40.* from 2 to 27"):
        robots.connect("pi-rover", lamp=40)


def test_it_runs_an_example_and_stops_afterwards(folder, pins):
    finished = run_example("polygons.bt", "pi-rover", seconds=1)
    assert finished.report.ended == "time limit"
    assert powers(pins) == (0, 0, 0, 0)
