import cv2
import numpy as np
import pytest

from learnblock.simulator.colours import reflectance, rgb


def hsv(name: str, shade: float = 1.0) -> tuple[int, int, int]:
    """Return OpenCV's hue, saturation and value of a colour in the shade."""
    pixel = np.array([[rgb(name)]], np.float64) * shade  # type: ignore[arg-type]
    hue, saturation, value = cv2.cvtColor(pixel.astype(np.uint8), cv2.COLOR_RGB2HSV)[0, 0]
    return int(hue), int(saturation), int(value)


@pytest.mark.parametrize("shade", [1.0, 0.75])
def test_line_colours_are_within_the_thresholds_of_the_skills(shade: float) -> None:
    red, blue = hsv("red", shade), hsv("blue", shade)

    assert red[0] <= 10 or red[0] >= 170
    assert min(red[1] - 50, red[2] - 100) > 0
    assert 100 <= blue[0] <= 130
    assert min(blue[1], blue[2]) > 50
    assert max(rgb("black")) * shade < 50


def test_reflectance_runs_from_black_to_white() -> None:
    assert reflectance((0, 0, 0)) == 0
    assert reflectance((255, 255, 255)) == pytest.approx(100)
