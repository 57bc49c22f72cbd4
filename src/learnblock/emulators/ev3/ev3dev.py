"""Emulates a brick with ev3dev: the kernel's files, and the processes that use them."""

import os
import subprocess
import sys
import tempfile
import threading
from pathlib import Path
from typing import Any

from learnblock.emulators.ev3.sysfs import Tree
from learnblock.emulators.vehicle import Vehicle
from learnblock.errors import EmulatorError

#: Seconds between two checks of the files; the kernel's own loop takes 2 ms.
PERIOD = 0.004
#: The maximum number of seconds until a process listens.
TIMEOUT = 20.0
#: rpyc's classic server, with python-ev3dev2 using our files. The kernel takes each write as the
#: whole value; an ordinary file keeps the rest of a longer value, so that each value ends its line.
RPYC = """
import io, sys, types
import ev3dev2
from rpyc.core.service import SlaveService
from rpyc.utils.server import ThreadedServer

class Attribute(io.FileIO):
    def write(self, value):
        return super().write(bytes(value) + b"\\n")

ev3dev2.io = types.SimpleNamespace(FileIO=Attribute)
ev3dev2.Device.DEVICE_ROOT_PATH = sys.argv[1]
server = ThreadedServer(SlaveService, hostname=sys.argv[2], port=int(sys.argv[3]))
server._listen()
print("listening at port", server.port, flush=True)
server.start()
"""
#: Replaces the brick's programs for sounds and speech; it records their arguments.
SOUNDS = """#!/bin/sh
echo "$(basename "$0")" "$@" >> "$(dirname "$0")/../sounds"
"""


class Ev3dev:
    """An emulated brick: its files in a temporary folder, and a thread that executes commands.

    Args:
        vehicle: the robot that it drives.
    """

    def __init__(self, vehicle: Vehicle) -> None:
        self._vehicle = vehicle
        self._folder = tempfile.TemporaryDirectory(prefix="learnblock-ev3-")
        self.folder = Path(self._folder.name)
        self.sysfs = self.folder / "class"
        self.tree = Tree(self.sysfs, vehicle)
        self._sounds = self.folder / "sounds"
        self._sounds.touch()
        self._make_programs()
        self._heard = 0
        self._processes: list[subprocess.Popen[str]] = []
        self._closed = threading.Event()
        self._thread = threading.Thread(target=self._live, name="ev3dev", daemon=True)
        self._thread.start()

    @property
    def environment(self) -> dict[str, str]:
        """The environment of the brick's processes."""
        path = os.pathsep.join([str(self.folder / "bin"), os.environ.get("PATH", "")])
        return {**os.environ, "PATH": path, "TMPDIR": str(self.folder), "FAKE_SYS": "1"}

    def start(self, *command: str) -> int:
        """Start a process of the brick, and return the port on which it listens.

        Raises:
            EmulatorError: it does not listen.
        """
        process = subprocess.Popen(  # noqa: S603 - our own Python
            [sys.executable, *command],
            env=self.environment,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            text=True,
        )
        self._processes.append(process)
        return _port(process)

    def close(self) -> None:
        """End the processes, and remove the files."""
        for process in self._processes:
            process.terminate()
        for process in self._processes:
            _end(process)
        self._closed.set()
        self._thread.join()
        self.tree.close()
        self._folder.cleanup()

    def _make_programs(self) -> None:
        programs = self.folder / "bin"
        programs.mkdir()
        for name in ("beep", "espeak", "aplay"):
            (programs / name).write_text(SOUNDS)
            (programs / name).chmod(0o755)

    def _live(self) -> None:
        while not self._closed.wait(PERIOD):
            self.tree.turn()
            self._listen()

    def _listen(self) -> None:
        """Record the sounds and the speech since the last call."""
        if self._sounds.stat().st_size == self._heard:
            return
        lines = self._sounds.read_text("utf-8", "replace")[self._heard :].splitlines()
        self._heard = self._sounds.stat().st_size
        for line in lines:
            program, *arguments = line.split()
            if program == "beep":
                self._vehicle.note("tone", float(arguments[1]), float(arguments[3]))
            elif program == "espeak":
                self._vehicle.note("say", " ".join(arguments[arguments.index("--") + 1 :]))


def _port(process: subprocess.Popen[str]) -> int:
    """The port in the output of a process."""
    assert process.stdout  # noqa: S101 - opened as a pipe
    # A process that hangs is killed, which ends `readline`.
    limit = threading.Timer(TIMEOUT, process.kill)
    limit.start()
    try:
        line = process.stdout.readline()
    finally:
        limit.cancel()
    if not line.startswith("listening at port "):
        raise EmulatorError("emulator-brick-silent")
    return int(line.rsplit(maxsplit=1)[1])


def _end(process: subprocess.Popen[Any]) -> None:
    try:
        process.wait(2)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()
    if process.stdout:
        process.stdout.close()
