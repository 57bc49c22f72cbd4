import math

import numpy as np
import pytest

from learnblock.simulator.camera import CameraModel, CameraPose, Surface, render

LENS_HEIGHT = 100.0


def poster(texture, size, angle=0.0):
    """A square picture of `size` mm at (0, 0), as high as the lens.

    It faces west, turned by `angle` degrees anticlockwise seen from above.
    """
    half = size / 2
    x, y = half * math.sin(math.radians(angle)), half * math.cos(math.radians(angle))
    top, bottom = LENS_HEIGHT + half, LENS_HEIGHT - half
    return Surface(
        np.array([(-x, y, top), (x, -y, top), (x, -y, bottom), (-x, y, bottom)]), texture
    )


def room():
    wall = [(500, 3000, 1500), (500, -3000, 1500), (500, -3000, 0), (500, 3000, 0)]
    floor = [(-4000, 3000, 0), (500, 3000, 0), (500, -3000, 0), (-4000, -3000, 0)]
    return [
        Surface(np.array(wall, float), np.full((1, 1, 3), (190, 170, 140), np.uint8), "wall"),
        Surface(np.array(floor, float), np.full((1, 1, 3), (225, 225, 215), np.uint8), "floor"),
    ]


@pytest.fixture(scope="session")
def photograph():
    """Return a function that photographs a poster in a room with a sensor of mild noise."""
    surroundings = room()

    def take(
        texture,
        size,
        *,
        distance,
        generator,
        angle=0.0,
        focal=480.0,
        scale=1,
        sigma=2.0,
        aside=0.0,
        raised=0.0,
        heading=0.0,
        pitch=0.0,
    ):
        return render(
            [poster(texture, size, angle), *surroundings],
            CameraModel(320 * scale, 240 * scale, focal * scale),
            CameraPose(-distance, aside, LENS_HEIGHT + raised, heading, pitch),
            noise=(generator, sigma),
        )

    return take
