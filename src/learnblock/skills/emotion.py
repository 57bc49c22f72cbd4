"""Emotions on the robot's own face."""

from typing import TYPE_CHECKING

from learnblock.devices import Display, Emotion

if TYPE_CHECKING:
    from learnblock.client import Client


def expressJoy(robot: "Client") -> None:
    """Look happy."""
    _express(robot, Emotion.JOY)


def expressSadness(robot: "Client") -> None:
    """Look sad."""
    _express(robot, Emotion.SADNESS)


def expressSurprise(robot: "Client") -> None:
    """Look surprised."""
    _express(robot, Emotion.SURPRISE)


def expressDisgust(robot: "Client") -> None:
    """Look disgusted."""
    _express(robot, Emotion.DISGUST)


def expressAnger(robot: "Client") -> None:
    """Look angry."""
    _express(robot, Emotion.ANGER)


def expressFear(robot: "Client") -> None:
    """Look scared."""
    _express(robot, Emotion.FEAR)


def expressNeutral(robot: "Client") -> None:
    """Show no emotion."""
    _express(robot, Emotion.NEUTRAL)


def is_Joy(robot: "Client") -> bool:
    """Does the robot look happy?"""
    return _shows(robot, Emotion.JOY)


def is_Sadness(robot: "Client") -> bool:
    """Does the robot look sad?"""
    return _shows(robot, Emotion.SADNESS)


def is_Surprised(robot: "Client") -> bool:
    """Does the robot look surprised?"""
    return _shows(robot, Emotion.SURPRISE)


def is_Disgust(robot: "Client") -> bool:
    """Does the robot look disgusted?"""
    return _shows(robot, Emotion.DISGUST)


def is_Angry(robot: "Client") -> bool:
    """Does the robot look angry?"""
    return _shows(robot, Emotion.ANGER)


def is_Scared(robot: "Client") -> bool:
    """Does the robot look scared?"""
    return _shows(robot, Emotion.FEAR)


def is_Neutral(robot: "Client") -> bool:
    """Does the robot look neutral after `expressNeutral`?"""
    return _shows(robot, Emotion.NEUTRAL)


def _express(robot: "Client", emotion: Emotion) -> None:
    display = robot.device(Display)
    if display is not None:
        display.show_emotion(emotion)


def _shows(robot: "Client", emotion: Emotion) -> bool:
    display = robot.device(Display)
    return display is not None and display.emotion is emotion
