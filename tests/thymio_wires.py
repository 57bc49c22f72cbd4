"""What a Thymio and Thymio Suite send, for the fuzzer: each byte is a character of Latin-1."""

import struct
import threading

import tdmclient
from thymiodirect.message import Message

from learnblock.robots.thymio.aseba import AsebaLink
from learnblock.robots.thymio.frames import encoded
from learnblock.robots.thymio.node import READ
from learnblock.robots.thymio.program import DONE, READY
from learnblock.robots.thymio.suite import SuiteLink


class Tape:
    """A wire on which a robot says what is on the tape, and nothing more."""

    name = "a tape"

    def __init__(self, data):
        self._data = data

    def receive(self):
        data, self._data = self._data, b""
        if not data:
            raise ConnectionError("the tape is at its end")
        return data

    def send(self, data):
        """Nobody hears it."""

    def close(self):
        """Nothing is open."""


def read_robot(text):
    """Let a link hear all of it: only our own errors may come of that."""
    hear(AsebaLink, text)


def read_suite(text):
    """The same for Thymio Suite's."""
    hear(SuiteLink, text)


def hear(kind, text):
    failed, usual = [], threading.excepthook
    threading.excepthook = failed.append
    try:
        kind(Tape(text.encode("latin-1", errors="ignore")), 1.0).close()
    finally:
        threading.excepthook = usual
        # What its reader stumbles over is more than a refusal.
        if failed:
            raise failed[0].exc_value


def robot_texts():
    """A whole description with what follows, and single messages."""
    words = [
        encoded(Message.ID_VARIABLES, 0, *range(40)),
        encoded(READY.number, 1),
        encoded(DONE.number, 1, 32, 0, 0),
    ]
    whole = frame(Message.ID_NODE_PRESENT, struct.pack("<H", 5)) + description()
    return tuple(one.decode("latin-1") for one in (whole + b"".join(words), whole, *words))


def description():
    head = name("thymio-II") + struct.pack("<7H", 5, 1534, 32, 586, len(READ), 1, 1)
    return b"".join(
        [
            frame(Message.ID_DESCRIPTION, head),
            *(
                frame(Message.ID_NAMED_VARIABLE_DESCRIPTION, struct.pack("<H", size) + name(one))
                for one, size in READ.items()
            ),
            frame(Message.ID_LOCAL_EVENT_DESCRIPTION, name("timer0") + name("")),
            frame(Message.ID_NATIVE_FUNCTION_DESCRIPTION, name("leds.top") + name("") + b"\0\0"),
        ]
    )


def name(text):
    return bytes([len(text)]) + text.encode()


def frame(kind, payload):
    return struct.pack("<HHH", len(payload), 1, kind) + payload


def suite_texts():
    """A handshake, and a robot that is free, with what it senses."""
    sent = []
    node = tdmclient.server.ServerNode(variables={one: [0] * size for one, size in READ.items()})
    handler = tdmclient.server.ServerHandler(None, [node], sent.append)
    handler.process_message(bytes(tdmclient.ThymioFB().create_msg_handshake()))
    packets = [struct.pack("<I", len(packet)) + bytes(packet) for packet in sent]
    return tuple(one.decode("latin-1") for one in (b"".join(packets), *packets))
