"""Cameras with colour and depth: RGBD."""

from dataclasses import dataclass
from enum import IntEnum
from typing import Annotated

from learnblock.ice.interface import Interface, Mode, Operation
from learnblock.ice.robocomp.bases import base_state
from learnblock.ice.robocomp.joints import motor_states
from learnblock.ice.robocomp.layout import Layout
from learnblock.ice.types import (
    BYTE,
    FLOAT,
    Bool,
    Byte,
    Enumeration,
    Float,
    Int,
    Refusal,
    Sequence,
    String,
    Structure,
    Type,
)


class Registration(IntEnum):
    """How the colour and depth pictures are aligned."""

    NONE = 0
    DEPTH_IN_COLOR = 1
    COLOR_IN_DEPTH = 2


@dataclass(frozen=True, slots=True)
class ColorRGB:
    """A pixel."""

    red: Byte = 0
    green: Byte = 0
    blue: Byte = 0


@dataclass(frozen=True, slots=True)
class PointXYZ:
    """A point in space, mm."""

    x: Float = 0.0
    y: Float = 0.0
    z: Float = 0.0
    w: Float = 0.0


@dataclass(frozen=True, slots=True)
class CameraParameters:
    """One of the two cameras: pixels, bytes, frames per second."""

    focal: Int = 0
    width: Int = 0
    height: Int = 0
    size: Int = 0
    FPS: Int = 0


_CAMERA = Structure.of(CameraParameters)


@dataclass(frozen=True, slots=True)
class RGBDParams:
    """The parameters of the camera."""

    color: Annotated[CameraParameters, _CAMERA]
    depth: Annotated[CameraParameters, _CAMERA]
    timerPeriod: Int = 0
    talkToBase: Bool = False
    talkToJointMotor: Bool = False
    driver: String = ""
    device: String = ""


def rgbd(layout: Layout) -> Interface:
    """A colour and depth camera; ``getData`` returns RGB bytes and distances in mm, packed."""
    failed = (Refusal("::RoboCompRGBD::HardwareFailedException"),)
    registration = Enumeration(Registration)
    pixels, depths, points = (
        Sequence(Structure.of(ColorRGB)),
        Sequence(FLOAT),
        Sequence(Structure.of(PointXYZ)),
    )
    state: tuple[Type, ...] = (motor_states(layout), base_state(layout))

    def question(name: str, *gives: Type, mode: Mode = Mode.NORMAL) -> Operation:
        return Operation(name, gives=(*gives, *state), mode=mode, refuses=failed)

    again = Mode.IDEMPOTENT
    return Interface(
        "::RoboCompRGBD::RGBD",
        (
            Operation("getRGBDParams", gives=(Structure.of(RGBDParams),)),
            Operation("setRegistration", takes=(registration,), mode=again, refuses=failed),
            Operation("getRegistration", gives=(registration,), mode=again, refuses=failed),
            question("getData", Sequence(BYTE), depths, mode=again),
            question("getDepthInIR", depths, mode=again),
            question("getImage", pixels, depths, points, mode=again),
            question("getDepth", depths),
            question("getRGB", pixels),
            question("getXYZ", points),
        ),
    )
