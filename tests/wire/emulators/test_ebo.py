"""EBO's end of the wire."""

import math
import threading
from contextlib import nullcontext

import pytest
from click.testing import CliRunner

from learnblock import cli
from learnblock.emulators import emulate
from learnblock.emulators.ebo import Emulator
from learnblock.emulators.ebo_camera import Broker
from learnblock.emulators.twin import Twin
from learnblock.errors import IceRefusedError, LearnBlockError
from learnblock.i18n import Phrase
from learnblock.ice import Proxy
from learnblock.ice.robocomp import BaseState, Layout, MotorGoalPosition, MotorState, interfaces
from twins import let_pass, pose

PORTS = {
    "differentialrobot": "base_port",
    "laser": "laser_port",
    "jointmotor": "joint_port",
    "emotionalmotor": "face_port",
}


@pytest.fixture
def emulation(monkeypatch):
    """An EBO on a machine without a broker."""
    monkeypatch.setattr("learnblock.emulators.ebo.find_broker", lambda: None)
    with emulate("ebo", "empty") as emulation:
        yield emulation


@pytest.fixture
def ask(emulation):
    """Call one of its components as a separate client."""

    def ask(identity, *call, layout=Layout.ROBOT):
        text = f"{identity}:tcp -h 127.0.0.1 -p {emulation.settings[PORTS[identity]]}"
        with Proxy.parse(text, interfaces(layout)[identity]) as proxy:
            return proxy.call(*call)

    return ask


def test_it_keeps_driving_without_its_client_like_the_real_one(emulation, ask):
    ask("differentialrobot", "setSpeedBase", 100.0, math.pi / 2)
    _, _, heading = pose(emulation.twin)
    let_pass(emulation.twin, 0.7)
    assert pose(emulation.twin)[2] > heading + 40


def test_it_knows_neither_its_pose_nor_the_angle_of_its_head(ask):
    ask("jointmotor", "setPosition", MotorGoalPosition("servo", 0.5))
    assert ask("differentialrobot", "getBaseState") == BaseState()
    assert ask("differentialrobot", "getBasePose") == (0, 0, 0)
    assert ask("jointmotor", "getMotorState", "servo") == MotorState()


def test_its_lasers_are_numbered_from_left_to_right(ask):
    readings = ask("laser", "getLaserData")
    assert [one.angle for one in readings] == [0, 1, 2, 3, 4]
    assert all(0 < one.dist <= 2000 for one in readings)


def test_an_unknown_joint_is_rejected(ask):
    with pytest.raises(IceRefusedError, match="arm") as caught:
        ask("jointmotor", "setPosition", MotorGoalPosition("arm", 0.5))
    assert caught.value.kind == "::RoboCompJointMotor::UnknownMotorException"


def test_a_goal_in_another_order_is_refused(ask):
    with pytest.raises(IceRefusedError, match="MarshalException"):
        ask("jointmotor", "setPosition", MotorGoalPosition("servo", 0.5), layout=Layout.TOOL)


def test_its_face_shows_emotions_and_talks(emulation, ask):
    ask("emotionalmotor", "expressFear")
    ask("emotionalmotor", "talking", True)
    with emulation.twin.body() as body:
        assert body.emotion == "fear"
        assert [entry[1:] for entry in body.log] == [("Display", "talking", (True,))]


def test_without_a_broker_it_has_no_camera_and_explains_why(emulation, monkeypatch):
    assert emulation.settings["camera_port"] == 0
    monkeypatch.setattr("learnblock.cli.interrupts.served_until_ctrl_c", nullcontext)
    said = CliRunner().invoke(cli.main, ["emulate", "ebo"]).output
    assert "learnblock robots set ebo camera_port 0" in said
    assert str(Phrase("emulator-no-camera")) in said


def test_a_broker_that_does_not_start_is_reported():
    with pytest.raises(LearnBlockError, match="The mosquitto broker did not start at"):
        Broker("/bin/true")


def test_a_failed_start_closes_everything_that_was_opened(monkeypatch):
    def fail(*_):
        raise LearnBlockError("no broker today")

    monkeypatch.setattr("learnblock.emulators.ebo.Broker", fail)
    monkeypatch.setattr("learnblock.emulators.ebo.find_broker", lambda: "/bin/true")
    with Twin("sim-ebo") as twin, pytest.raises(LearnBlockError, match="no broker today"):
        Emulator(twin)
    assert not [one for one in threading.enumerate() if one.name == "ice"]
