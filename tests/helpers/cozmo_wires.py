"""Cozmo's messages as strings for the fuzzer: each letter is a byte."""

from functools import cache

import numpy as np
from PIL import Image
from pycozmo import protocol_encoder as packets
from pycozmo.image_encoder import ImageEncoder

from learnblock.emulators.cozmo import face, frames, picture
from learnblock.emulators.cozmo.machine import CozmoMachine
from learnblock.emulators.twin import Twin
from learnblock.robots.cozmo import link
from learnblock.robots.cozmo.camera import ReceivedPicture


def read_frame(text: str) -> None:
    """Read a datagram at both ends, and let the robot execute it."""
    data = _bytes(text)
    link.decoded(data)
    for _, packet in frames.decoded(data).packets:
        if packet is not None:
            tuple(_machine().handle(packet))


def frame_texts() -> tuple[str, ...]:
    """Return frames with packets of all kinds, in both directions."""
    commands = (
        packets.DriveWheels(lwheel_speed_mmps=50),
        packets.SetHeadAngle(angle_rad=0.3),
        packets.SetLiftHeight(height_mm=50),
        packets.SetOrigin(),
        packets.EnableCamera(),
        packets.OutputAudio(samples=bytes(744)),
        packets.DisplayImage(image=b"\x3f\x3f"),
        packets.LightStateSide(states=(packets.LightState(), packets.LightState())),
        packets.RobotState(cliff_data_raw=(0, 0, 0, 0)),
        packets.FirmwareSignature(signature="{}"),
        packets.Ping(),
    )
    from_robot = [frames.encoded(3, 7, [command]) for command in commands]
    as_engine = [frame[:7] + b"\x07" + frame[8:] for frame in from_robot]
    return tuple(frame.decode("latin-1") for frame in (*from_robot, *as_engine))


def read_picture(text: str) -> None:
    """Read a camera picture, of the usual size and of another."""
    encoding = packets.ImageEncoding.JPEGMinimizedGray
    for resolution in (packets.ImageResolution.QVGA, packets.ImageResolution.ImageResolutionCount):
        ReceivedPicture(_bytes(text) or b"\0", encoding, resolution).frame()


def picture_texts() -> tuple[str, ...]:
    noise = np.random.default_rng(0).integers(0, 256, (240, 320, 3), np.uint8)
    smooth = np.full((240, 320, 3), 90, np.uint8)
    coded = [code(frame) for frame in (noise, smooth) for code in (picture.grey, picture.coloured)]
    return tuple(data.decode("latin-1") for data in coded)


def read_screen(text: str) -> None:
    """Read the contents of the screen."""
    try:
        face.emotion(face.pixels(_bytes(text)))
    except ValueError as error:
        raise frames.DatagramError(str(error)) from error


def screen_texts() -> tuple[str, ...]:
    screens = [np.array(expression().render())[::2] for expression in face.EMOTIONS.values()]
    coded = [bytes(ImageEncoder(Image.fromarray(rows)).encode()) for rows in screens]
    return tuple(data.decode("latin-1") for data in coded)


def _bytes(text: str) -> bytes:
    return text.encode("latin-1", errors="replace")


@cache
def _machine() -> CozmoMachine:
    return CozmoMachine(Twin("sim-cozmo"))
