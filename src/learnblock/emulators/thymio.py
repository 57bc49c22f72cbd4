"""Emulates a Thymio with Aseba's simulator, the playground, in one of our worlds.

The playground runs the robot's real virtual machine, and has its own physics.
"""

import os
import shutil
import socket
import subprocess
import sys
import tempfile
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from time import monotonic, sleep
from typing import Any

from learnblock.emulators.playground import write_scene
from learnblock.errors import EmulatorError, MissingPackageError
from learnblock.robots.simulated import find_world
from learnblock.simulator import WorldDescription, load_robot
from learnblock.simulator.geometry import Pose

PROGRAM = "asebaplayground"
#: The maximum number of seconds until it listens.
STARTING = 20.0
#: The maximum number of seconds until it ends after SIGTERM.
ENDING = 2.0


class Emulator:
    """A playground that runs until it is closed; it opens a window if there is a screen.

    It listens on all network interfaces and serves one client at a time: a new client replaces the
    previous one.

    Args:
        world: a world's name or the path of its file; by default the twin's world.
        start: (x mm, y mm, heading in degrees) of the robot; by default the world's start pose.
        port: the robot's port; by default a free one.

    Attributes:
        world: the world's description.
        settings: the settings with which a client reaches the robot.

    Raises:
        MissingPackageError: the playground is not installed.
        LearnBlockError: there is no such world, or the playground does not start.
    """

    def __init__(
        self,
        world: str | None = None,
        *,
        start: tuple[float, float, float] | None = None,
        port: int | None = None,
    ) -> None:
        program = _program()
        self.world = find_world(world or load_robot("thymio").world)
        port = port or _free_port()
        self.settings: Mapping[str, Any] = {
            "connection": "tcp",
            "address": "127.0.0.1",
            "port": port,
        }
        self._folder = tempfile.TemporaryDirectory(prefix="learnblock-thymio-")
        place = Pose(*start) if start else _start(self.world)
        scene = write_scene(self.world, Path(self._folder.name), port, place)
        self._process = subprocess.Popen(  # noqa: S603 - the playground, and our own file
            [program, str(scene)],
            env=_environment(self._folder.name),
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        try:
            self._wait_for(port)
        except BaseException:
            self.close()
            raise

    def close(self) -> None:
        """End the playground; calling it twice is harmless."""
        self._process.terminate()
        try:
            self._process.wait(ENDING)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        self._folder.cleanup()

    def _wait_for(self, port: int) -> None:
        until = monotonic() + STARTING
        while not _listens(port):
            if self._process.poll() is not None:
                raise EmulatorError("emulator-playground-ended", port=str(port))
            if monotonic() > until:
                raise EmulatorError("emulator-playground-silent", port=str(port), seconds=STARTING)
            sleep(0.05)


def _program() -> str:
    program = shutil.which(PROGRAM)
    if program is None:
        raise MissingPackageError("emulator-no-playground", program=PROGRAM)
    return program


def _start(world: WorldDescription) -> Pose:
    if not world.start:
        return Pose(0.0, 0.0, 0.0)
    return Pose(world.start[0].x, world.start[0].y, world.start[0].heading)


def _free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port: int = probe.getsockname()[1]
    return port


def _environment(folder: str) -> dict[str, str]:
    """The environment: files go to `folder`, and without a screen there is no window."""
    environment = {**os.environ, "XDG_DATA_HOME": folder, "XDG_CONFIG_HOME": folder}
    screenless = sys.platform == "linux" and not {"DISPLAY", "WAYLAND_DISPLAY"} & set(os.environ)
    if screenless:
        environment.setdefault("QT_QPA_PLATFORM", "offscreen")
    return environment


def _listens(port: int) -> bool:
    """Whether it listens; waits until our connection is closed: it mixes up quick clients."""
    with suppress(OSError), socket.create_connection(("127.0.0.1", port), timeout=ENDING) as probe:
        probe.shutdown(socket.SHUT_WR)
        return probe.recv(1) == b""
    return False
