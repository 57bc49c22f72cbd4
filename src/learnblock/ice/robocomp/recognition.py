"""Components that detect objects: Apriltag, EmotionRecognition, DetectionComponent."""

from dataclasses import dataclass

from learnblock.ice.interface import Interface, Operation
from learnblock.ice.types import FLOAT, Bytes, Int, Sequence, String, Structure


@dataclass(frozen=True, slots=True)
class Picture:
    """A picture (TImage) as RGB bytes, row by row.

    Args:
        width: the number of its rows, in all programs with this interface.
        height: the number of its columns.
        depth: bytes per pixel.
        image: the bytes.
    """

    width: Int = 0
    height: Int = 0
    depth: Int = 0
    image: Bytes = b""


@dataclass(frozen=True, slots=True)
class FoundTag:
    """A tag: its number, and its centre in pixels."""

    id: Int = 0
    cx: Int = 0
    cy: Int = 0
    cameraId: String = ""


@dataclass(frozen=True, slots=True)
class FoundEmotion:
    """A face (SEmotion), in pixels: Happy, Sad, Neutral, Angry or Surprised."""

    x: Int = 0
    y: Int = 0
    w: Int = 0
    h: Int = 0
    emotion: String = ""


@dataclass(frozen=True, slots=True)
class Prediction:
    """An object (SPrediction), in pixels."""

    x: Int = 0
    y: Int = 0
    w: Int = 0
    h: Int = 0
    label: String = ""


_PICTURE = Structure.of(Picture)


def apriltag() -> Interface:
    """Finds tags."""
    return Interface(
        "::RoboCompApriltag::Apriltag", (_search("processimage", Structure.of(FoundTag)),)
    )


def emotion_recognition() -> Interface:
    """Finds faces and their emotions."""
    return Interface(
        "::RoboCompEmotionRecognition::EmotionRecognition",
        (_search("processimage", Structure.of(FoundEmotion)),),
    )


def detection_component() -> Interface:
    """Finds objects whose probability reaches a threshold."""
    return Interface(
        "::RoboCompDetectionComponent::DetectionComponent",
        (
            _search("processImage", Structure.of(Prediction)),
            Operation("getThreshold", gives=(FLOAT,)),
            Operation("setThreshold", takes=(FLOAT,)),
        ),
    )


def _search(name: str, finds: Structure) -> Operation:
    return Operation(name, takes=(_PICTURE,), gives=(Sequence(finds),))
