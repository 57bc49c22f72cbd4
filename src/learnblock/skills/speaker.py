"""Speech and sounds."""

from typing import TYPE_CHECKING

from learnblock.devices import Speaker

if TYPE_CHECKING:
    from learnblock.client import Client


def say_Text(robot: "Client", text: str) -> None:
    """Start saying something aloud; the program continues meanwhile.

    Args:
        text: what to say.
    """
    speaker = robot.device(Speaker)
    if speaker is not None and not speaker.say(text):
        robot.note_missing("Speaker:say")


def play_audio(robot: "Client", audio: str = "Do") -> None:
    """Start a sound; the program continues meanwhile.

    Args:
        audio: a sound effect, such as coin, a note, such as Do, or one of the robot's own sounds.
    """
    speaker = robot.device(Speaker)
    if speaker is not None and not speaker.play(audio):
        robot.note_missing("Speaker:play")


def play_frequency(robot: "Client", frequency: float, time: float) -> None:
    """Start a tone; the program continues meanwhile.

    Args:
        frequency: hertz; 440 is the note A.
        time: milliseconds.
    """
    speaker = robot.device(Speaker)
    if speaker is not None and not speaker.tone(frequency, time):
        robot.note_missing("Speaker:tone")
