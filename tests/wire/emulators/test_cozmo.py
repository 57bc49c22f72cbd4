"""Cozmo's end of the wire, tested in bytes."""

import io
import select
import socket
import struct
import threading
from typing import Self

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from PIL import Image
from pycozmo import camera, expressions
from pycozmo import protocol_encoder as packets
from pycozmo.frame import Frame as TheirFrame
from pycozmo.image_encoder import ImageEncoder, str_to_image
from pycozmo.tests.image_encoder_fixtures import FIXTURES
from pycozmo.util import hex_load

from cozmos import Cozmo, cozmo
from emulated import LONG
from learnblock.emulators.cozmo import face, frames, picture
from learnblock.emulators.cozmo.frames import Datagram, DatagramError, FrameKind, decoded, encoded
from waiting import wait_for

# Frames.

#: What the robot's own app once sent: silence, a face, and the lamps on the back (pycozmo's tests).
CAPTURED = bytes.fromhex(
    "434f5a0352450107 9d0a a00a 8f00"
    "040100 8f"
    "041d00 97 1a00 15b0aa9cacb240a8ba5eacb24002b4a2a0b0aa40acb260b0aa1b"
    "042000 03 1f801f80090000000000 1f801f80090000000000 1f801f80090000000000 00"
    "041600 11 1f801f80090000000000 1f801f80090000000000 00"
)


def test_a_frame_that_the_robots_app_sent_is_read():
    frame = decoded(CAPTURED)
    assert (frame.kind, frame.ack) == (FrameKind.FROM_ENGINE, 143)
    names = [(number, type(packet).__name__) for number, packet in frame.packets]
    assert names == [
        (2717, "OutputSilence"),
        (2718, "DisplayImage"),
        (2719, "LightStateCenter"),
        (2720, "LightStateSide"),
    ]
    assert face.pixels(bytes(frame.packets[1][1].image)).any()


def test_pycozmo_reads_what_the_robot_writes():
    state = packets.RobotState(pose_x=3, cliff_data_raw=(0, 0, 0, 0))
    contents = [packets.Connect(), state, packets.BodyInfo(serial_number=7)]
    theirs = TheirFrame.from_bytes(encoded(ack=5, first=9, contents=contents))
    # pycozmo counts from 0, the wire from 1.
    assert (theirs.first_seq, theirs.seq, theirs.ack) == (8, 9, 4)
    assert [type(packet) for packet in theirs.pkts] == [type(packet) for packet in contents]
    assert theirs.pkts[1].pose_x == 3


def test_numbers_restart_after_the_last():
    assert [frames.following(number) for number in (0, 1, 65533, 65534)] == [1, 2, 65534, 1]


@pytest.mark.parametrize(
    ("datagram", "sentence"),
    [
        (b"COZ", "3 bytes is too short"),
        (b"X" * 14, "can't start with"),
        (CAPTURED[:7] + b"\x08" + CAPTURED[8:], "unknown frame type 8"),
        (CAPTURED[:-1], "ends after 21"),
        (CAPTURED[:16], "ends in its header"),
        (CAPTURED + bytes(1000), "more than 1037"),
    ],
)
def test_a_datagram_that_is_not_a_frame_is_rejected(datagram, sentence):
    with pytest.raises(DatagramError, match=sentence):
        decoded(datagram)


@given(st.binary(max_size=120), st.sampled_from([1, 3, 4, 7, 9, 11]))
def test_a_damaged_frame_raises_only_our_own_error(tail, kind):
    try:
        decoded(CAPTURED[:7] + bytes((kind,)) + tail)
    except DatagramError:
        return


# The screen.


@pytest.mark.parametrize("name", FIXTURES)
def test_the_screen_shows_the_same_as_the_real_one(name):
    fixture = FIXTURES[name]
    expected = np.array(str_to_image(fixture["image"]))
    assert np.array_equal(face.pixels(hex_load(fixture["seq"])), expected)


@given(st.binary(min_size=512, max_size=512))
def test_the_screen_shows_everything_that_pycozmo_draws(bits):
    drawn = np.unpackbits(np.frombuffer(bits, np.uint8)).reshape(32, 128) > 0
    assert np.array_equal(face.pixels(bytes(ImageEncoder(Image.fromarray(drawn)).encode())), drawn)


@given(st.binary(max_size=300))
def test_run_lengths_beyond_the_screen_are_refused(lengths):
    try:
        assert face.pixels(lengths).shape == (32, 128)
    except ValueError as error:
        assert "exceeds the screen" in str(error)  # noqa: PT017 - or it is within


def test_a_face_is_recognized_and_another_picture_is_not():
    for name, expression in face.EMOTIONS.items():
        assert face.emotion(np.array(expression().render())[::2]) == name
    assert face.emotion(np.zeros((32, 128), np.bool_)) == "none"
    assert face.emotion(np.array(expressions.Confusion().render())[::2]) is None
    assert face.emotion(np.ones((32, 128), np.bool_)) is None


# The camera.


SOFT = np.stack(np.broadcast_arrays(*np.ogrid[40:200:240j, 60:250:320j], 90.0), axis=2)


@pytest.mark.parametrize("colour", [True, False])
def test_a_picture_is_a_jpeg_without_header_which_pycozmo_puts_before_it(colour):
    frame = SOFT.astype(np.uint8)
    chunks = list(picture.pieces(frame, colour=colour, number=3, timestamp=40))
    data = b"".join(bytes(chunk.data) for chunk in chunks)
    assert data[0] == colour
    restore, width = (camera.minicolor_to_jpeg, 160) if colour else (camera.minigray_to_jpeg, 320)
    whole = restore(np.frombuffer(data, np.uint8), width, 240).tobytes()
    seen = Image.open(io.BytesIO(whole)).convert("RGB").resize((320, 240))
    expected = frame if colour else np.array(Image.fromarray(frame).convert("L").convert("RGB"))
    assert np.abs(np.array(seen).astype(float) - expected).mean() < 2


def test_a_picture_comes_in_pieces_that_fit_into_frames():
    noise = np.random.default_rng(1).integers(0, 256, (240, 320, 3), np.uint8)
    chunks = list(picture.pieces(noise, colour=True, number=3, timestamp=40))
    assert [chunk.chunk_id for chunk in chunks] == list(range(len(chunks)))
    assert {chunk.image_chunk_count for chunk in chunks} == {len(chunks)}
    assert max(len(chunk) for chunk in chunks) + 4 <= frames.MOST_PAYLOAD


# A client that sends bytes.


class Client:
    """An app that uses only a part of the protocol."""

    def __init__(self, there: Cozmo) -> None:
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.settimeout(LONG)
        self.socket.connect(there.wire.target)
        self.number = 1
        self.ack = 0

    def __enter__(self) -> Self:
        self.frame(FrameKind.RESET)
        return self

    def __exit__(self, *_: object) -> None:
        self.socket.close()

    def frame(self, kind: int, payload: bytes = b"", number: int | None = None) -> None:
        number = self.number if number is None else number
        self.socket.send(
            struct.pack("<7sBHHH", frames.MAGIC, kind, number, number, self.ack) + payload
        )

    def command(self, packet: object, *, number: int | None = None) -> None:
        self.number += number is None
        content = bytes((packet.id,)) + packet.to_bytes()
        self.frame(FrameKind.FROM_ENGINE, struct.pack("<BH", 4, len(content)) + content, number)

    def enable(self) -> None:
        for packet in (packets.Enable(), packets.SyncTime()):
            self.command(packet)

    def hear(self) -> Datagram:
        return decoded(self.socket.recv(65536))

    def hear_until(self, kind: type) -> object:
        """The next packet of a kind, its number and the frame's acknowledgement."""
        while True:
            frame = self.hear()
            for number, packet in frame.packets:
                if isinstance(packet, kind):
                    return packet, number, frame.ack

    def hear_all(self) -> list[bytes]:
        """What has come and was not heard yet."""
        found = []
        while select.select((self.socket,), (), (), 0)[0]:
            found.append(self.socket.recv(65536))
        return found


@pytest.fixture(scope="module")
def there():
    with cozmo() as one:
        yield one


def test_a_reset_is_accepted_as_documented(there):
    with Client(there) as client:
        frame = client.hear()
        assert frame.ack == 1
        assert [(number, type(packet).__name__) for number, packet in frame.packets] == [
            (1, "Connect"),
            (2, "HardwareInfo"),
            (3, "FirmwareSignature"),
        ]


def test_packets_without_acknowledgement_are_sent_again(there):
    with Client(there) as client:
        assert repr(client.hear()) == repr(client.hear())
        client.ack = 3
        client.command(packets.Enable())
        # The last packet may have been sent again before the acknowledgement; the next one is new.
        assert client.hear_until(packets.BodyInfo)[1] == 4


def test_a_packet_is_executed_once_and_only_in_order(there):
    with Client(there) as client:
        before = there.machine.received.copy()
        client.command(packets.SetRobotVolume(level=3), number=3)
        client.enable()
        client.command(packets.SetRobotVolume(level=4), number=3)
        client.hear_until(packets.RobotState)
        assert there.machine.received - before == {"Enable": 1, "SyncTime": 1}
        assert client.hear_until(packets.RobotState)[2] == 3


def test_a_ping_is_answered(there):
    with Client(there) as client:
        client.frame(FrameKind.PING, packets.Ping(time_sent_ms=7.5, counter=3).to_bytes(), 0)
        ping, number, _ = client.hear_until(packets.Ping)
        assert (ping.time_sent_ms, ping.counter, number) == (7.5, 3, 0)


def test_invalid_values_change_nothing(there):
    with Client(there) as client:
        client.enable()
        client.command(packets.DriveWheels(lwheel_speed_mmps=50, rwheel_speed_mmps=50))
        wait_for(lambda: there.speed() > 30, "it drives")
        for value in (float("nan"), float("inf")):
            client.command(packets.DriveWheels(lwheel_speed_mmps=value, rwheel_speed_mmps=value))
            client.command(packets.SetHeadAngle(angle_rad=value))
            client.command(packets.SetLiftHeight(height_mm=value))
        client.hear_until(packets.AcknowledgeAction)
        assert there.speed() > 30
        client.frame(FrameKind.GOODBYE)
        wait_for(lambda: there.speed() < 1, "it stands")


def test_it_stops_and_forgets_a_client_after_a_long_silence(there, monkeypatch):
    with Client(there) as client:
        client.enable()
        client.command(packets.DriveWheels(lwheel_speed_mmps=80, rwheel_speed_mmps=80))
        wait_for(lambda: there.speed() > 50, "it drives")
        monkeypatch.setattr("learnblock.emulators.cozmo.server.SILENCE", 0.3)
        wait_for(lambda: there.speed() < 1, "it stands")
        monkeypatch.undo()
        client.hear_all()
        before = there.machine.received["Enable"]
        client.command(packets.Enable())
        with Client(there) as other:
            # Whatever was sent before has been handled then.
            other.hear_until(packets.Connect)
        assert there.machine.received["Enable"] == before
        assert client.hear_all() == []


def test_slow_reports_do_not_delay_commands_ever_more(there, monkeypatch):
    before = there.machine.received["SetHeadAngle"]
    obeyed = []

    def report():
        obeyed.append(there.machine.received["SetHeadAngle"] - before)
        threading.Event().wait(0.1)
        return ()

    with Client(there) as client:
        client.enable()
        monkeypatch.setattr(there.machine, "tick", report)
        wait_for(lambda: obeyed, "it reports")
        for _ in range(30):
            client.command(packets.SetHeadAngle(angle_rad=0.1))
        wait_for(lambda: 30 in obeyed, "every command is obeyed")
    # Some may come after the first of these reports.
    assert len([count for count in obeyed if 0 < count < 30]) <= 1


def test_it_reports_thirty_three_times_per_second_and_sends_fifteen_pictures(there):
    states, pictures = [], []
    with Client(there) as client:
        client.enable()
        client.command(packets.EnableCamera())
        while len(states) < 60 or len(pictures) < 20:
            for _, packet in client.hear().packets:
                if isinstance(packet, packets.RobotState):
                    states.append(packet.timestamp)
                elif isinstance(packet, packets.ImageChunk) and packet.chunk_id == 0:
                    pictures.append(packet.frame_timestamp)
    # A busy machine makes it skip some, but never send more.
    assert usual_rate(states) < 37
    assert best_rate(states) > 27
    assert usual_rate(pictures) < 17
    assert best_rate(pictures) > 12


def usual_rate(times):
    """How many come in a second of the robot's own time, which is in ms."""
    return 1000 * (len(times) - 1) / max(times[-1] - times[0], 1)


def best_rate(times, count=5):
    """The rate where that many came fastest."""
    return max(usual_rate(times[at : at + count + 1]) for at in range(len(times) - count))
