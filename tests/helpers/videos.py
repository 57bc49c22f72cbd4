"""Videos that tests record."""

import cv2
import numpy as np


def record(path, frames, rate=10):
    """Write RGB frames as a video."""
    height, width = frames[0].shape[:2]
    writer = cv2.VideoWriter(str(path), cv2.VideoWriter_fourcc(*"MJPG"), rate, (width, height))
    for frame in frames:
        writer.write(np.ascontiguousarray(frame[:, :, ::-1]))
    writer.release()
    return path


def shades(count, height=48, width=64):
    """Return frames of one shade each, each 20 lighter than the one before."""
    return [np.full((height, width, 3), 20 * number, np.uint8) for number in range(count)]


def number_of(frame):
    """Return which of `shades` a frame shows."""
    return round(float(frame.mean()) / 20)
