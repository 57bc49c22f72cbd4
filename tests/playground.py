"""Aseba's playground in tests, where its Thymio is seen and moved by D-Bus."""

import re
import shutil
import subprocess
import threading
from contextlib import contextmanager
from time import monotonic

import pytest

from learnblock.emulators import thymio
from learnblock.emulators.playground import place, pose

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
    """How to install what is not there; nothing where all is."""
    packages = [package for name, package in PACKAGES.items() if shutil.which(name) is None]
    return f"apt-get install {' '.join(packages)}" if packages else ""


class Playground(thymio.Emulator):
    """A playground whose robot can be seen, lifted and touched."""

    def __init__(self, world, **place):
        super().__init__(world, **place)
        robot = self._call("/world", "ch.epfl.mobots.EnkiWorld.PhysicalObjectsByType", "Thymio2")
        number = re.search(r"'(\w+)'", robot).group(1)
        self._robot = f"/world/objects/{number}"
        self._call("/world", "ch.epfl.mobots.EnkiWorld.PhysicalObject", number)

    @property
    def pose(self):
        """Where the robot is, as a pose of ours."""
        values = self._call(self._robot, f"{PROPERTIES}.GetAll", OBJECT)
        named = dict(re.findall(rf"'(\w+)': {NUMBER}", values))
        return pose(self.world, *(float(named[name]) for name in ("x", "y", "angle")))

    @pose.setter
    def pose(self, there):
        for name, value in zip(("x", "y", "angle"), place(self.world, there), strict=True):
            self._call(self._robot, f"{PROPERTIES}.Set", OBJECT, name, f"<{value:f}>")

    def press(self, button, down):
        """Touch a button: backward, left, center, forward, right are 0 to 4."""
        method = "ch.epfl.mobots.PlaygroundThymio2.SetButton"
        self._call(f"{self._robot}/thymio2", method, str(button), str(down).lower())

    @contextmanager
    def watching(self):
        """The robot's path while this lasts, as a list of (s, pose) that grows."""
        path, ended = [], threading.Event()
        began = monotonic()

        def watch():
            while not ended.wait(0.04):
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
        until = monotonic() + 10
        while True:
            done = subprocess.run(command, capture_output=True, text=True, check=False)
            if done.returncode == 0:
                return done.stdout
            # It listens a moment before it is on the bus.
            assert monotonic() < until, done.stderr


@contextmanager
def bus(folder, monkeypatch):
    """A D-Bus of our own, for the playground and for us; the environment leads to it."""
    if missing():
        pytest.skip(missing())
    (folder / "bus.conf").write_text(BUS)
    daemon = subprocess.Popen(
        ["dbus-daemon", "--config-file", folder / "bus.conf", "--nofork", "--print-address"],
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
    )
    try:
        monkeypatch.setenv("DBUS_SESSION_BUS_ADDRESS", daemon.stdout.readline().strip())
        monkeypatch.setenv("QT_QPA_PLATFORM", "offscreen")
        yield
    finally:
        daemon.terminate()
        daemon.wait()
        daemon.stdout.close()
