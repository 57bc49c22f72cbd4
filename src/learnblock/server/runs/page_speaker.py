"""The loudspeaker of the page, for a robot that has none."""

import inspect
from collections.abc import Callable, Mapping, Sequence
from typing import Any

from learnblock.devices import notes
from learnblock.errors import LearnBlockError
from learnblock.server import messages
from learnblock.skills import music, speaker

#: Beats per minute before the program sets a tempo.
_USUAL_TEMPO = 120.0
_SKILLS = (
    *(speaker.say_Text, speaker.play_audio, speaker.play_frequency),
    *(music.play_note, music.set_tempo),
)
_SIGNATURES = {skill.__name__: inspect.signature(skill) for skill in _SKILLS}
_ACTIONS = {"say_Text": "say", "play_audio": "play", "play_frequency": "tone"}


class PageSpeaker:
    """Plays on the page what a robot without a loudspeaker would have played.

    Neither the robot nor the trace of the run is affected.

    Args:
        play: receives each sound.
    """

    def __init__(self, play: Callable[[messages.Sound], object]) -> None:
        self._play = play
        self._tempo = _USUAL_TEMPO
        self._asked: tuple[str, tuple[Any, ...]] = ("", ())

    def called(self, skill: str, args: Sequence[Any], kwargs: Mapping[str, Any]) -> None:
        """Remember what the program asks of a loudspeaker."""
        if skill not in _SIGNATURES:
            return
        try:
            given = _SIGNATURES[skill].bind(None, *args, **kwargs)
        except TypeError:
            # The program fails because of it.
            return
        given.apply_defaults()
        self._asked = skill, given.args[1:]
        if skill == "set_tempo":
            self._set_tempo(*given.args[1:])

    def missing(self, skill: str, device: str) -> None:
        """Play what the program has asked for last, if the robot can't."""
        asked, values = self._asked
        if skill != asked or not device.startswith("Speaker:"):
            return
        try:
            action, given = self._sound(skill, values)
        except LearnBlockError:
            return
        self._play(messages.Sound("Speaker", action, given, stand_in=True))

    def _sound(self, skill: str, values: tuple[Any, ...]) -> tuple[str, tuple[Any, ...]]:
        if skill == "play_note":
            note, beats = values
            return "tone", notes.tone_of(note, beats, self._tempo)
        return _ACTIONS[skill], values

    def _set_tempo(self, bpm: Any) -> None:
        try:
            self._tempo = notes.tempo_of(bpm)
        except LearnBlockError:
            # The program fails because of it.
            return
