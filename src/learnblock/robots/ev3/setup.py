"""Putting our agent on a brick with ev3dev, by SSH."""

import secrets
import shlex
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from importlib import resources
from typing import Any

from learnblock.errors import RobotConnectionError
from learnblock.home import home
from learnblock.robots import settings as user_settings
from learnblock.robots.ev3.brick import NoSuchWayError
from learnblock.robots.ev3.network import dial
from learnblock.robots.ev3.settings import Settings
from learnblock.robots.real import require

#: What is put into the user's folder on the brick: a name that its file browser shows, and some
#: that it hides.
AGENT, TOKEN = "learnblock-agent.py", ".learnblock-token"
LOG, PID = ".learnblock-log", ".learnblock-pid"
#: Seconds in which the brick must log us in and do what it is told; its processor is slow.
PATIENCE = 30.0
#: Ends the agent that runs already; by now its number may be another process's.
END = """
agent=$(cat {pid} 2> /dev/null)
if [ -n "$agent" ] && grep -q {agent} "/proc/$agent/cmdline" 2> /dev/null; then
    kill "$agent"
    while [ -d "/proc/$agent" ]; do sleep 0.1; done
fi
"""
#: Starts it so that it stays when we log out, and waits until it listens.
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


def set_up(settings: Settings, tell: Callable[[str], object]) -> None:
    """Put the agent on the brick and start it, and keep the secret that it shares with us.

    Args:
        settings: of the robot.
        tell: is told what is being done.

    Raises:
        MissingPackageError: paramiko is not installed here.
        RobotConnectionError: the brick cannot be reached, or does not do it.
    """
    tell(f"logging in to {settings.address} as {settings.user}")
    with _logged_in(settings) as client:
        token = settings.token or secrets.token_hex(16)
        tell("putting LearnBlock's agent there")
        _put(client, token)
        tell("starting it")
        names = {"agent": AGENT, "log": LOG, "pid": PID, "port": settings.agent_port}
        _execute(client, END.format(**names))
        _execute(client, START.format(**names))
    for name, value in (("token", token), ("address", settings.address)):
        user_settings.change("ev3", Settings, name, value)
    tell(
        f"the agent runs, and programs for the robot `ev3` reach it. After the brick was switched"
        f" off, choose {AGENT} in its file browser, or do this again"
    )


@contextmanager
def _logged_in(settings: Settings) -> Iterator[Any]:
    paramiko = require("paramiko", "ev3")
    where = f"{settings.address}:{settings.ssh_port}"
    client = paramiko.SSHClient()
    known = home() / "ev3-known-hosts"
    known.parent.mkdir(parents=True, exist_ok=True)
    known.touch()
    # Who answers the first time is trusted, and from then on has to be the same.
    client.load_host_keys(str(known))
    client.set_missing_host_key_policy(paramiko.AutoAddPolicy())
    try:
        client.connect(
            settings.address,
            settings.ssh_port,
            settings.user,
            settings.password,
            sock=dial(settings.address, settings.ssh_port, settings.patience),
            timeout=PATIENCE,
            banner_timeout=PATIENCE,
            auth_timeout=PATIENCE,
            # A brick is no place for the keys of other machines.
            allow_agent=False,
            look_for_keys=False,
        )
        yield client
    except NoSuchWayError as error:
        raise RobotConnectionError(
            f"no brick with ev3dev is found at {where}: is it switched on, and this computer in"
            f" its network? ({error})"
        ) from error
    except paramiko.BadHostKeyException as error:
        raise RobotConnectionError(
            f"at {where} is another brick than before, or one that was installed anew: if that is"
            f" so, delete its line in {known}"
        ) from error
    except paramiko.AuthenticationException as error:
        raise RobotConnectionError(
            f"the brick at {where} does not let `{settings.user}` in with that password: see"
            " learnblock robots set ev3"
        ) from error
    except (paramiko.SSHException, OSError, EOFError) as error:
        if isinstance(error, RobotConnectionError):
            raise
        raise RobotConnectionError(f"the brick at {where} broke off: {error}") from error
    finally:
        client.close()


def _put(client: Any, token: str) -> None:
    agent = resources.files("learnblock.robots.ev3").joinpath("agent.py").read_bytes()
    with client.open_sftp() as files:
        _write(files, TOKEN, token.encode(), mode=0o600)
        _write(files, AGENT, agent, mode=0o755)


def _write(files: Any, name: str, data: bytes, *, mode: int) -> None:
    with files.open(name, "wb") as file:
        # Before there is anything to see in it.
        file.chmod(mode)
        file.write(data)


def _execute(client: Any, script: str) -> None:
    """Have the brick do something.

    Raises:
        RobotConnectionError: it fails; with what was printed.
    """
    _, out, _ = client.exec_command(f"sh -c {shlex.quote(script)}", timeout=PATIENCE)
    said = out.read().decode("utf-8", "replace").strip()
    if out.channel.recv_exit_status():
        raise RobotConnectionError(f"the agent does not start on the brick: {said[-500:]}")
