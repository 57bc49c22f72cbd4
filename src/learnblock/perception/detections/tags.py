"""The results of the detector of tags."""

import math
from dataclasses import dataclass

from learnblock.perception.detections.points import Point

# A tag within this many pixels of the middle column is in the centre.
CENTRE_REACH = 40


@dataclass(frozen=True, slots=True)
class TagPose:
    """The position of a tag seen from the lens, and its rotation.

    Args:
        x: mm to the right of the lens's axis.
        y: mm below it.
        z: mm ahead.
        yaw: degrees, clockwise seen from above; 0 if the tag's face is perpendicular to the axis.
        pitch: degrees by which its upper edge leans away from the lens.
        roll: degrees, clockwise as the camera sees it; 0 if its first corner is at the top left.
    """

    x: float
    y: float
    z: float
    yaw: float
    pitch: float
    roll: float


@dataclass(frozen=True, slots=True)
class Tag:
    """An AprilTag of family 36h11 in a frame.

    Args:
        id: its number, 0 to 586.
        center: (column, row) in pixels.
        corners: (column, row) of the black square's top left, top right, bottom right and bottom
            left, named for a tag that is upright as `learnblock.simulator.textures.tag`
            draws it.
        pose: its pose relative to the lens; None if the lens or the tag's size is unknown.
        frame_width: in pixels.
        frame_height: in pixels.
    """

    id: int
    center: Point
    corners: tuple[Point, Point, Point, Point]
    pose: TagPose | None = None
    frame_width: int = 320
    frame_height: int = 240

    @property
    def distance(self) -> float | None:
        """The distance from the lens to its centre in mm; None if its pose is unknown."""
        return None if self.pose is None else math.hypot(self.pose.x, self.pose.y, self.pose.z)

    @property
    def offset(self) -> float:
        """Its offset from the middle column in pixels of a frame 320 wide; right is positive."""
        return (self.center[0] - 0.5 * (self.frame_width - 1)) * 320 / self.frame_width

    @property
    def is_left(self) -> bool:
        return self.offset < -CENTRE_REACH

    @property
    def is_right(self) -> bool:
        return self.offset > CENTRE_REACH

    @property
    def is_center(self) -> bool:
        return abs(self.offset) <= CENTRE_REACH
