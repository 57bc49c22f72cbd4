"""A texture at all the sizes at which it is seen."""

from functools import cached_property

import cv2
import numpy as np

from learnblock.simulator.camera.vectors import Image


class MipChain:
    """A texture at 1/2, 1/4, ... of its size, each computed on first use.

    Args:
        texture: RGB, uint8, shape (height, width, 3).
    """

    def __init__(self, texture: Image) -> None:
        self._levels = {0: texture}
        self._samples: dict[int, Image] = {}

    @property
    def last(self) -> int:
        """The level whose longer side is a single pixel."""
        return int(max(self._levels[0].shape[:2]).bit_length()) - 1

    @cached_property
    def is_plain(self) -> bool:
        """Whether the texture has the same colour everywhere."""
        texture = self._levels[0]
        colour = tuple(texture[0, 0].tolist())
        same = cv2.inRange(texture, colour, colour)
        return cv2.countNonZero(same) == same.size

    @cached_property
    def is_grey(self) -> bool:
        """Whether the texture has no colours, only black, white and what is between them."""
        red, green, blue = cv2.split(self._levels[0])
        return not any(cv2.hasNonZero(cv2.absdiff(red, other)) for other in (green, blue))

    def level(self, number: int) -> Image:
        """The texture at 1/2**number of its size."""
        if number not in self._levels:
            finer = self.level(number - 1)
            height, width = (max(1, size // 2) for size in finer.shape[:2])
            # Bound to the same array even if two threads compute it at once.
            self._levels.setdefault(number, _shrunk(finer, width, height))
        return self._levels[number]

    def samples(self, number: int) -> Image:
        """A level to take samples from: of a grey texture only one channel, a third of the work."""
        if number not in self._samples:
            level = self.level(number)
            channels = np.ascontiguousarray(level[..., 0]) if self.is_grey else level
            self._samples.setdefault(number, channels)
        return self._samples[number]


def _shrunk(texture: Image, width: int, height: int) -> Image:
    return np.asarray(cv2.resize(texture, (width, height), interpolation=cv2.INTER_AREA), np.uint8)
