"""Pybricks' modules for a program on an emulated hub, and the start of that program.

This file runs in MicroPython, as the hub's program does: ``micropython firmware.py PORT FOLDER``.
The modules have the names and signatures of docs.pybricks.com; whatever a motor or sensor does is a
line of JSON to the emulator at the port, and its answer. FOLDER has the program, ``program.mpy``.
"""

import json
import select
import socket
import sys
import time

#: The error of MicroPython for a port where no such device is plugged in.
NO_DEVICE = 19


class Asking:
    """Asks the emulator."""

    def __init__(self, port):
        self.socket = socket.socket()
        self.socket.connect(socket.getaddrinfo("127.0.0.1", port)[0][-1])
        self.answers = self.socket.makefile("rb")

    def ask(self, *words):
        self.socket.send(json.dumps(words).encode() + b"\n")
        answer = json.loads(self.answers.readline())
        if "error" in answer:
            raise OSError(answer["error"])
        return answer["value"]


class Constants:
    """Takes the place of a class whose attributes are constants."""

    def __init__(self, *names):
        for name in names:
            setattr(self, name, name)


Port = Constants("A", "B", "C", "D", "E", "F")
Direction = Constants("CLOCKWISE", "COUNTERCLOCKWISE")


class Color:
    def __init__(self, h, s=100, v=100):
        self.h, self.s, self.v = int(h) % 360, max(0, min(int(s), 100)), max(0, min(int(v), 100))


class PUPDevice:
    def __init__(self, port):
        self.port = port
        self.number = wire.ask("number", port)

    def info(self):
        return {"id": self.number}


class _Device:
    """A device that must be of one of some kinds."""

    numbers = ()

    def __init__(self, port):
        self.port = port
        if wire.ask("number", port) not in self.numbers:
            raise OSError(NO_DEVICE)


class Motor(_Device):
    numbers = (48, 49, 65, 75, 76, 46, 47)

    def __init__(self, port, positive_direction=Direction.CLOCKWISE):
        _Device.__init__(self, port)
        self.sign = -1 if positive_direction == Direction.COUNTERCLOCKWISE else 1

    def run(self, speed):
        wire.ask("run", self.port, self.sign * speed)

    def brake(self):
        wire.ask("run", self.port, 0)

    def angle(self):
        return self.sign * wire.ask("angle", self.port)


class ColorSensor(_Device):
    numbers = (61,)

    def reflection(self):
        return wire.ask("reflection", self.port)


class UltrasonicSensor(_Device):
    numbers = (62,)

    def distance(self):
        return wire.ask("distance", self.port)


class ForceSensor(_Device):
    numbers = (63,)

    def pressed(self, force=3):
        return wire.ask("force", self.port) >= force


class _Display:
    def char(self, char):
        if len(char) != 1 or not 32 <= ord(char) < 127:
            raise ValueError(char)
        wire.ask("show", char)

    def off(self):
        wire.ask("show", "")


class _Speaker:
    def beep(self, frequency=500, duration=100):
        wire.ask("beep", frequency, duration)
        if duration > 0:
            wait(duration)


class _Light:
    def on(self, color):
        wire.ask("light", color.h, color.s, color.v)

    def off(self):
        wire.ask("light", 0, 0, 0)


class _IMU:
    def heading(self):
        return wire.ask("heading")


class _Battery:
    def voltage(self):
        return wire.ask("voltage")


class PrimeHub:
    def __init__(self):
        self.display, self.speaker, self.light = _Display(), _Speaker(), _Light()
        self.imu, self.battery = _IMU(), _Battery()


class StopWatch:
    def __init__(self):
        self.start = time.time()

    def time(self):
        return int(1000 * (time.time() - self.start))


def wait(time_ms):
    time.sleep(time_ms / 1000)


class _Module:
    """Takes the place of a module in `sys.modules`."""

    def __init__(self, *members):
        for member in members:
            setattr(self, member.__name__, member)


def modules():
    """The modules that a program may import, by name."""
    parameters = _Module(Color)
    parameters.Port, parameters.Direction = Port, Direction
    return {
        "pybricks": _Module(),
        "pybricks.hubs": _Module(PrimeHub),
        "pybricks.iodevices": _Module(PUPDevice),
        "pybricks.parameters": parameters,
        "pybricks.pupdevices": _Module(Motor, ColorSensor, UltrasonicSensor, ForceSensor),
        "pybricks.tools": _Module(StopWatch, wait),
        "uselect": select,
        "usys": sys,
    }


if __name__ == "__main__":
    wire = Asking(int(sys.argv[1]))
    sys.modules.update(modules())
    # Not this file's folder, where other modules are.
    sys.path[:] = [sys.argv[2]]
    __import__("program")
