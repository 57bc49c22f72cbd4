"""Decode the pixels of Cozmo's screen, and recognize the emotion that they show."""

from functools import cache

import numpy as np
from numpy.typing import NDArray
from pycozmo import expressions

Pixels = NDArray[np.bool_]

EMOTIONS = {
    "anger": expressions.Anger,
    "disgust": expressions.Disgust,
    "fear": expressions.Fear,
    "joy": expressions.Happiness,
    "neutral": expressions.Neutral,
    "sadness": expressions.Sadness,
    "surprise": expressions.Surprise,
}
HEIGHT, WIDTH = 32, 128
LIKENESS = 40
"""The number of pixels, of 4096, by which a recognized face may differ."""
_SKIP, _REPEAT, _RUN = 0, 1, 2


def pixels(run_lengths: bytes) -> Pixels:
    """The screen, 32 rows of 128.

    It is drawn column by column. The two high bits of a byte are its kind: 0 for empty columns, 1
    for repetitions of the previous column, 2 and 3 for a run of 1 to 16 and of 17 to 32 pixels
    downwards, lit if one of the two low bits is set. The rest of an unfinished column is empty.
    (pycozmo.image_encoder; its decoder fails if a long run ends within a column)

    Raises:
        ValueError: the run lengths exceed the screen.
    """
    screen = np.zeros((HEIGHT, WIDTH), np.bool_)
    x = y = 0
    for byte in run_lengths:
        kind, count = byte >> 6, (byte & 0x3F) + 1
        if kind in {_SKIP, _REPEAT}:
            x, y = x + (y > 0), 0
            before = screen[:, x - 1 : x] if kind == _REPEAT and x else False
            screen[:, x : x + count] = before
            x += count
        else:
            length = ((byte & 0x3F) >> 2) + (1 if kind == _RUN else 17)
            if x >= WIDTH or y + length > HEIGHT:
                raise ValueError("an image exceeds the screen")
            screen[y : y + length, x] = bool(byte & 3)
            x, y = (x + 1, 0) if y + length == HEIGHT else (x, y + length)
    return screen


def emotion(screen: Pixels) -> str | None:
    """The emotion on the screen, ``none`` for an empty screen, None for another picture."""
    if not screen.any():
        return "none"
    name, pattern = min(_known().items(), key=lambda face: np.count_nonzero(face[1] != screen))
    return name if np.count_nonzero(pattern != screen) <= LIKENESS else None


@cache
def _known() -> dict[str, Pixels]:
    # The screen shows every other row of a face.
    return {name: np.array(face().render())[::2] for name, face in EMOTIONS.items()}
