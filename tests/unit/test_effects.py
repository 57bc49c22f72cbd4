"""The sound effects of games: on the block, on the page and on robots that play sounds by name."""

import numpy as np
import pytest

from learnblock.blocks.known import all_configurations
from learnblock.devices.effects import EFFECTS
from learnblock.robots.cozmo import sound
from learnblock.robots.thymio import units

#: Seconds that an effect takes at most: a game goes on.
LONGEST = 1.5


def test_each_effect_is_in_the_menu_of_the_block():
    [audio] = all_configurations()["play_audio"].parameters
    assert [*EFFECTS] == [*audio.choices][: len(EFFECTS)]


@pytest.mark.parametrize("name", EFFECTS)
def test_a_cozmo_plays_an_effect_as_its_tones(name):
    samples = sound.named(name)
    length = sum(milliseconds for _, milliseconds in EFFECTS[name]) / 1000
    assert 0 < length <= LONGEST
    assert len(samples) == pytest.approx(length * sound.RATE, abs=len(EFFECTS[name]))
    assert np.abs(samples).max() > 10_000


@pytest.mark.parametrize("name", EFFECTS)
def test_a_thymio_plays_the_nearest_of_its_own_sounds(name):
    assert units.sound(name) in units.SOUNDS.values()
