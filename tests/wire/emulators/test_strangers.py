"""What strangers send to an emulated robot neither ends it nor takes it from its client."""

import random
import socket
import threading
from contextlib import closing, contextmanager, suppress

import pytest

from emulated import LONG
from learnblock.devices import Base
from learnblock.emulators import emulate
from learnblock.emulators.ev3 import Emulator
from learnblock.emulators.twin import Twin
from learnblock.robots import connect

CHANCE = random.Random(7)  # noqa: S311 - for garbage
ICE = b"IceP\x01\x00\x01\x00"
#: What no robot understands: other protocols, false lengths, pieces, and bytes by chance.
GARBAGE = (
    b"",
    b"GET / HTTP/1.1\r\nHost: robot\r\n\r\n",
    b"\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03" + bytes(200),
    b"\xff" * 60_000,
    b"[" * 60_000,
    b'{"drive": [1e999, NaN]}\n{"drive": "x"}\n{\n',
    ICE + b"\x00\x00\xff\xff\xff\x7f",
    ICE + b"\x00\x00\x00\x00\x00\x00",
    ICE + b"\x00\x00\x0e\x00\x10\x00" + bytes(4000),
    ICE + b"\x00\x02\xff\x00\x00\x00BZ",
    b"COZ\x03RE\x01\x07" + bytes(40),
    *(CHANCE.randbytes(1 + size * 37) for size in range(20)),
    *(ICE + b"\x00\x00\x4a\x00\x00\x00" + CHANCE.randbytes(60) for _ in range(20)),
)


@contextmanager
def emulated(name):
    """An emulated robot's settings; of an EV3 also with LEGO's firmware."""
    if name != "ev3 direct":
        with emulate(name, "empty") as emulation:
            yield name, {**emulation.settings, "patience": LONG}
        return
    with (
        Twin("sim-ev3", "empty") as twin,
        closing(Emulator(twin, connection="direct")) as emulation,
    ):
        yield "ev3", {**emulation.settings, "patience": LONG}


def throw(port, kind):
    """Send each piece of garbage from a socket of its own."""
    for data in GARBAGE:
        with socket.socket(socket.AF_INET, kind) as wire, suppress(OSError):
            wire.settimeout(0.1)
            wire.connect(("127.0.0.1", port))
            wire.sendall(data)


@pytest.mark.parametrize("name", ["coppeliasim", "cozmo", "ebo", "ev3", "ev3 direct", "rcis"])
def test_garbage_on_its_wire_is_survived(name, monkeypatch):
    dead = []
    monkeypatch.setattr(threading, "excepthook", dead.append)
    kind = socket.SOCK_DGRAM if name == "cozmo" else socket.SOCK_STREAM
    with emulated(name) as (robot, settings):
        ports = [value for key, value in settings.items() if key.endswith("port")]
        with connect(robot, **settings) as client:
            for port in filter(None, ports):
                throw(port, kind)
            client.check_link()
            client.device(Base).move(50, 0)
        with connect(robot, **settings) as client:
            client.device(Base).move(50, 0)
            client.check_link()
    assert dead == []
