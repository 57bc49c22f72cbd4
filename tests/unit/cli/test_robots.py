"""Real robots on the command line: settings, search, trial, and emulators."""

import json
import subprocess
from contextlib import contextmanager, nullcontext
from types import SimpleNamespace

import pytest
from click.testing import CliRunner

from learnblock.cli import main
from learnblock.robots import find

#: A user's robot, with fake wheels and sensors, and real settings.
MINE = """
from learnblock.devices import Base, Display, DistanceSensors
from learnblock.robots.real import RealRobot
from learnblock.robots.settings import Address, Port, RobotSettings
from learnblock.testing import VirtualClock, Wheels


class Settings(RobotSettings, frozen=True):
    address: Address = "10.0.0.1"
    port: Port = 4000


class Robot(RealRobot[Settings]):
    settings_type = Settings

    def __init__(self, **chosen):
        super().__init__(clock=VirtualClock(), **chosen)

    @classmethod
    def scan(cls, seconds):
        yield {"address": "10.0.0.7", "port": 4001}

    def connect(self):
        wheels = Wheels(self.clock)
        self.add(Base(wheels.move, lambda: wheels.pose))
        self.add(DistanceSensors(lambda: {"front": [self.settings.port]}))
        self.add(Display(lambda emotion: None))
"""


@pytest.fixture(autouse=True)
def home(tmp_path, monkeypatch):
    monkeypatch.setenv("LEARNBLOCK_HOME", str(tmp_path))
    (tmp_path / "robots").mkdir()
    (tmp_path / "robots" / "mine.py").write_text(MINE)
    return tmp_path


def call(*arguments, **options):
    return CliRunner().invoke(main, ["robots", *arguments], **options)


def test_the_settings_of_a_robot_are_listed_with_their_allowed_values():
    listed = call("set", "mine").output
    assert "address" in listed
    assert "a whole number from 1 to 65535 (network port)" in listed


def test_a_setting_is_changed_for_all_later_programs():
    assert call("set", "mine", "port", "4002").exit_code == 0
    with find("mine").load()() as robot:
        assert robot.settings.port == 4002
    assert "[default: 4000]" in call("set", "mine").output
    assert call("set", "mine", "port", "--default").exit_code == 0
    assert json.loads(call("set", "mine", "port", "--json").output)[0]["value"] == 4000


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (
            ("set", "mine", "port", "many"),
            "'port' is \"many\", but must be a whole number from 1 to",
        ),
        (("set", "mine", "prot", "1"), "Did you mean 'port'?"),
        (("set", "mine", "--default"), "--default takes the name of a setting"),
        (("set", "mine", "port", "1", "--default"), "without a value."),
        (("set", "mine", "prot"), "Did you mean 'port'?"),
        (("set", "sim-ebo"), "The robot 'sim-ebo' has no settings: it is simulated."),
        (("set", "mien"), "Did you mean 'mine'?"),
        (("setup", "mine"), "The robot 'mine' needs no setup."),
        (("test", "mien"), "Did you mean 'mine'?"),
    ],
)
def test_an_invalid_argument_is_refused_with_a_message(arguments, sentence):
    result = call(*arguments)
    assert result.exit_code != 0
    assert sentence in result.output
    assert "Traceback" not in result.output


def test_robots_that_answer_are_listed_with_the_settings_to_reach_them():
    assert "mine         address=10.0.0.7  port=4001" in call("scan", "mine").output
    assert json.loads(call("scan", "mine", "--json").output) == [
        {"robot": "mine", "settings": {"address": "10.0.0.7", "port": 4001}}
    ]


def test_a_test_of_a_robot_reports_what_works():
    result = call("test", "mine", input="n\ny\ny\n")
    assert result.exit_code == 1
    assert "works     DistanceSensors:ROBOT    {'front': [4000]}" in result.output
    assert "FAILS     Display:ROBOT            not seen" in result.output
    assert "odometry: 50 mm, 45°" in result.output


def test_a_test_of_a_robot_does_not_drive_without_permission():
    result = call("test", "mine", input="y\nn\n")
    assert result.exit_code == 0
    assert "skipped   Base:ROBOT               not driven" in result.output


def test_a_test_of_a_robot_can_skip_the_questions():
    result = call("test", "mine", "--yes")
    assert result.exit_code == 0
    assert "?" not in result.output


LACKING = """
from learnblock.robots.real import RealRobot
from learnblock.robots.settings import RobotSettings


class Robot(RealRobot[RobotSettings]):
    settings_type = RobotSettings
    add_on = ("no_such_module",)
"""


def test_the_other_robots_are_searched_for_without_an_add_on(home, monkeypatch):
    monkeypatch.setattr("learnblock.robots._OURS", ())
    (home / "robots" / "thymio.py").write_text(LACKING)
    found = call("scan", "--seconds", "0.1").output.splitlines()

    assert found[0].split() == ["mine", "address=10.0.0.7", "port=4001"]
    assert found[1].startswith("thymio       needs an add-on that is not installed: ")
    assert "thymiodirect" in found[1] or "--extra thymio" in found[1] or "[thymio]" in found[1]


def test_the_list_says_first_that_a_robot_needs_an_add_on(home):
    (home / "robots" / "other.py").write_text(LACKING)
    listed = call().output.splitlines()

    row = next(one for one in listed if one.startswith("other "))

    assert row.split(maxsplit=1)[1].startswith("needs an add-on")


def test_the_commands_of_an_emulation_can_be_pasted_into_a_shell(monkeypatch):
    settings = {"laser_ports": [10102, 10103], "name": "my robot", "token": "", "port": 5551}

    @contextmanager
    def emulate(*_args, **_options):
        yield SimpleNamespace(settings=settings, note=None)

    monkeypatch.setattr("learnblock.emulators.emulate", emulate)
    monkeypatch.setattr("learnblock.cli.interrupts.served_until_ctrl_c", nullcontext)
    printed = CliRunner().invoke(main, ["emulate", "rcis"]).output.splitlines()
    lines = [one for one in printed if one.startswith("    ")]
    words = [pasted(line) for line in lines]

    assert [one[:4] for one in words[:-1]] == [["learnblock", "robots", "set", "rcis"]] * 4
    assert [one[4:] for one in words[:-1]] == [
        ["laser_ports", "[10102, 10103]"],
        ["name", "my robot"],
        ["token", ""],
        ["port", "5551"],
    ]
    assert words[-1] == ["learnblock", "run", "PROGRAM", "--robot", "rcis"]


def pasted(line):
    """The words that a shell makes of a line."""
    shown = 'for word in "$@"; do printf "%s\\n" "$word"; done'
    script = f"set -- {line}; {shown}"
    done = subprocess.run(["sh", "-c", script], stdout=subprocess.PIPE, text=True, check=True)
    return done.stdout.split("\n")[:-1]


def test_a_real_robot_reports_where_its_odometry_has_it(home):
    with find("mine").load()() as robot:
        robot.move_straight(100)
        robot.sleep(2)

    assert robot.outcome().pose == pytest.approx((200, 0, 0))
    assert robot.outcome().distance is None
