"""Faces in the camera's picture, and their emotions."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from learnblock.devices import Emotion

if TYPE_CHECKING:
    from learnblock.client import Client
    from learnblock.perception import Face, FaceEmotion


def is_there_face(robot: "Client") -> bool:
    """Does the camera see a face?"""
    return bool(_faces(robot))


def is_left_face(robot: "Client") -> bool:
    """Does the camera see a face on the left of the picture?"""
    return any(face.is_left for face in _faces(robot))


def is_right_face(robot: "Client") -> bool:
    """Does the camera see a face on the right of the picture?"""
    return any(face.is_right for face in _faces(robot))


def is_up_face(robot: "Client") -> bool:
    """Does the camera see a face high in the picture?"""
    return any(face.is_up for face in _faces(robot))


def is_down_face(robot: "Client") -> bool:
    """Does the camera see a face low in the picture?"""
    return any(face.is_down for face in _faces(robot))


def is_center_face(robot: "Client") -> bool:
    """Does the camera see a face in the middle of the picture?"""
    return any(face.is_center for face in _faces(robot))


def is_any_face_happy(robot: "Client") -> bool:
    """Does the camera see a happy face?"""
    return _is_any_face(robot, Emotion.JOY)


def is_any_face_sad(robot: "Client") -> bool:
    """Does the camera see a sad face?"""
    return _is_any_face(robot, Emotion.SADNESS)


def is_any_face_neutral(robot: "Client") -> bool:
    """Does the camera see a neutral face?"""
    return _is_any_face(robot, Emotion.NEUTRAL)


def is_any_face_angry(robot: "Client") -> bool:
    """Does the camera see an angry face?"""
    return _is_any_face(robot, Emotion.ANGER)


def is_any_face_surprised(robot: "Client") -> bool:
    """Does the camera see a surprised face?"""
    return _is_any_face(robot, Emotion.SURPRISE)


def is_any_face_scared(robot: "Client") -> bool:
    """Does the camera see a scared face?"""
    return _is_any_face(robot, Emotion.FEAR)


def is_any_face_disgusted(robot: "Client") -> bool:
    """Does the camera see a disgusted face?"""
    return _is_any_face(robot, Emotion.DISGUST)


def _faces(robot: "Client") -> "Sequence[Face]":
    return robot.detect("faces") or ()


def _is_any_face(robot: "Client", emotion: Emotion) -> bool:
    # The detector returns None if recognising emotions is not allowed.
    faces: Sequence[FaceEmotion] = robot.detect("emotions") or ()
    return any(face.emotion == emotion for face in faces)
