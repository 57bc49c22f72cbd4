"""Worlds of a user, with and without a floor picture."""

import cv2
import numpy as np

ROOM = 'title = "Room"\n# A wall.\n[[wall]]\npoints = [[0, 0], [500, 0]]\n'
OTHER_ROOM = ROOM.replace("500", "400")
MAT = 'title = "Mat"\n[floor]\npicture = "mat.png"\n'


def png(width, height):
    return cv2.imencode(".png", np.zeros((height, width, 3), np.uint8))[1].tobytes()
