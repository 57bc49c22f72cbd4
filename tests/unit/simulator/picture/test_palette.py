import numpy as np
import pytest

from learnblock.simulator.picture.palette import WHITE, is_dark, time_colour


def lightness(colour: tuple[int, int, int]) -> float:
    """Return L* of CIE 1976, from sRGB (IEC 61966-2-1)."""
    level = np.array(colour) / 255
    linear = np.where(level <= 0.04045, level / 12.92, ((level + 0.055) / 1.055) ** 2.4)
    luminance = float(linear @ (0.2126, 0.7152, 0.0722))
    return 116 * float(np.cbrt(luminance)) - 16


def test_later_is_always_lighter_and_by_even_steps():
    levels = [lightness(time_colour(part)) for part in np.linspace(0, 1, 8)]
    steps = np.diff(levels)
    assert steps.min() > 0.6 * steps.mean()
    assert steps.max() < 1.4 * steps.mean()


def test_the_latest_colour_is_visible_on_a_white_floor():
    assert lightness(time_colour(1.0)) == pytest.approx(75, abs=3)


def test_white_is_not_dark():
    assert not is_dark(WHITE)
    assert is_dark((20, 20, 20))
