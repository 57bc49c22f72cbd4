"""An EV3's messages as strings for the fuzzer, whose letters are bytes."""

import json
import struct
from contextlib import closing, suppress

from learnblock.emulators.ev3.bytecode import ByteCodeMachine
from learnblock.errors import LearnBlockError
from learnblock.robots.ev3 import agent, direct, lines, scan, wires
from learnblock.robots.ev3.brick import Look, State
from learnblock.robots.ev3.link import BrickLink

QUESTION = direct.Question([direct.kind_of(2), direct.turned(1), direct.reading(3, 0)])
REPLY = struct.pack("<HBbb2xif", 7, 2, 30, 1, -720, 12.5)


def agent_texts():
    """Return lines of the agent and of its client."""
    return (
        '{"learnblock": 1, "nonce": "9f0a"}',
        '{"state": {"left": 0, "right": -3, "touch": 0.0, "colour": null}, "speaks": true}',
        '{"error": "has no motor at port A", "taken": false}',
        '{"proof": "3a", "motors": ["B", "D"], "sensors": {"touch": "", "gyroscope": "2"}}',
        '{"drive": [143, -143.5]}',
        '{"tone": [440, 500], "say": "hello"}',
    )


def firmware_texts():
    """Return messages of the firmware, a command and its beacon."""
    whole = struct.pack("<H", len(REPLY)) + REPLY
    beacon = b"Serial-Number: 0016533f0c1e\r\nPort: 5555\r\nName: EV3\r\nProtocol: EV3\r\n"
    command = direct.command(7, direct.turn(1, 50, 300) + direct.tone(440, 100), QUESTION)
    return tuple(data.decode("latin-1") for data in (whole, REPLY, beacon, command))


def read_agent(text):
    """Read a line at both ends."""
    data = text.encode("utf-8", "surrogatepass")
    with suppress(ValueError):
        lines.greeting(data)
    guarding = agent.Guard(Brick(), lambda: None, agent.BrickClock())
    with suppress(agent.BrickError), closing(guarding) as guard:
        json.loads(guard.answer(text))
        agent.wished(agent.parsed(text))
    Hearer(lambda: lines.answer(data, "there").state).say(Look())


def read_firmware(text):
    """Read bytes at both ends."""
    data = text.encode("latin-1", "ignore")
    scan.read_beacon(data)
    ByteCodeMachine(Vehicle()).execute(data)
    Hearer(lambda: read_reply(data)).say(Look())


def read_reply(data):
    body = Bytes(data).receive(1)
    try:
        direct.answered(body, 7, QUESTION)
    except direct.CommandFailedError as refusal:
        raise LearnBlockError from refusal
    return State(0, 0)


class Bytes(wires.Stream):
    """A wire that delivers these bytes."""

    def __init__(self, data):
        super().__init__()
        self.data = data

    def read(self, most, timeout):
        piece, self.data = self.data[:most], self.data[most:]
        return piece


class Hearer(BrickLink):
    """Exchange messages, and read one reply."""

    def __init__(self, read):
        super().__init__("there", lambda state: None)
        self._read = read

    def exchange(self, word):
        return self._read()

    def hang_up(self):
        """Do nothing: there is no wire."""


class Brick:
    """A brick that does nothing."""

    def state(self):
        return {"left": 0, "right": 0}

    def drive(self, speeds):
        """Do not move."""

    tone = say = drive

    def hush(self):
        """Make no sound."""


class Vehicle:
    """A vehicle that does not move."""

    def turn(self, speeds):
        """Do not move."""

    def note(self, *values):
        """Make no sound."""

    def show(self, text):
        """Show nothing."""

    def turned(self):
        return {}

    def _nothing(self):
        return 0.0

    distance = reflection = angle = touched = _nothing
