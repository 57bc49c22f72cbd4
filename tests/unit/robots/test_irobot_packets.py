"""The packets of iRobot's education robots, in both directions."""

import contextlib
import struct

import pytest
from hypothesis import given
from hypothesis import strategies as st

from learnblock.robots.irobot import messages
from learnblock.robots.irobot.packets import PAYLOAD, SIZE, Packet, checksum

byte = st.integers(0, 255)


#: The checksums of the example in iRobot's documentation, by the speeds of the wheels.
DOCUMENTED = {
    (100, 100): 0xD1,
    (-100, -100): 0x71,
    (0, 100): 0x8A,
    (100, 0): 0x25,
    (0, 0): 0x7E,
}


@pytest.mark.parametrize("speeds", DOCUMENTED)
def test_the_packets_that_drive_are_those_of_the_documentation(speeds):
    left, right = (speed.to_bytes(4, "big", signed=True) for speed in speeds)
    documented = bytes((1, 4, 0)) + left + right + bytes(8) + bytes((DOCUMENTED[speeds],))
    assert Packet(*messages.drive(*speeds)[:2], 0, messages.drive(*speeds).payload).encoded == (
        documented
    )


@given(byte, byte, byte, st.binary(max_size=PAYLOAD))
def test_a_packet_is_read_as_it_was_written(device, command, number, payload):
    data = Packet(device, command, number, payload).encoded
    assert len(data) == SIZE
    assert Packet.parsed(data) == (device, command, number, payload.ljust(PAYLOAD, b"\0"))


@given(st.binary(min_size=SIZE, max_size=SIZE), st.integers(0, 8 * SIZE - 1))
def test_a_packet_with_a_wrong_bit_is_rejected(data, wrong):
    right = data[:-1] + bytes((checksum(data[:-1]),))
    damaged = bytearray(right)
    damaged[wrong // 8] ^= 1 << wrong % 8
    with pytest.raises(ValueError, match="no packet"):
        Packet.parsed(bytes(damaged))


@given(st.binary(max_size=3 * SIZE))
def test_every_notification_of_a_robot_is_read_or_rejected(data):
    with contextlib.suppress(ValueError):
        Packet.parsed(data)


@given(st.binary(min_size=PAYLOAD, max_size=PAYLOAD))
def test_every_answer_of_a_robot_is_a_reading(payload):
    x, y, heading = messages.root_pose(payload)
    assert max(abs(x), abs(y)) <= 32768
    assert -180 <= heading < 180
    assert 0 <= messages.brightness(payload) <= 1023
    assert messages.volts(payload) >= 0
    assert len(messages.protocol(payload)) == 2
    seen = messages.colours(payload)
    assert len(seen) == messages.COLOURS
    assert all(0 <= messages.brightness_of(colour) <= 100 for colour in seen)


@given(st.floats(-1e6, 1e6), st.floats(-1e6, 1e6))
def test_every_tone_fits_into_a_packet(hertz, milliseconds):
    assert len(messages.note(hertz, milliseconds).payload) <= PAYLOAD


def test_a_root_reports_its_place_to_the_right_and_ahead():
    payload = struct.pack(">Ihhh6x", 1000, 30, 200, 900)
    assert messages.root_pose(payload) == (200.0, -30.0, 90.0)
