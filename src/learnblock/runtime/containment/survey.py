"""What contains programs on this computer: a test program tries to break out in several ways.

So does a thread without rights, as the driver of a robot that needs none.
"""

import platform
import socket
import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

from msgspec import Struct

from learnblock.client import Rights
from learnblock.i18n import Phrase
from learnblock.runtime.containment.driver import give_up, in_own_thread
from learnblock.runtime.limits import Limits
from learnblock.runtime.messages import Contained, Printed, Setup
from learnblock.runtime.process import ProcessWorker

#: Timeout in seconds for all attempts together.
TIMEOUT = 20.0

#: For each phrase code, an attempt that gets around the restrictions inside Python.
_ATTEMPTS = {
    "doctor-read": "os.listdir('/')",
    "doctor-write": "os.rmdir(tempfile.mkdtemp(dir=os.path.dirname(tempfile.gettempdir())))",
    "doctor-network": "socket.socket().close()",
    "doctor-processes": "fork()",
    "doctor-signals": "ctypes.CDLL(None).kill(os.getppid(), 0) and refused()",
    "doctor-memory": "check_memory()",
    "doctor-variables": "os.environ.get('HOME') == tempfile.gettempdir() and refused()",
}
#: The same for a driver.
_DRIVERS_ATTEMPTS: dict[str, Callable[[], object]] = {
    "doctor-driver-write": lambda: Path(tempfile.mkdtemp()).rmdir(),
    "doctor-driver-network": lambda: socket.socket().close(),
    "doctor-driver-processes": lambda: subprocess.run([sys.executable, "-ISc", ""], check=False),
}
_PROGRAM = """
import ctypes, os, socket, tempfile

def refused():
    raise PermissionError

def fork():
    process = ctypes.CDLL(None).fork()
    if process == 0:
        os._exit(0)
    if process < 0:
        refused()
    os.waitpid(process, 0)

def check_memory():
    import resource
    if resource.getrlimit(resource.RLIMIT_AS)[0] != resource.RLIM_INFINITY:
        refused()

for code, attempt in {attempts}.items():
    try:
        eval(attempt)
    except PermissionError:
        print(code)
    except Exception:
        pass
"""


_OF_LANDLOCK = frozenset({"doctor-read", "doctor-write", "doctor-driver-write"})


class AttemptResult(Struct, frozen=True):
    """The result of one attempt.

    Args:
        name: what was tried.
        contained: whether it was refused.
        reason: what refuses it, or why nothing does.
    """

    name: Phrase
    contained: bool
    reason: Phrase


def survey() -> tuple[AttemptResult, ...]:
    """Try out what contains programs on this computer."""
    refused = _refused() | in_own_thread(_refused_to_driver)
    return tuple(
        AttemptResult(Phrase(code), code in refused, _reason(code, contained=code in refused))
        for code in (*_ATTEMPTS, *_DRIVERS_ATTEMPTS)
    )


def _refused() -> frozenset[str]:
    worker = ProcessWorker()
    source = _PROGRAM.replace("{attempts}", repr(_ATTEMPTS))
    try:
        worker.link.send(Setup(source, "doctor.py", "", (), (), None, Limits()))
        printed = set()
        while isinstance(message := worker.link.receive(TIMEOUT), Contained | Printed):
            if isinstance(message, Printed):
                printed.update(message.text.split())
        return frozenset(printed)
    finally:
        worker.kill()


def _refused_to_driver() -> frozenset[str]:
    give_up(Rights())
    return frozenset(code for code, attempt in _DRIVERS_ATTEMPTS.items() if _is_refused(attempt))


def _is_refused(attempt: Callable[[], object]) -> bool:
    try:
        attempt()
    except PermissionError:
        return True
    except OSError:
        # Something else went wrong, such as a full disk.
        return False
    return False


def _reason(code: str, *, contained: bool) -> Phrase:
    if code == "doctor-variables":
        return Phrase("doctor-by-start")
    if code == "doctor-memory":
        return Phrase("doctor-by-limit" if contained else "doctor-no-limit")
    if sys.platform != "linux":
        by_nothing = code in _DRIVERS_ATTEMPTS
        other = "doctor-other-system-driver" if by_nothing else "doctor-other-system"
        return Phrase(other, system=platform.system())
    by = _landlock() if code in _OF_LANDLOCK else _seccomp()
    return by[0] if contained else by[1]


def _landlock() -> tuple[Phrase, Phrase]:
    from learnblock.runtime.containment import landlock  # noqa: PLC0415 - Linux only

    return (
        Phrase("doctor-by-landlock", version=landlock.version()),
        Phrase("doctor-no-landlock", kernel=platform.release()),
    )


def _seccomp() -> tuple[Phrase, Phrase]:
    return Phrase("doctor-by-seccomp"), Phrase("doctor-no-seccomp", machine=platform.machine())
