"""Draws faces and texts for RCIS's screen, which has none built in."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from textwrap import wrap
from typing import TYPE_CHECKING

import cv2
import numpy as np

from learnblock.robots.plain_letters import in_ascii

if TYPE_CHECKING:
    from learnblock.devices import Frame

WIDTH, HEIGHT = 480, 320
"""The size of EBO's screen."""
_WHITE, _BLACK = (255, 255, 255), (0, 0, 0)
_FONT = cv2.FONT_HERSHEY_SIMPLEX
_TEXT_SCALES = (3.0, 2.0, 1.4, 1.0, 0.8)
_EYES = (160, 320)
_EYE_LEVEL, _BROW_LEVEL, _MOUTH_LEVEL = 140, 80, 235


@dataclass(frozen=True, slots=True)
class _Look:
    """An expression; lengths are in pixels.

    Args:
        eye: half the height of an eye.
        brow: how far the inner end of a brow is above its outer end.
        mouth: how far the corners of the mouth are above its middle.
        gap: how far the mouth is open.
    """

    eye: int = 34
    brow: int = 0
    mouth: int = 0
    gap: int = 0


_LOOKS: Mapping[str, _Look] = {
    "joy": _Look(eye=34, brow=0, mouth=45),
    "sadness": _Look(eye=26, brow=25, mouth=-40),
    "surprise": _Look(eye=48, brow=10, gap=40),
    "anger": _Look(eye=28, brow=-32, mouth=-22),
    "fear": _Look(eye=44, brow=30, mouth=-15, gap=18),
    "disgust": _Look(eye=16, brow=-18, mouth=-32),
    "neutral": _Look(),
    "none": _Look(),
}


@cache
def draw_face(emotion: str) -> "Frame":
    """A symmetric, read-only face that shows an emotion."""
    look = _LOOKS[emotion]
    face = np.full((HEIGHT, WIDTH, 3), 255, np.uint8)
    for middle, inwards in zip(_EYES, (1, -1), strict=True):
        cv2.ellipse(face, (middle, _EYE_LEVEL), (34, look.eye), 0, 0, 360, _BLACK, -1)
        cv2.circle(face, (middle, _EYE_LEVEL), 6, _WHITE, -1)
        outer = middle - inwards * 40, _BROW_LEVEL + look.brow // 2
        inner = middle + inwards * 40, _BROW_LEVEL - look.brow // 2
        cv2.line(face, outer, inner, _BLACK, 10)
    _draw_mouth(face, look)
    face.flags.writeable = False
    return face


def draw_text(text: str) -> "Frame":
    """A text in the largest letters with which it fits on the screen."""
    for scale in _TEXT_SCALES:
        (widest, _), _ = cv2.getTextSize("W", _FONT, scale, 2)
        height, columns = int(40 * scale), (WIDTH - 20) // widest
        lines = [
            part for paragraph in in_ascii(text).splitlines() for part in wrap(paragraph, columns)
        ]
        if len(lines) * height <= HEIGHT:
            break
    screen = np.full((HEIGHT, WIDTH, 3), 255, np.uint8)
    top = (HEIGHT - len(lines) * height) // 2
    for row, line in enumerate(lines):
        (width, _), _ = cv2.getTextSize(line, _FONT, scale, 2)
        place = (WIDTH - width) // 2, top + int((row + 0.75) * height)
        cv2.putText(screen, line, place, _FONT, scale, _BLACK, 2, cv2.LINE_AA)
    return screen


def _draw_mouth(face: "Frame", look: _Look) -> None:
    middle = WIDTH // 2, _MOUTH_LEVEL
    if look.gap:
        cv2.ellipse(face, middle, (40, look.gap), 0, 0, 360, _BLACK, 6)
    elif look.mouth:
        # The lower half of an ellipse smiles, the upper one frowns.
        begin = 0 if look.mouth > 0 else 180
        cv2.ellipse(face, middle, (80, abs(look.mouth)), 0, begin, begin + 180, _BLACK, 8)
    else:
        cv2.line(face, (middle[0] - 80, middle[1]), (middle[0] + 80, middle[1]), _BLACK, 8)
