"""The results of the detectors of faces and of emotions."""

from dataclasses import dataclass

from learnblock.perception.detections.points import Point


@dataclass(frozen=True, slots=True)
class Face:
    """A face in a frame, as the rectangle around it.

    Args:
        x: column of its left edge, pixels.
        y: row of its top edge, pixels.
        width: in pixels.
        height: in pixels.
        frame_width: in pixels.
        frame_height: in pixels.
    """

    x: int
    y: int
    width: int
    height: int
    frame_width: int = 320
    frame_height: int = 240

    @property
    def center(self) -> Point:
        """(column, row) of its middle."""
        return self.x + 0.5 * self.width, self.y + 0.5 * self.height

    @property
    def is_left(self) -> bool:
        """In the left third of the frame."""
        return self._column() == 0

    @property
    def is_right(self) -> bool:
        """In the right third of the frame."""
        return self._column() == 2

    @property
    def is_up(self) -> bool:
        """In the upper third of the frame."""
        return self._row() == 0

    @property
    def is_down(self) -> bool:
        """In the lower third of the frame."""
        return self._row() == 2

    @property
    def is_center(self) -> bool:
        """In the middle one of the frame's three by three cells."""
        return self._column() == 1 and self._row() == 1

    def _column(self) -> int:
        return min(2, int(3 * self.center[0] / self.frame_width))

    def _row(self) -> int:
        return min(2, int(3 * self.center[1] / self.frame_height))


@dataclass(frozen=True, slots=True)
class FaceEmotion:
    """A face in a frame and its emotion.

    Args:
        face: the face.
        emotion: ``fear``, ``surprise``, ``anger``, ``sadness``, ``disgust``, ``joy`` or
            ``neutral``, as in `learnblock.devices.Emotion`.
        confidence: how sure the classifier is, 0 to 1.
    """

    face: Face
    emotion: str
    confidence: float
