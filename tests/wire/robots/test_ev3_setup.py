"""The agent is installed on a brick over SSH and runs there."""

import os
import signal
import sys

import msgspec
import paramiko
import pytest

from bricks import brick
from learnblock.devices import Base
from learnblock.errors import RobotConnectionError
from learnblock.i18n import Phrase
from learnblock.robots import connect, settings
from learnblock.robots.ev3 import Robot, Settings
from ports import free_port
from ssh_brick import SshBrick
from waiting import wait_for

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="a brick's shell is one of POSIX")

#: The brick's Python: this machine's, with the paths of the brick's devices.
PYTHON = """#!/bin/sh
exec {python} -I -S "$@" --sysfs {sysfs} --address 127.0.0.1
"""


@pytest.fixture
def emulation():
    """A brick whose own agent is not the one under test."""
    with brick("agent") as emulation:
        yield emulation


@pytest.fixture
def server(emulation, tmp_path):
    """Its SSH server; the agents that it starts are ended afterwards."""
    home = tmp_path / "robot"
    home.mkdir()
    python = emulation.brick.folder / "bin" / "python3"
    python.write_text(PYTHON.format(python=sys.executable, sysfs=emulation.brick.sysfs))
    python.chmod(0o755)
    with SshBrick(home, emulation.brick.environment) as server:
        yield server
    pid = home / ".learnblock-pid"
    if pid.exists():
        os.kill(int(pid.read_text()), signal.SIGKILL)


@pytest.fixture
def chosen(server):
    """The settings with which the brick is set up."""
    return Settings(
        address="127.0.0.1", ssh_port=server.port, agent_port=free_port(), connection="agent"
    )


def test_setup_installs_the_agent_and_a_program_reaches_it(server, chosen):
    steps = []
    Robot.set_up(chosen, steps.append)
    assert steps == [
        Phrase("ev3-setup-login", address="127.0.0.1", user="robot"),
        Phrase("ev3-setup-copy"),
        Phrase("ev3-setup-start"),
        Phrase("ev3-setup-done", file="learnblock-agent.py"),
    ]
    kept = settings.load("ev3", Settings)
    assert len(kept.token) == 32
    assert (server.home / ".learnblock-token").read_text() == kept.token
    assert (server.home / ".learnblock-token").stat().st_mode & 0o777 == 0o600
    assert (server.home / "learnblock-agent.py").stat().st_mode & 0o777 == 0o755
    with connect("ev3", agent_port=chosen.agent_port) as robot:
        assert robot.device(Base)
    assert kept.token not in " ".join(server.executed)


def test_setup_again_replaces_the_agent_and_keeps_the_secret(server, chosen):
    Robot.set_up(chosen, str)
    pid = (server.home / ".learnblock-pid").read_text()
    token = settings.load("ev3", Settings).token
    Robot.set_up(
        settings.load("ev3", Settings, {"ssh_port": server.port, "agent_port": chosen.agent_port}),
        str,
    )
    assert (server.home / ".learnblock-pid").read_text() != pid
    assert settings.load("ev3", Settings).token == token
    with connect("ev3", agent_port=chosen.agent_port) as robot:
        assert robot.device(Base)


def test_the_motors_stop_when_the_agent_is_ended(server, chosen, emulation):
    Robot.set_up(chosen, str)
    with connect("ev3", agent_port=chosen.agent_port) as robot:
        robot.device(Base).move(50, 0)
        motor = emulation.brick.tree.motors["B"]
        wait_for(lambda: motor.speed > 0, "it turns")
        os.kill(int((server.home / ".learnblock-pid").read_text()), signal.SIGTERM)
        wait_for(lambda: motor.speed == 0, "it stands")
        with pytest.raises(RobotConnectionError):
            robot.stop()


@pytest.mark.parametrize(
    ("wrong", "sentence"),
    [
        ({"password": "guess"}, "does not accept the password of 'robot'"),
        ({"user": "guest"}, "does not accept the password of 'guest'"),
        ({"ssh_port": 1}, "No EV3 answers at 127.0.0.1:1"),
    ],
)
def test_a_failed_login_is_reported(chosen, wrong, sentence):
    with pytest.raises(RobotConnectionError, match=sentence):
        Robot.set_up(msgspec.structs.replace(chosen, **wrong), str)


def test_another_brick_at_the_same_address_is_not_trusted(server, chosen):
    Robot.set_up(chosen, str)
    server.key = paramiko.RSAKey.generate(1024)
    with pytest.raises(RobotConnectionError, match="not the one that was set up before"):
        Robot.set_up(chosen, str)


def test_an_agent_that_does_not_start_is_reported_with_its_output(server, chosen, emulation):
    (emulation.brick.folder / "bin" / "python3").write_text("#!/bin/sh\necho no memory\nexit 1\n")
    with pytest.raises(RobotConnectionError, match="did not start on the EV3: no memory"):
        Robot.set_up(chosen, str)
