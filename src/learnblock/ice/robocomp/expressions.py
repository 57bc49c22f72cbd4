"""Faces: Display and EmotionalMotor."""

from dataclasses import dataclass

from learnblock.ice.interface import Interface, Operation
from learnblock.ice.robocomp.layout import Layout
from learnblock.ice.types import BOOL, FLOAT, STRING, Bytes, Int, Refusal, Structure


@dataclass(frozen=True, slots=True)
class Image:
    """A picture: rows of pixels with `depth` bytes each."""

    width: Int = 0
    height: Int = 0
    depth: Int = 0
    Img: Bytes = b""


_EMOTIONS = "Joy", "Sadness", "Surprise", "Fear", "Anger", "Disgust", "Neutral"


def display() -> Interface:
    """A screen; file paths are on the component's computer."""
    refuses = (Refusal("::RoboCompDisplay::HardwareFailedException"),)
    return Interface(
        "::RoboCompDisplay::Display",
        (
            Operation("setImage", takes=(Structure.of(Image),), refuses=refuses),
            Operation("setImageFromFile", takes=(STRING,), refuses=refuses),
        ),
    )


def emotional_motor(layout: Layout) -> Interface:
    """A face that shows emotions; since 2020 without a neutral one."""
    emotions = tuple(Operation(f"express{emotion}") for emotion in _EMOTIONS)
    talking = Operation("talking", takes=(BOOL,))
    operations = {
        Layout.ROBOT: (*emotions, talking),
        Layout.TOOL: emotions,
        Layout.SINCE_2020: (
            *emotions[:-1],
            talking,
            Operation("listening", takes=(BOOL,)),
            Operation("pupposition", takes=(FLOAT, FLOAT)),
            Operation("isanybodythere", takes=(BOOL,)),
        ),
    }
    return Interface("::RoboCompEmotionalMotor::EmotionalMotor", operations[layout])
