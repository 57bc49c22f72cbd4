"""Decodes the pictures of Cozmo's camera."""

import io
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image
from pycozmo import camera, protocol_encoder

Frame = NDArray[np.uint8]


@dataclass(frozen=True, slots=True)
class ReceivedPicture:
    """A picture as received.

    Args:
        data: all pieces joined: a byte that is 1 for colours, and the coded pixels of a JPEG
            without its header.
        encoding: one of pycozmo's `ImageEncoding`.
        resolution: one of pycozmo's `ImageResolution`.
    """

    data: bytes
    encoding: Any
    resolution: Any

    def frame(self) -> Frame | None:
        """The picture as read-only uint8 RGB (240, 320, 3); None if it is damaged."""
        try:
            size = camera.RESOLUTIONS[self.resolution]
            file = io.BytesIO(self._with_header(*size))
            picture = Image.open(file, formats=("JPEG",)).convert("RGB")
            # Colour pictures have half the width.
            frame = np.asarray(picture if picture.size == size else picture.resize(size))
        except (LookupError, OSError, SyntaxError, ValueError):
            # The errors of libjpeg, pillow and numpy for invalid data.
            return None
        frame.flags.writeable = False
        return frame

    def _with_header(self, width: int, height: int) -> bytes:
        if self.encoding != protocol_encoder.ImageEncoding.JPEGMinimizedGray:
            raise ValueError(f"no robot sends {self.encoding}")
        pixels = np.frombuffer(self.data, np.uint8)
        if self.data[0]:
            return bytes(camera.minicolor_to_jpeg(pixels, width // 2, height))
        return bytes(camera.minigray_to_jpeg(pixels, width, height))
