"""Pictures for components: a tag and a face at known positions."""

import numpy as np

from learnblock.simulator.textures import face, tag

#: Columns and rows of the tag's centre.
TAG_AT = (230, 150)


def blank(height=240, width=320):
    return np.full((height, width, 3), 255, np.uint8)


def a_tag(number=8, height=240, width=320):
    frame = blank(height, width)
    column, row = TAG_AT
    frame[row - 40 : row + 40, column - 40 : column + 40] = tag(number)[:, :, :3]
    return frame


def a_face(emotion, pixels=140):
    frame = np.full((240, 320, 3), 200, np.uint8)
    frame[50 : 50 + pixels, 60 : 60 + pixels] = face(emotion, pixels)[:, :, :3]
    return frame
