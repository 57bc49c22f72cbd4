"""What a robot without a loudspeaker would have played is heard on the page."""

import pytest

from learnblock.server import messages
from learnblock.server.runs.page_speaker import PageSpeaker


@pytest.fixture
def played():
    return []


@pytest.fixture
def speaker(played):
    return PageSpeaker(played.append)


@pytest.mark.parametrize(
    ("call", "action", "values"),
    [
        (("say_Text", ("hello",), {}), "say", ("hello",)),
        (("play_audio", (), {}), "play", ("Do",)),
        (("play_frequency", (440, 200), {}), "tone", (440, 200)),
        (("play_note", ("A4",), {"beats": 2}), "tone", (440.0, 900.0)),
    ],
)
def test_the_page_plays_what_the_robot_can_not(speaker, played, call, action, values):
    speaker.called(*call)
    speaker.missing(call[0], "Speaker:ROBOT")

    assert played == [messages.Sound("Speaker", action, values, stand_in=True)]


def test_a_note_has_the_tempo_of_the_program(speaker, played):
    speaker.called("set_tempo", (60,), {})
    speaker.called("play_note", ("A4", 1), {})
    speaker.missing("play_note", "Speaker:tone")

    assert played[0].values == (440.0, 900.0)


def test_what_the_robot_plays_itself_or_nobody_could_play_is_not_heard(speaker, played):
    speaker.called("play_note", ("A4", 1), {})
    speaker.called("expressJoy", (), {})
    speaker.missing("expressJoy", "Display:ROBOT")
    speaker.called("play_note", ("H4", 1), {})
    speaker.missing("play_note", "Speaker:tone")
    speaker.called("play_note", (1, 2, 3), {})
    speaker.called("set_tempo", ("fast",), {})

    assert played == []
