"""Messages of a Thymio and Thymio Suite for the fuzzer: each byte is a Latin-1 character."""

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
    """A wire on which a robot sends a recording, and nothing more."""

    name = "a tape"

    def __init__(self, data):
        self._data = data

    def receive(self):
        data, self._data = self._data, b""
        if not data:
            raise ConnectionError("the tape is at its end")
        return data

    def send(self, data):
        """Ignore what is written."""

    def close(self):
        """Do nothing: there is nothing to close."""


def read_robot(text):
    """Let a link read everything; only our own errors may be raised."""
    hear(AsebaLink, text)


def read_suite(text):
    """Do the same for a link to Thymio Suite."""
    hear(SuiteLink, text)


def hear(kind, text):
    failed, usual = [], threading.excepthook
    threading.excepthook = failed.append
    try:
        kind(Tape(text.encode("latin-1", errors="ignore")), 1.0).close()
    finally:
        threading.excepthook = usual
        # Its reader fails on more than refused messages.
        if failed:
            raise failed[0].exc_value


def robot_texts():
    """Return a complete description with later messages, and single messages."""
    words = [
        encoded(Message.ID_VARIABLES, 0, *range(40)),
        encoded(READY.number, 1),
        encoded(DONE.number, 1, 32, 0, 0),
    ]
    whole = frame(Message.ID_NODE_PRESENT, struct.pack("<H", 5)) + description()
    return tuple(message.decode("latin-1") for message in (whole + b"".join(words), whole, *words))


def description():
    head = name("thymio-II") + struct.pack("<7H", 5, 1534, 32, 586, len(READ), 1, 1)
    return b"".join(
        [
            frame(Message.ID_DESCRIPTION, head),
            *(
                frame(
                    Message.ID_NAMED_VARIABLE_DESCRIPTION, struct.pack("<H", size) + name(variable)
                )
                for variable, size in READ.items()
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
    """Return a handshake, and a free robot with its readings."""
    messages = []
    node = tdmclient.server.ServerNode(
        variables={variable: [0] * size for variable, size in READ.items()}
    )
    handler = tdmclient.server.ServerHandler(None, [node], messages.append)
    handler.process_message(bytes(tdmclient.ThymioFB().create_msg_handshake()))
    packets = [struct.pack("<I", len(packet)) + bytes(packet) for packet in messages]
    return tuple(message.decode("latin-1") for message in (b"".join(packets), *packets))
