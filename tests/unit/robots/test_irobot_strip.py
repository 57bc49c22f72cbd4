"""What Root's colour strip sees before it has reported a change."""

import struct

import pytest

from learnblock.robots.irobot import messages
from learnblock.robots.irobot.strip import first_look

WHITE, BLACK = messages.WHITE, messages.BLACK
LINE = [100] * 12 + [5] * 7 + [100] * 13
SEEN = [WHITE] * 12 + [BLACK] * 7 + [WHITE] * 13


class Answering:
    """A link to a strip: `levels` by sensor, of 100, as counts that rise or fall with light."""

    def __init__(self, levels, dark=150, gain=18.0, banks=messages.BANKS):
        self._levels, self._dark, self._gain, self._banks = levels, dark, gain, banks

    def probe(self, question):
        bank, lighting, _ = question.payload
        if bank >= self._banks:
            return None
        gain = self._gain if lighting == messages.ALL_LIT else 0
        return struct.pack(
            ">8H", *(round(self._dark + gain * level) for level in self._levels[8 * bank :][:8])
        )


@pytest.mark.parametrize("link", [Answering(LINE), Answering(LINE, dark=4000, gain=-30)])
def test_a_line_is_seen_whether_counts_rise_or_fall_with_light(link):
    assert first_look(link) == SEEN


@pytest.mark.parametrize("level", [100, 5, 0])
def test_a_floor_of_one_brightness_counts_as_white(level):
    assert first_look(Answering([level] * messages.COLOURS)) == [WHITE] * messages.COLOURS


@pytest.mark.parametrize("banks", [0, 2, 3])
def test_firmware_that_does_not_answer_sees_white(banks):
    assert first_look(Answering(LINE, banks=banks)) == [WHITE] * messages.COLOURS


def test_a_line_of_a_dark_colour_counts_as_dark():
    red = [level if level == 100 else 35 for level in LINE]
    assert first_look(Answering(red)) == SEEN
