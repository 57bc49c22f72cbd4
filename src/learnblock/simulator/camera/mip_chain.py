"""A texture at all the sizes at which it is seen."""

from functools import cached_property

import cv2
import numpy as np

from learnblock.simulator.camera.vectors import Image
from learnblock.simulator.camera.window import Window


class MipChain:
    """A texture at 1/2, 1/4, ... of its size, each computed on first use.

    Args:
        texture: RGB, uint8, shape (height, width, 3).
    """

    def __init__(self, texture: Image) -> None:
        self._levels = {0: texture}
        #: Of a level, one channel, and where it has colours.
        self._greys: dict[int, Image] = {}
        self._coloured: dict[int, Window] = {}

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

    def level(self, number: int) -> Image:
        """The texture at 1/2**number of its size."""
        if number not in self._levels:
            finer = self.level(number - 1)
            height, width = (max(1, size // 2) for size in finer.shape[:2])
            # Bound to the same array even if two threads compute it at once.
            self._levels.setdefault(number, _shrunk(finer, width, height))
        return self._levels[number]

    def samples(self, number: int, region: Window) -> Image:
        """A level to take samples from: only one channel if the region is grey.

        Args:
            number: of the level.
            region: the texels that are needed.
        """
        return self.level(number) if self._has_colours(number, region) else self._grey(number)

    def complete(self) -> None:
        """Compute what cameras may need of it, so that processes forked from this one have it."""
        if not self.is_plain:
            for number in range(self.last + 1):
                self._grey(number)
                self._has_colours(number, Window(0, 0, 1, 1))

    def _grey(self, number: int) -> Image:
        """One channel of a level."""
        if number not in self._greys:
            self._greys.setdefault(number, np.ascontiguousarray(self.level(number)[..., 0]))
        return self._greys[number]

    def _has_colours(self, number: int, region: Window) -> bool:
        """Whether some texels of a region may not be black, white or what is between them."""
        if number not in self._coloured:
            self._coloured.setdefault(number, _coloured(self.level(number)))
        return self._coloured[number].meets(region)


def _coloured(texture: Image) -> Window:
    """The window around all texels that are not grey; empty if there are none."""
    red, green, blue = cv2.split(texture)
    different = cv2.bitwise_or(cv2.absdiff(red, green), cv2.absdiff(red, blue))
    left, top, width, height = cv2.boundingRect(different)
    return Window(left, top, left + width, top + height)


def _shrunk(texture: Image, width: int, height: int) -> Image:
    return np.asarray(cv2.resize(texture, (width, height), interpolation=cv2.INTER_AREA), np.uint8)
