"""What a robot's camera sees of a floor and of upright pictures on it."""

import numpy as np

from learnblock.simulator.camera import CameraModel, CameraPose, Surface, render
from learnblock.simulator.textures import floor

GROUND = (235, 235, 225)
#: A thing moves in 21 steps across the whole picture.
STEPS = np.linspace(-220, 220, 21)


def photograph(things=(), lines=(), *, tilt, scale=1):
    """Take a picture of a floor with lines, and of surfaces, with noise."""
    corners = [(-1000, 1000, 0), (1000, 1000, 0), (1000, -1000, 0), (-1000, -1000, 0)]
    ground = Surface(np.array(corners, float), floor((2000, 2000), GROUND, lines))
    model = CameraModel(320 * scale, 240 * scale, 290 * scale)
    noise = (np.random.default_rng(1), 2.0)
    return render([*things, ground], model, CameraPose(-300, 0, 100, 0, tilt), noise=noise)


def upright(picture, size, x, y, bottom):
    """An upright square picture at (x, y), which faces the camera to the west."""
    left, right, top = y + size / 2, y - size / 2, bottom + size
    corners = [(x, left, top), (x, right, top), (x, right, bottom), (x, left, bottom)]
    return Surface(np.array(corners, float), picture)
