"""Notes, by name and in beats."""

from typing import TYPE_CHECKING

from learnblock.devices import Speaker
from learnblock.devices.notes import seconds_of, tempo_of, tone_of

if TYPE_CHECKING:
    from learnblock.client import Client


def play_note(robot: "Client", note: str = "C4", beats: float = 1) -> None:
    """Play a note, then continue with the program.

    A robot without a loudspeaker waits as long.

    Args:
        note: the English name with the octave, from C0 to B8: C4 is middle C (do), F#4 is higher
            and Bb3 lower by a semitone.
        beats: how long; `set_tempo` sets how long a beat is.

    Raises:
        UnknownNameError: there is no such note.
    """
    hertz, milliseconds = tone_of(note, beats, robot.tempo)
    speaker = robot.device(Speaker)
    if speaker is not None and not speaker.tone(hertz, milliseconds):
        robot.note_missing("Speaker:tone")
    robot.clock.sleep(seconds_of(beats, robot.tempo))


def rest(robot: "Client", beats: float = 1) -> None:
    """Stay silent, then continue with the program.

    Args:
        beats: how long; `set_tempo` sets how long a beat is.
    """
    robot.clock.sleep(seconds_of(beats, robot.tempo))


def set_tempo(robot: "Client", bpm: float = 120) -> None:
    """Set how fast notes are played; without this it is 120 beats per minute.

    Args:
        bpm: beats per minute, 20 to 500.
    """
    robot.tempo = tempo_of(bpm)
