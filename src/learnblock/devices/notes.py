"""Notes and beats as hertz and seconds."""

import re

from learnblock.devices.values import number
from learnblock.errors import UnknownNameError

#: The notes in a block's menu; others of the same form can be played as well.
NOTES = tuple(
    f"{name}{octave}"
    for octave in (3, 4, 5, 6)
    for name in (
        *("C", "C#", "Db", "D", "D#", "Eb", "E", "F", "F#", "Gb"),
        *("G", "G#", "Ab", "A", "A#", "Bb", "B"),
    )
)
#: Beats per minute.
SLOWEST, FASTEST = 20, 500

_NOTE = re.compile(r"([A-G])([#b]?)([0-8])")
_SEMITONES = {"C": 0, "D": 2, "E": 4, "F": 5, "G": 7, "A": 9, "B": 11}
_ACCIDENTALS = {"": 0, "#": 1, "b": -1}
#: The rest of a note's time is silent, so that equal notes are heard one after the other.
_SOUNDING = 0.9


def tempo_of(bpm: float) -> float:
    """The tempo in beats per minute, within the limits."""
    return min(max(number("bpm", bpm), SLOWEST), FASTEST)


def tone_of(note: str, beats: float, tempo: float) -> tuple[float, float]:
    """The hertz and milliseconds that are heard of a note.

    Args:
        note: its English name with the octave.
        beats: how long.
        tempo: in beats per minute.

    Raises:
        UnknownNameError: there is no such note.
    """
    seconds = seconds_of(beats, tempo)
    return _frequency(note), round(1000 * seconds * _SOUNDING, 3)


def _frequency(note: str) -> float:
    """The frequency of a note in hertz, in equal temperament with A4 at 440 Hz.

    >>> _frequency("A4"), _frequency("C4")
    (440.0, 261.63)

    Raises:
        UnknownNameError: there is no such note.
    """
    match = _NOTE.fullmatch(note) if isinstance(note, str) else None
    if match is None:
        raise UnknownNameError("note", str(note), NOTES)
    name, accidental, octave = match.groups()
    semitones = _SEMITONES[name] + _ACCIDENTALS[accidental] + 12 * (int(octave) - 4)
    return float(round(440 * 2 ** ((semitones - _SEMITONES["A"]) / 12), 2))


def seconds_of(beats: float, tempo: float) -> float:
    """How long a number of beats takes, in s."""
    return max(0.0, number("beats", beats)) * 60 / tempo
