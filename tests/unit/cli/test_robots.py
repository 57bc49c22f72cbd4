"""Real robots on the command line: settings, search, trial, and emulators."""

import json

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
