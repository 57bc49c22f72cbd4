"""A Thymio in Aseba's own simulator, the playground, with one of our worlds in it.

Not our simulator: the playground runs the robot's true virtual machine and has physics of its own.
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
from learnblock.errors import MissingPackageError
from learnblock.robots.simulated import find_world
from learnblock.simulator import WorldDescription, load_robot
from learnblock.simulator.geometry import Pose

PROGRAM = "asebaplayground"
#: Seconds within which it listens.
STARTING = 20.0
#: Seconds in which it ends when asked to.
ENDING = 2.0


class Emulator:
    """A playground that runs until it is closed; its window is shown where there is a screen.

    It listens in the whole network, and serves one client at a time: a new one is taken, and the
    one before is left.

    Args:
        world: a world's name or the path of its file; by default that of the twin.
        start: (x mm, y mm, heading in degrees) of the robot; by default the world's own.
        port: where the robot listens; by default a free one.

    Attributes:
        world: the world as described.
        settings: those with which a client reaches the robot.

    Raises:
        MissingPackageError: the playground is not installed.
        LearnBlockError: there is no such world.
        OSError: it cannot listen there.
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
        self._process = subprocess.Popen(  # noqa: S603 - the playground, and a file of ours
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
        """End the playground; the second time it does nothing."""
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
                raise OSError(f"the playground ended at once; is the port {port} free?")
            if monotonic() > until:
                raise OSError(f"the playground does not listen at {port} after {STARTING:g} s")
            sleep(0.05)


def _program() -> str:
    program = shutil.which(PROGRAM)
    if program is None:
        raise MissingPackageError(
            f"a Thymio is emulated by Aseba's playground, and `{PROGRAM}` is not installed:"
            " apt-get install aseba (or see https://www.thymio.org for other systems)"
        )
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
    """The playground keeps its files in `folder`, and shows no window where there is no screen."""
    environment = {**os.environ, "XDG_DATA_HOME": folder, "XDG_CONFIG_HOME": folder}
    screenless = sys.platform == "linux" and not {"DISPLAY", "WAYLAND_DISPLAY"} & set(os.environ)
    if screenless:
        environment.setdefault("QT_QPA_PLATFORM", "offscreen")
    return environment


def _listens(port: int) -> bool:
    """Whether it does; it has also forgotten us again, since it mixes up clients in a hurry."""
    with suppress(OSError), socket.create_connection(("127.0.0.1", port), timeout=ENDING) as probe:
        probe.shutdown(socket.SHUT_WR)
        return probe.recv(1) == b""
    return False
