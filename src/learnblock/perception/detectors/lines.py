"""Black, red and blue lines, by the colours of pixels in three parts of a frame.

Lines are on the floor: what is inside of a tag or a face is none, and neither is a tag or a face
that the edge cuts.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

import cv2
import numpy as np
from numpy.typing import NDArray

from learnblock.perception.detections import Face, Lines, LineView, Tag
from learnblock.perception.detectors.cut_faces import CutSkin, cut_skin
from learnblock.perception.detectors.cut_tags import cut_tags
from learnblock.perception.frames import Frame, checked

if TYPE_CHECKING:
    from learnblock.perception.sight import Sight

Triple = tuple[int, int, int]

# Hue (0 to 180), saturation and value in OpenCV's units. Red is at both ends of the scale.
RED = (((0, 50, 100), (10, 255, 255)), ((170, 50, 100), (180, 255, 255)))
BLUE = (((100, 50, 50), (130, 255, 255)),)
COLOURS = {"red": RED, "blue": BLUE}
# Black is judged by a pixel's brightest channel, which is at most this; by luminance, pure blue is
# as dark.
BLACK = 50
# In a frame of 320 by 240: the searched region, and the pixels by which colours are dilated.
ROWS = (15, 225)
COLUMNS = (0, 120, 200, 320)
DILATION = 3
# The sides of the smallest blob, in pixels of a frame 240 high, for which tags and faces are
# searched. A line usually reaches the left, right or lower edge, so most frames have no blob.
BLOB = 10
# A tag has a white margin around its corners, of which this times its size is inside.
MARGIN = 1.15
# The blurred rim of a tag, in pixels of a frame 240 high.
BLURRED = 2
# The rim of a patch of skin, where it is redder, in pixels of a frame 240 high.
SKIN_RIM = 5
# A head is larger than its face by these shares of the face: hair, ears, neck and shoulders.
HEAD = (0.5, 0.5, 0.5, 0.9)

Masks = Mapping[str, cv2.typing.MatLike]


def look(sight: "Sight") -> Lines:
    pixels = _Pixels.of(sight.frame)
    masks = _masks(pixels)
    height = sight.frame.shape[0]
    if cv2.hasNonZero(masks["black"]):
        _erase(masks, cut_tags(pixels.brightest, BLACK), height, BLURRED)
    for name, outlines in (("tags", _tag_outlines), ("faces", _face_outlines)):
        if not _has_blob(masks, height):
            break
        _erase(masks, outlines(sight.detect(name)), height)
    # There is no face without skin, part of which is as red as a line.
    if "red" in masks and cv2.hasNonZero(masks["red"]):
        _erase_skin(masks, list(cut_skin(sight.frame)), height)
    return _lines(masks, sight.frame)


def detect_lines(frame: Frame) -> Lines:
    """Count black, red and blue pixels in the left, the centre and the right of a frame.

    Args:
        frame: RGB, uint8, shape (height, width, 3).

    Returns:
        The pixel counts; a colour without a line has few or none.

    Raises:
        FrameError: `frame` is not a picture.
    """
    return _lines(_masks(_Pixels.of(frame)), frame)


@dataclass(frozen=True, slots=True)
class _Pixels:
    """A frame, by channels.

    Args:
        frame: RGB.
        channels: red, green and blue.
        brightest: the brightest channel of each pixel.
    """

    frame: Frame
    channels: Sequence[cv2.typing.MatLike]
    brightest: cv2.typing.MatLike

    @classmethod
    def of(cls, frame: Frame) -> "_Pixels":
        channels = cv2.split(checked(frame))
        brightest = cv2.max(cv2.max(channels[0], channels[1]), channels[2])
        return cls(frame, channels, brightest)


def _lines(masks: Masks, frame: Frame) -> Lines:
    height, width = frame.shape[:2]
    views = (_view(colour, masks.get(colour), width, height) for colour in ("black", *COLOURS))
    return Lines(*views)


def _masks(pixels: _Pixels) -> Masks:
    """By colour a mask of the searched region, 255 where a line may be; absent if nowhere."""
    height = pixels.frame.shape[0]
    top, bottom = _rows(height)
    searched = pixels.brightest[top:bottom]
    masks = {"black": cv2.threshold(searched, BLACK, 255, cv2.THRESH_BINARY_INV)[1]}
    # Colours are dilated into the searched region from at most this many rows around it.
    reach = _reach(height)
    above = max(0, top - reach)
    around = slice(above, bottom + reach)
    channels = [channel[around] for channel in pixels.channels]
    if _may_have_colours(channels, pixels.brightest[around]):
        hsv = cv2.cvtColor(pixels.frame[around], cv2.COLOR_RGB2HSV)
        for colour, ranges in COLOURS.items():
            masks[colour] = _coloured(hsv, ranges, reach)[top - above :][: bottom - top]
    return masks


def _rows(height: int) -> tuple[int, int]:
    """Where the searched region begins and ends."""
    top, bottom = (round(row * height / 240) for row in ROWS)
    return top, bottom


def _has_blob(masks: Masks, height: int) -> bool:
    """Whether some colour has a blob as of a tag or a face: one that is not cut at an edge."""
    return any(_is_blob(mask, height) for mask in masks.values() if cv2.hasNonZero(mask))


def _is_blob(mask: cv2.typing.MatLike, height: int) -> bool:
    # Every other pixel is enough to see that.
    small = np.ascontiguousarray(mask[::2, ::2])
    rows, columns = small.shape
    smallest = BLOB * height / 240 / 2
    # The same boxes as of connected components, in a tenth of the time.
    contours, nesting = cv2.findContours(small, cv2.RETR_CCOMP, cv2.CHAIN_APPROX_SIMPLE)
    # What is around the contour of a hole is the contour of its component.
    surrounding = () if nesting is None else nesting[0, :, 3].tolist()
    boxes = (
        cv2.boundingRect(contour)
        for contour, around in zip(contours, surrounding, strict=True)
        if around < 0
    )
    # What reaches the upper end of the searched region may be whole in the frame.
    return any(
        x > 0 and x + w < columns and y + h < rows and min(w, h) >= smallest for x, y, w, h in boxes
    )


def _erase(
    masks: Masks, outlines: Iterator[NDArray[np.float64]], height: int, rim: int = 0
) -> None:
    """Erase what is within the outlines, and a rim of pixels, of a frame 240 high, around them."""
    top, _ = _rows(height)
    thickness = 1 + 2 * round(rim * height / 240)
    for outline in outlines:
        corners = np.rint(outline - (0, top)).astype(np.int32)
        for mask in masks.values():
            cv2.fillConvexPoly(mask, corners, 0)
            if rim:
                cv2.polylines(mask, [corners], isClosed=True, color=0, thickness=thickness)


def _erase_skin(masks: Masks, patches: Sequence[CutSkin], height: int) -> None:
    """Erase faces; of other things that have the colour of skin, what is red."""
    _erase(masks, (skin.outline for skin in patches if skin.is_face), height)
    others = (skin.outline for skin in patches if not skin.is_face)
    _erase({"red": masks["red"]}, others, height, SKIN_RIM)


def _tag_outlines(tags: Sequence[Tag]) -> Iterator[NDArray[np.float64]]:
    for tag in tags:
        center = np.array(tag.center)
        yield center + MARGIN * (np.array(tag.corners) - center)


def _face_outlines(faces: Sequence[Face]) -> Iterator[NDArray[np.float64]]:
    left, above, right, below = HEAD
    for face in faces:
        x, end = face.x - left * face.width, face.x + (1 + right) * face.width
        y, bottom = face.y - above * face.height, face.y + (1 + below) * face.height
        yield np.array([(x, y), (end, y), (end, bottom), (x, bottom)])


def _reach(height: int) -> int:
    return max(1, round(DILATION * height / 240))


def _may_have_colours(
    channels: Sequence[cv2.typing.MatLike], brightest: cv2.typing.MatLike
) -> bool:
    """Whether any pixel may be red or blue: most floors are grey, and most lines black.

    A saturation of 50 means that the channels differ by almost a fifth of the brightest one.

    Args:
        channels: red, green and blue.
        brightest: the brightest channel of each pixel.
    """
    red, green, blue = channels
    difference = cv2.subtract(brightest, cv2.min(cv2.min(red, green), blue))
    if not cv2.hasNonZero(difference):
        return False
    return cv2.hasNonZero(cv2.subtract(difference, cv2.convertScaleAbs(brightest, alpha=0.18)))


def _coloured(
    hsv: cv2.typing.MatLike, ranges: Sequence[tuple[Triple, Triple]], reach: int
) -> cv2.typing.MatLike:
    """A mask, 255 if a pixel is within one of the ranges, dilated."""
    mask = cv2.inRange(hsv, *ranges[0])
    for low, high in ranges[1:]:
        mask = cv2.bitwise_or(mask, cv2.inRange(hsv, low, high))
    if not cv2.hasNonZero(mask):
        return mask
    return cv2.dilate(mask, np.ones((3, 3), np.uint8), iterations=reach)


def _view(colour: str, mask: cv2.typing.MatLike | None, width: int, height: int) -> LineView:
    if mask is None:
        return LineView(colour, 0, 0, 0, width, height)
    borders = [round(column * width / 320) for column in COLUMNS]
    left, center, right = (
        cv2.countNonZero(mask[:, begin:end]) if begin < end else 0
        for begin, end in pairwise(borders)
    )
    return LineView(colour, left, center, right, width, height)
