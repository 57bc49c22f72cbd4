"""Speech and sounds."""

from typing import TYPE_CHECKING

from learnblock.devices import Speaker

if TYPE_CHECKING:
    from learnblock.client import Client


def say_Text(robot: "Client", text: str) -> None:
    """Say something aloud.

    Args:
        text: what to say.
    """
    speaker = robot.device(Speaker)
    if speaker is not None and not speaker.say(text):
        robot.note_missing("Speaker:say")


def play_audio(robot: "Client", audio: str = "Do") -> None:
    """Play one of the robot's sounds.

    Args:
        audio: the sound's name.
    """
    speaker = robot.device(Speaker)
    if speaker is not None and not speaker.play(audio):
        robot.note_missing("Speaker:play")


def play_frequency(robot: "Client", frequency: float, time: float) -> None:
    """Play a tone.

    Args:
        frequency: hertz; 440 is the note A.
        time: milliseconds.
    """
    speaker = robot.device(Speaker)
    if speaker is not None and not speaker.tone(frequency, time):
        robot.note_missing("Speaker:tone")
