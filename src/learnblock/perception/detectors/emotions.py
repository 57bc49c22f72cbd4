"""The emotions of faces, by the expression net of face-api (Mühler 2018), run by `cv2.dnn`.

The weights are part of the package; `hatch_weights.py` builds them with it.
"""

import threading
from collections.abc import Iterable
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, cast

import cv2
import numpy as np
from numpy.typing import NDArray

from learnblock.errors import WeightsMissingError
from learnblock.installation import Installation
from learnblock.perception.detections import Face, FaceEmotion
from learnblock.perception.detectors.faces import detect_faces
from learnblock.perception.frames import Frame, checked

if TYPE_CHECKING:
    from learnblock.perception.sight import Sight

# Why: docs/decisions.md, "The network for emotions is used as published"
WEIGHTS = Path(__file__).parents[1] / "weights" / "emotions.onnx"
#: The net's classes in its own order, with the names of the robots' emotions.
EMOTIONS = ("neutral", "joy", "sadness", "anger", "fear", "disgust", "surprise")
# The side of the net's input square, and the mean colour (RGB) that is subtracted, as in
# face-api's FaceFeatureExtractor.
SIDE = 112
MEAN = np.array([122.782, 117.001, 104.298], np.float32)
# The net's answer changes with a few pixels of the box around a face. So it gets two squares, which
# have these fractions of the cascade's side and are moved up by a fraction of it; the mean is used.
# Chosen on drawn faces of people 1 to 60.
SQUARES = (0.88, 1.0)
RISE = 0.025
# OpenCV's net keeps its working memory between calls: so one face at a time.
_TURN = threading.Lock()


def look(sight: "Sight") -> tuple[FaceEmotion, ...]:
    return emotions_of(sight.frame, sight.detect("faces"))


def detect_emotions(frame: Frame) -> tuple[FaceEmotion, ...]:
    """Find the faces in a frame and their emotions, from left to right.

    Args:
        frame: RGB, uint8, shape (height, width, 3).

    Raises:
        FrameError: `frame` is not a picture.
        WeightsMissingError: the net's weights are missing.
    """
    return emotions_of(frame, detect_faces(frame))


def emotions_of(frame: Frame, faces: Iterable[Face]) -> tuple[FaceEmotion, ...]:
    """Read the emotions of faces found in a frame.

    Args:
        frame: RGB, uint8, shape (height, width, 3).
        faces: the faces that `detect_faces` found in it.

    Raises:
        FrameError: `frame` is not a picture.
        WeightsMissingError: the net's weights are missing.
    """
    checked(frame)
    return tuple(_read(frame, face) for face in faces)


def _read(frame: Frame, face: Face) -> FaceEmotion:
    squares = (_square(frame, face, part) for part in SQUARES)
    confidences = np.mean([_softmax(_logits(square)) for square in squares], axis=0)
    best = int(confidences.argmax())
    return FaceEmotion(face, EMOTIONS[best], float(confidences[best]))


def _square(frame: Frame, face: Face, part: float) -> NDArray[np.float32]:
    """The input of the net: float32, shape (1, 3, SIDE, SIDE)."""
    side = round(part * face.width)
    left = face.x + (face.width - side) // 2
    top = face.y + (face.height - side) // 2 - round(RISE * face.height)
    crop = frame[max(0, top) : top + side, left : left + side]
    method = cv2.INTER_AREA if side > SIDE else cv2.INTER_LINEAR
    scaled = cv2.resize(crop, (SIDE, SIDE), interpolation=method).astype(np.float32)
    return np.ascontiguousarray(((scaled - MEAN) / 255).transpose(2, 0, 1)[None])


def _logits(square: NDArray[np.float32]) -> NDArray[np.float32]:
    with _TURN:
        net = _net()
        net.setInput(square)
        return cast(NDArray[np.float32], net.forward()[0])


def _softmax(logits: NDArray[np.float32]) -> NDArray[np.float32]:
    powers = np.exp(logits - logits.max())
    return cast(NDArray[np.float32], powers / powers.sum())


@cache
def _net() -> cv2.dnn.Net:
    if not WEIGHTS.is_file():
        command = Installation.current().rebuilt()
        raise WeightsMissingError("perception-no-weights", path=str(WEIGHTS), command=command)
    # Read from memory: OpenCV cannot open every path that Windows can have.
    return cv2.dnn.readNetFromONNX(np.fromfile(WEIGHTS, np.uint8))
