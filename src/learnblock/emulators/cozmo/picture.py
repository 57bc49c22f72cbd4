"""Encode pictures as Cozmo's camera does: JPEG without its header, in pieces."""

import io
from collections.abc import Iterator
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image
from pycozmo import camera, protocol_encoder

from learnblock.emulators.cozmo import huffman

PIECE = 1000
"""The bytes of a picture in a packet; a frame has room for 1037."""


def pieces(
    frame: NDArray[np.uint8], *, colour: bool, number: int, timestamp: int
) -> Iterator[protocol_encoder.ImageChunk]:
    """Encode a frame as packets.

    Args:
        frame: 320 by 240 pixels.
        colour: send colours, at half the width, instead of grey.
        number: the picture's number.
        timestamp: the robot's time in milliseconds.
    """
    data = coloured(frame) if colour else grey(frame)
    parts = [data[start : start + PIECE] for start in range(0, len(data), PIECE)]
    for index, part in enumerate(parts):
        yield protocol_encoder.ImageChunk(
            frame_timestamp=timestamp,
            image_id=number,
            # Also for coloured ones, which their first byte marks.
            image_encoding=protocol_encoder.ImageEncoding.JPEGMinimizedGray,
            image_resolution=protocol_encoder.ImageResolution.QVGA,
            image_chunk_count=len(parts),
            chunk_id=index,
            data=part,
        )


def coloured(frame: NDArray[np.uint8]) -> bytes:
    """A picture of half the width: 1, then its coded pixels."""
    height, width = frame.shape[0], frame.shape[1] // 2
    file = _jpeg(Image.fromarray(frame).resize((width, height)), subsampling="4:2:2")
    return b"\1" + huffman.with_one_pair_of_tables(file, width, height)


def grey(frame: NDArray[np.uint8]) -> bytes:
    """A picture of full width: 0, then its coded pixels."""
    return b"\0" + huffman.scan(_jpeg(Image.fromarray(frame).convert("L")))


def _jpeg(picture: Any, **options: str) -> bytes:
    file = io.BytesIO()
    # The receiver's header contains only the standard Huffman tables.
    picture.save(file, "JPEG", qtables=_quantization(), optimize=False, **options)
    return file.getvalue()


@cache
def _quantization() -> Any:
    """The tables of the header that every receiver of this camera adds to its pictures."""
    header = camera.minigray_to_jpeg(np.zeros(1, np.uint8), 8, 8)
    picture: Any = Image.open(io.BytesIO(header.tobytes()))
    return picture.quantization
