"""Cozmo's screen: faces for emotions, pictures and texts."""

from functools import cache
from textwrap import wrap
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw, ImageFont, ImageOps
from pycozmo import expressions
from pycozmo.image_encoder import ImageEncoder

from learnblock.devices import Emotion

WIDTH, HEIGHT = 128, 64
"""The size of the screen in pixels; only every other row can be lit."""
LONGEST = 1000
"""The limit of an encoded picture in bytes; the robot drops frames of more than 1037 bytes."""
LARGEST_LETTERS, SMALLEST_LETTERS = 48, 12
"""Pixels."""

_FACES = {
    Emotion.ANGER: expressions.Anger,
    Emotion.DISGUST: expressions.Disgust,
    Emotion.FEAR: expressions.Fear,
    Emotion.JOY: expressions.Happiness,
    Emotion.NEUTRAL: expressions.Neutral,
    Emotion.SADNESS: expressions.Sadness,
    Emotion.SURPRISE: expressions.Surprise,
}


@cache
def emotion(name: str) -> bytes:
    """The face of an emotion, encoded for the screen; an empty screen for ``none``."""
    face = _FACES.get(Emotion(name))
    return _encoded(face().render() if face else Image.new("1", (WIDTH, HEIGHT)))


def picture(frame: NDArray[np.uint8]) -> bytes:
    """A picture (height, width, 3), as large as the screen allows, in black and white."""
    grey = ImageOps.pad(Image.fromarray(np.ascontiguousarray(frame)).convert("L"), (WIDTH, HEIGHT))
    blocks = (1, 2, 4, 8)
    # More detail takes more bytes: use the finest that fits into one frame.
    fitting = (coded for coded in (_coarse(grey, size) for size in blocks) if coded)
    return next(fitting)


def text(words: str) -> bytes:
    """A text in the largest letters with which it fits on the screen and into a frame."""
    screens = (_written(words, size) for size in range(LARGEST_LETTERS, SMALLEST_LETTERS, -2))
    fitting = (_encoded(screen) for screen in screens if screen)
    coded = next((candidate for candidate in fitting if len(candidate) <= LONGEST), None)
    return coded or text(words[: len(words) * 3 // 4])


def _written(words: str, size: int) -> Any | None:
    """The screen with a text in letters of a size; None if it does not fit."""
    font = ImageFont.load_default(size)
    columns = int(WIDTH / font.getlength("n"))
    lines = "\n".join(part for line in words.splitlines() for part in wrap(line, columns))
    screen = Image.new("1", (WIDTH, HEIGHT))
    pen = ImageDraw.Draw(screen)
    left, top, right, bottom = pen.multiline_textbbox((0, 0), lines, font, align="center")
    if right - left > WIDTH or bottom - top > HEIGHT:
        return None
    place = ((WIDTH - right - left) // 2, (HEIGHT - bottom - top) // 2)
    pen.multiline_text(place, lines, 1, font, align="center")
    return screen


def _coarse(grey: Any, block: int) -> bytes | None:
    """A picture in blocks of this many pixels, or None if it is still too large."""
    small = grey.resize((WIDTH // block, HEIGHT // block)).point(lambda level: 255 * (level > 127))
    coded = _encoded(small.resize((WIDTH, HEIGHT), Image.Resampling.NEAREST).convert("1"))
    return coded if len(coded) <= LONGEST else None


def _encoded(image: Any) -> bytes:
    rows = np.array(image)[::2]
    return bytes(ImageEncoder(Image.fromarray(rows)).encode())
