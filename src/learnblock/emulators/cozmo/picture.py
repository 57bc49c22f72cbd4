"""What Cozmo's camera sends: JPEG without its header, in pieces."""

import io
from collections.abc import Iterator
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image
from pycozmo import camera, protocol_encoder

PIECE = 1000
"""Bytes of picture in a packet; a frame holds 1037."""


def pieces(
    frame: NDArray[np.uint8], *, colour: bool, number: int, timestamp: int
) -> Iterator[protocol_encoder.ImageChunk]:
    """A frame as it goes over the wire.

    Args:
        frame: 320 by 240.
        colour: whether the robot was told to send colours; they come in half the width, and here as
            whole JPEG files, which the protocol has as well, while a real robot cuts their header
            off too.
        number: of the picture.
        timestamp: of the robot, in milliseconds.
    """
    kinds = protocol_encoder.ImageEncoding
    data = halved(frame) if colour else minimized(frame)
    parts = [data[start : start + PIECE] for start in range(0, len(data), PIECE)]
    for index, part in enumerate(parts):
        yield protocol_encoder.ImageChunk(
            frame_timestamp=timestamp,
            image_id=number,
            image_encoding=kinds.JPEGColorHalfWidth if colour else kinds.JPEGMinimizedGray,
            image_resolution=protocol_encoder.ImageResolution.QVGA,
            image_chunk_count=len(parts),
            chunk_id=index,
            data=part,
        )


def halved(frame: NDArray[np.uint8]) -> bytes:
    """A coloured picture of half the width, as JPEG."""
    height, width = frame.shape[:2]
    return _jpeg(Image.fromarray(frame).resize((width // 2, height)))


def minimized(frame: NDArray[np.uint8]) -> bytes:
    """A grey picture as the robot sends it: 0, and the coded pixels without escapes."""
    whole = _jpeg(Image.fromarray(frame).convert("L"))
    start = whole.index(b"\xff\xda")
    start += 2 + int.from_bytes(whole[start + 2 : start + 4], "big")
    coded = whole[start:].removesuffix(b"\xff\xd9")
    return b"\0" + coded.replace(b"\xff\0", b"\xff")


def _jpeg(picture: Any) -> bytes:
    file = io.BytesIO()
    # With the standard Huffman tables: the receiver's header has these and no others.
    picture.save(file, "JPEG", qtables=_quantization(), optimize=False)
    return file.getvalue()


@cache
def _quantization() -> Any:
    """The tables of the header that every receiver of this camera puts before its pictures."""
    header = camera.minigray_to_jpeg(np.zeros(1, np.uint8), 8, 8)
    picture: Any = Image.open(io.BytesIO(header.tobytes()))
    return picture.quantization
