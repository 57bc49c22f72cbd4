"""Installs LearnBlock's agent on a brick with ev3dev, over SSH."""

import secrets
import shlex
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from importlib import resources
from typing import Any

from learnblock.errors import RobotConnectionError
from learnblock.i18n import Phrase
from learnblock.robots import settings as user_settings
from learnblock.robots.ev3.network import dial
from learnblock.robots.ev3.settings import Settings
from learnblock.robots.real import require
from learnblock.storage.home import home

#: The files in the user's folder on the brick: a visible one in its file browser, and hidden ones.
AGENT, TOKEN = "learnblock-agent.py", ".learnblock-token"
LOG, PID = ".learnblock-log", ".learnblock-pid"
#: Seconds within which the brick must accept the login and run a command; its processor is slow.
TIMEOUT = 30.0
#: Ends an agent that is already running; its old process id may belong to another process now.
END = """
agent=$(cat {pid} 2> /dev/null)
if [ -n "$agent" ] && grep -q {agent} "/proc/$agent/cmdline" 2> /dev/null; then
    kill "$agent"
    while [ -d "/proc/$agent" ]; do sleep 0.1; done
fi
"""
#: Starts the agent so that it outlives the login, and waits until it listens.
START = """
: > {log}
nohup ./{agent} --port {port} >> {log} 2>&1 < /dev/null &
while kill -0 $! 2> /dev/null; do
    if grep -q listening {log}; then exit 0; fi
    sleep 0.1
done
cat {log}
exit 1
"""


def set_up(settings: Settings, report: Callable[[Phrase], object]) -> None:
    """Copy the agent to the brick, start it, and store the secret that it shares with us.

    Args:
        settings: the robot's settings.
        report: called with each step.

    Raises:
        MissingPackageError: paramiko is not installed on this computer.
        RobotConnectionError: the brick cannot be reached, or the agent does not start.
    """
    report(Phrase("ev3-setup-login", address=settings.address, user=settings.user))
    with _logged_in(settings) as client:
        token = settings.token or secrets.token_hex(16)
        report(Phrase("ev3-setup-copy"))
        _put(client, token)
        report(Phrase("ev3-setup-start"))
        names = {"agent": AGENT, "log": LOG, "pid": PID, "port": settings.agent_port}
        _execute(client, END.format(**names))
        _execute(client, START.format(**names))
    for name, value in (("token", token), ("address", settings.address)):
        user_settings.change("ev3", Settings, name, value)
    report(Phrase("ev3-setup-done", file=AGENT))


@contextmanager
def _logged_in(settings: Settings) -> Iterator[Any]:
    paramiko = require("paramiko", "ev3")
    place = f"{settings.address}:{settings.ssh_port}"
    client = paramiko.SSHClient()
    host_keys = home() / "ev3-known-hosts"
    host_keys.parent.mkdir(parents=True, exist_ok=True)
    host_keys.touch()
    # The first brick that answers is trusted, and must have the same key from then on.
    client.load_host_keys(str(host_keys))
    client.set_missing_host_key_policy(paramiko.AutoAddPolicy())
    try:
        client.connect(
            settings.address,
            settings.ssh_port,
            settings.user,
            settings.password,
            sock=dial(settings.address, settings.ssh_port, settings.patience),
            timeout=TIMEOUT,
            banner_timeout=TIMEOUT,
            auth_timeout=TIMEOUT,
            # Keys of other computers must not be offered to a brick.
            allow_agent=False,
            look_for_keys=False,
        )
        yield client
    except paramiko.BadHostKeyException as error:
        raise RobotConnectionError(
            "ev3-setup-other-brick", place=place, file=str(host_keys)
        ) from error
    except paramiko.AuthenticationException as error:
        raise RobotConnectionError("ev3-setup-no-login", place=place, user=settings.user) from error
    except (paramiko.SSHException, OSError, EOFError) as error:
        if isinstance(error, RobotConnectionError):
            raise
        raise RobotConnectionError("ev3-setup-broke", place=place, reason=str(error)) from error
    finally:
        client.close()


def _put(client: Any, token: str) -> None:
    agent = resources.files("learnblock.robots.ev3").joinpath("agent.py").read_bytes()
    with client.open_sftp() as files:
        _write(files, TOKEN, token.encode(), mode=0o600)
        _write(files, AGENT, agent, mode=0o755)


def _write(files: Any, name: str, data: bytes, *, mode: int) -> None:
    with files.open(name, "wb") as file:
        # Before the secret is in it.
        file.chmod(mode)
        file.write(data)


def _execute(client: Any, script: str) -> None:
    """Run a script on the brick.

    Raises:
        RobotConnectionError: it fails; the error contains its output.
    """
    _, out, _ = client.exec_command(f"sh -c {shlex.quote(script)}", timeout=TIMEOUT)
    output = out.read().decode("utf-8", "replace").strip()
    if out.channel.recv_exit_status():
        raise RobotConnectionError("ev3-setup-not-started", output=output[-500:])
