"""What Cozmo's camera sends: JPEG without its header, in pieces."""

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
"""Bytes of picture in a packet; a frame holds 1037."""


def pieces(
    frame: NDArray[np.uint8], *, colour: bool, number: int, timestamp: int
) -> Iterator[protocol_encoder.ImageChunk]:
    """A frame as it goes over the wire.

    Args:
        frame: 320 by 240.
        colour: whether the robot was told to send colours; they come in half the width.
        number: of the picture.
        timestamp: of the robot, in milliseconds.
    """
    data = coloured(frame) if colour else grey(frame)
    parts = [data[start : start + PIECE] for start in range(0, len(data), PIECE)]
    for index, part in enumerate(parts):
        yield protocol_encoder.ImageChunk(
            frame_timestamp=timestamp,
            image_id=number,
            # Of coloured ones as well: their first byte tells.
            image_encoding=protocol_encoder.ImageEncoding.JPEGMinimizedGray,
            image_resolution=protocol_encoder.ImageResolution.QVGA,
            image_chunk_count=len(parts),
            chunk_id=index,
            data=part,
        )


def coloured(frame: NDArray[np.uint8]) -> bytes:
    """A picture of half the width: 1, and its coded pixels."""
    height, width = frame.shape[0], frame.shape[1] // 2
    file = _jpeg(Image.fromarray(frame).resize((width, height)), subsampling="4:2:2")
    return b"\1" + huffman.with_one_pair_of_tables(file, width, height)


def grey(frame: NDArray[np.uint8]) -> bytes:
    """A picture of full width: 0, and its coded pixels."""
    return b"\0" + huffman.scan(_jpeg(Image.fromarray(frame).convert("L")))


def _jpeg(picture: Any, **options: str) -> bytes:
    file = io.BytesIO()
    # With the standard Huffman tables: the receiver's header has these and no others.
    picture.save(file, "JPEG", qtables=_quantization(), optimize=False, **options)
    return file.getvalue()


@cache
def _quantization() -> Any:
    """The tables of the header that every receiver of this camera puts before its pictures."""
    header = camera.minigray_to_jpeg(np.zeros(1, np.uint8), 8, 8)
    picture: Any = Image.open(io.BytesIO(header.tobytes()))
    return picture.quantization
