"""Components that search pictures in place of our detectors."""

from abc import abstractmethod
from itertools import islice
from typing import Any, ClassVar

import cv2
import numpy as np

from learnblock.closing import Closing
from learnblock.errors import IceError, IceLinkError, IceRefusedError, RobotConnectionError
from learnblock.ice.endpoint import Endpoint
from learnblock.ice.proxy import Proxy
from learnblock.ice.robocomp import Layout, interfaces
from learnblock.ice.robocomp.recognition import FoundEmotion, FoundTag
from learnblock.perception import Detections, Face, FaceEmotion, Sight, Tag
from learnblock.perception.frames import Frame
from learnblock.perception.robocomp.labels import emotion_of
from learnblock.perception.robocomp.pictures import PixelOrder, packed

#: Findings in a picture beyond this number are left out.
MOST_FOUND = 100
#: Tags of the family 36h11.
TAGS = 587


class Asked(Closing):
    """A detector that uses a component: a context manager.

    It connects when it is first used, and again after the link breaks.

    Args:
        host: the component's host.
        port: the port on which it listens.
        order: which of a picture's numbers it reads as the rows; None detects it if possible.
        timeout: limit of a call in seconds.
    """

    #: The names of the detector and of the Ice object.
    name: ClassVar[str]
    identity: ClassVar[str]

    def __init__(
        self, host: str, port: int, *, order: PixelOrder | None = None, timeout: float = 2.0
    ) -> None:
        interface = interfaces(Layout.TOOL)[self.identity]
        self._proxy = Proxy(interface, self.identity, Endpoint(host, port, timeout))
        self._order = order
        self._is_known = False

    def detect(self, sight: Sight) -> Detections:
        """Have the component search a frame.

        Raises:
            RobotConnectionError: it cannot be reached, does not answer in time, or is a different
                component.
        """
        try:
            if not self._is_known:
                self._get_to_know()
            answer = self._ask(sight.frame)
        except IceError as error:
            raise self._error(error) from error
        return self._understood(list(islice(answer, MOST_FOUND)), sight.frame)

    def close(self) -> None:
        """Close the connection; calling it twice is harmless."""
        self._proxy.close()

    def find_order(self) -> PixelOrder:
        """Find out which order the component reads, if its answers show that.

        Raises:
            IceError: it cannot be reached, or refuses the call.
        """
        return PixelOrder.ROWS

    @abstractmethod
    def _understood(self, answer: list[Any], frame: Frame) -> Detections:
        """Convert the findings to our detections."""

    def _get_to_know(self) -> None:
        self._proxy.check()
        self._order = self._order or self.find_order()
        self._is_known = True

    def _ask(self, frame: Frame, order: PixelOrder | None = None) -> Any:
        picture = packed(frame, order or self._order or PixelOrder.ROWS)
        return self._proxy.call("processimage", picture)

    def _error(self, error: IceError) -> RobotConnectionError:
        unreachable, refused = "perception-component-unreachable", "perception-component-refused"
        return RobotConnectionError(
            unreachable if isinstance(error, IceLinkError) else refused,
            component=self.identity,
            address=str(self._proxy.endpoint),
            reason=error.phrase,
        )


class AskedTags(Asked):
    """Apriltag."""

    name = "tags"
    identity = "apriltag"

    def find_order(self) -> PixelOrder:
        """Send it a tag, whose position it finds only if it reads the numbers as we do."""
        picture = _picture_of_a_tag()
        fitting = (order for order in PixelOrder if self._finds_the_tag(picture, order))
        return next(fitting, PixelOrder.ROWS)

    def _finds_the_tag(self, picture: Frame, order: PixelOrder) -> bool:
        try:
            tags = islice(self._ask(picture, order), MOST_FOUND)
        except IceRefusedError:
            # It may refuse a picture whose size it misreads.
            return False
        return any(_is_shown(face) for face in tags)

    def _understood(self, answer: list[FoundTag], frame: Frame) -> tuple[Tag, ...]:
        height, width = frame.shape[:2]
        seen = [
            # The interface does not give the corners.
            Tag(tag.id, center, (center,) * 4, frame_width=width, frame_height=height)
            for tag in answer
            if 0 <= tag.id < TAGS and 0 <= tag.cx < width and 0 <= tag.cy < height
            for center in [(float(tag.cx), float(tag.cy))]
        ]
        return tuple(sorted(seen, key=lambda tag: (tag.id, tag.center)))


class AskedEmotions(Asked):
    """EmotionRecognition."""

    name = "emotions"
    identity = "emotionrecognition"

    def _understood(self, answer: list[FoundEmotion], frame: Frame) -> tuple[FaceEmotion, ...]:
        faces = [
            # The interface does not give a confidence.
            FaceEmotion(face, emotion, confidence=1.0)
            for face_seen in answer
            if (emotion := emotion_of(face_seen.emotion)) and (face := _face(face_seen, frame))
        ]
        return tuple(sorted(faces, key=lambda emotion: (emotion.face.x, emotion.face.y)))


#: The tag in the picture that detects the order: id, column and row of its centre.
_SHOWN = FoundTag(id=7, cx=230, cy=150)
_SIDE = 100
#: The tolerance for a found tag's position, in pixels.
_NEAR = 10


def _picture_of_a_tag() -> Frame:
    family = cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_APRILTAG_36h11)
    tag = cv2.aruco.generateImageMarker(family, _SHOWN.id, _SIDE)
    frame = np.full((240, 320, 3), 255, np.uint8)
    left, top = _SHOWN.cx - _SIDE // 2, _SHOWN.cy - _SIDE // 2
    frame[top : top + _SIDE, left : left + _SIDE] = tag[:, :, None]
    return frame


def _is_shown(tag: FoundTag) -> bool:
    near = max(abs(tag.cx - _SHOWN.cx), abs(tag.cy - _SHOWN.cy)) <= _NEAR
    return tag.id == _SHOWN.id and near


def _face(emotion: FoundEmotion, frame: Frame) -> Face | None:
    """The part of a face's rectangle that is in the frame; None if none of it is."""
    height, width = frame.shape[:2]
    left, top = max(emotion.x, 0), max(emotion.y, 0)
    right, bottom = min(emotion.x + emotion.w, width), min(emotion.y + emotion.h, height)
    if right <= left or bottom <= top:
        return None
    return Face(left, top, right - left, bottom - top, width, height)
