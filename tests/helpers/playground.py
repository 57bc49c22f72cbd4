"""Aseba's playground in tests, where D-Bus observes and moves its Thymio."""

import os
import re
import shutil
import subprocess
import tempfile
import threading
from contextlib import contextmanager
from pathlib import Path
from time import monotonic
from unittest.mock import patch

import pytest

from learnblock.emulators import thymio
from learnblock.emulators.playground import place, pose
from waiting import wait_for

#: The Debian package of each program that is needed.
PACKAGES = {
    "asebaplayground": "aseba",
    "dbus-daemon": "dbus-daemon",
    "gdbus": "libglib2.0-bin",
}
BUS = """<busconfig><type>session</type><listen>unix:tmpdir=/tmp</listen><auth>EXTERNAL</auth>
<policy context="default"><allow send_destination="*" eavesdrop="true"/>
<allow eavesdrop="true"/><allow own="*"/></policy></busconfig>"""
SERVICE = ("--session", "--dest", "ch.epfl.mobots.AsebaPlayground", "--object-path")
PROPERTIES = "org.freedesktop.DBus.Properties"
OBJECT = "ch.epfl.mobots.EnkiPhysicalObject"
NUMBER = r"<(-?[\d.e+-]+)>"


def missing():
    """Return installation instructions for the missing programs; empty if none is missing."""
    packages = [package for name, package in PACKAGES.items() if shutil.which(name) is None]
    return f"apt-get install {' '.join(packages)}" if packages else ""


class Playground(thymio.Emulator):
    """A playground whose robot can be seen, lifted and touched."""

    def __init__(self, world, **place):
        if missing():
            pytest.skip(missing())
        self._files = tempfile.TemporaryDirectory(prefix="bus-")
        self._bus, address = begin_bus(Path(self._files.name))
        self._environment = {**os.environ, "DBUS_SESSION_BUS_ADDRESS": address}
        with patch.dict(os.environ, self._environment, QT_QPA_PLATFORM="offscreen"):
            super().__init__(world, **place)
        robot = self._call("/world", "ch.epfl.mobots.EnkiWorld.PhysicalObjectsByType", "Thymio2")
        number = re.search(r"'(\w+)'", robot).group(1)
        self._robot = f"/world/objects/{number}"
        self._call("/world", "ch.epfl.mobots.EnkiWorld.PhysicalObject", number)

    def close(self):
        super().close()
        self._bus.terminate()
        self._bus.wait()
        self._files.cleanup()

    @property
    def pose(self):
        """Return the robot's pose in our units."""
        values = self._call(self._robot, f"{PROPERTIES}.GetAll", OBJECT)
        numbers = dict(re.findall(rf"'(\w+)': {NUMBER}", values))
        return pose(self.world, *(float(numbers[name]) for name in ("x", "y", "angle")))

    @pose.setter
    def pose(self, there):
        for name, value in zip(("x", "y", "angle"), place(self.world, there), strict=True):
            self._call(self._robot, f"{PROPERTIES}.Set", OBJECT, name, f"<{value:f}>")

    def press(self, button, down):
        """Touch a button: backward, left, center, forward, right are 0 to 4."""
        method = "ch.epfl.mobots.PlaygroundThymio2.SetButton"
        self._call(f"{self._robot}/thymio2", method, str(button), str(down).lower())

    @contextmanager
    def watching(self, every=0.04):
        """Record the robot's path as a growing list of (s, pose), each so many seconds."""
        path, ended = [], threading.Event()
        began = monotonic()

        def watch():
            while not ended.wait(every):
                path.append((monotonic() - began, self.pose))

        thread = threading.Thread(target=watch, daemon=True)
        thread.start()
        try:
            yield path
        finally:
            ended.set()
            thread.join()

    def _call(self, path, method, *arguments):
        command = ["gdbus", "call", *SERVICE, path, "--method", method, *arguments]
        answers = []

        def answered():
            process = subprocess.run(
                command, env=self._environment, capture_output=True, text=True, check=False
            )
            answers.append(process.stdout)
            return process.returncode == 0

        # It listens slightly earlier than it appears on the bus.
        wait_for(answered, "the playground on the bus")
        return answers[-1]


def begin_bus(folder):
    """A D-Bus and its address for one playground, since all of them use the same name."""
    (folder / "bus.conf").write_text(BUS)
    daemon = subprocess.Popen(
        ["dbus-daemon", "--config-file", folder / "bus.conf", "--nofork", "--print-address"],
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
    )
    with daemon.stdout:
        return daemon, daemon.stdout.readline().strip()
