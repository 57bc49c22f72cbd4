"""A camera's picture for a person: a JPEG file, and the findings of perception."""

from collections.abc import Callable, Iterator, Mapping
from typing import TYPE_CHECKING, Any

from learnblock.monitor.monitor import Picture, Seen
from learnblock.perception import ColouredObject, Face, FaceEmotion, Lines, LineView, Sight, Tag
from learnblock.perception.settings import TABLE

if TYPE_CHECKING:
    from learnblock.perception.frames import Frame

#: JPEG quality of 100: half the bytes of 95, with no visible difference in such a small picture.
JPEG_QUALITY = 80
#: The columns and rows, of a frame of 320 by 240, in which lines are detected.
_COLUMNS = {"left": (0, 120), "center": (120, 200), "right": (200, 320)}
_ROWS = (15, 225)

Corners = tuple[tuple[float, float], ...]


def develop(frame: "Frame", time: float, *, drawn: bool) -> Picture:
    """A camera's frame as a picture, marked with the findings of the detectors that are on.

    Args:
        frame: RGB.
        time: the robot's time in s.
        drawn: whether the camera sees only drawn and simulated faces.

    Raises:
        SettingsError: the settings of camera recognition are invalid.
    """
    height, width = frame.shape[:2]
    sight, settings = Sight(frame), TABLE.load()
    findings = tuple(
        finding
        for name, describe in _FINDINGS.items()
        if settings.permits(name, drawn=drawn)
        for finding in describe(sight.detect(name))
    )
    return Picture(_jpeg(frame), width, height, time, findings)


def found(detected: Mapping[str, Any]) -> tuple[Seen, ...] | None:
    """What detectors have found, by their names; None if none was asked.

    Emotions are found in faces.
    """
    if not detected:
        return None
    results = {**detected}
    if "emotions" in results:
        results.pop("faces", None)
    return tuple(
        finding
        for name, describe in _ASKED.items()
        if name in results
        for finding in describe(results[name])
    )


def png(image: "Frame") -> bytes:
    """An RGB image as a PNG file."""
    import cv2  # noqa: PLC0415 - loaded with the first picture

    return cv2.imencode(".png", cv2.cvtColor(image, cv2.COLOR_RGB2BGR))[1].tobytes()


def _jpeg(image: "Frame") -> bytes:
    import cv2  # noqa: PLC0415 - as above

    bgr = cv2.cvtColor(image, cv2.COLOR_RGB2BGR)
    return cv2.imencode(".jpg", bgr, [cv2.IMWRITE_JPEG_QUALITY, JPEG_QUALITY])[1].tobytes()


def _tags(tags: tuple[Tag, ...]) -> Iterator[Seen]:
    return (Seen("tag", str(tag.id), tag.corners) for tag in tags)


def _faces(faces: tuple[FaceEmotion, ...]) -> Iterator[Seen]:
    return (Seen("face", face.emotion, _box(face.face)) for face in faces)


def _plain_faces(faces: tuple[Face, ...]) -> Iterator[Seen]:
    return (Seen("face", "", _box(face)) for face in faces)


def _objects(objects: tuple[ColouredObject, ...]) -> Iterator[Seen]:
    return (Seen("object", detected.colour, _box(detected)) for detected in objects)


def _lines(lines: Lines) -> Iterator[Seen]:
    return (_line(view) for view in (lines.black, lines.red, lines.blue) if view.is_there)


def _line(view: LineView) -> Seen:
    side = "left" if view.is_left else "right" if view.is_right else "center"
    left, right = (column * view.frame_width / 320 for column in _COLUMNS[side])
    top, bottom = (row * view.frame_height / 240 for row in _ROWS)
    return Seen("line", f"{view.colour} {side}", _rectangle(left, top, right, bottom))


def _box(detection: Face | ColouredObject) -> Corners:
    left, top = float(detection.x), float(detection.y)
    return _rectangle(left, top, left + detection.width, top + detection.height)


def _rectangle(left: float, top: float, right: float, bottom: float) -> Corners:
    return ((left, top), (right, top), (right, bottom), (left, bottom))


_FINDINGS: dict[str, Callable[[Any], Iterator[Seen]]] = {
    "tags": _tags,
    "emotions": _faces,
    "lines": _lines,
}
#: What only a program asks for, too.
_ASKED: dict[str, Callable[[Any], Iterator[Seen]]] = {
    **_FINDINGS,
    "faces": _plain_faces,
    "objects": _objects,
}
