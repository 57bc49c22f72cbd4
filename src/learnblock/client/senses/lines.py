"""Dark lines: by ground sensors, by one sensor at the line's edge, or by a camera that looks down.

Ground sensors read 0 (dark) to 100.
"""

import math
from dataclasses import dataclass
from itertools import product
from typing import TYPE_CHECKING, Protocol

from learnblock.client.senses.heading import Heading
from learnblock.client.senses.sensed_robot import SensedRobot
from learnblock.devices import Base, GroundSensors, JointMotor, Pose

if TYPE_CHECKING:
    from learnblock.perception import LineView

#: A reading below this is dark; a white floor reads more than 90.
DARK, BRIGHT = 50.0, 100.0
#: Between these readings a sensor is at the edge of a line.
EDGE = (35.0, 65.0)
#: Millimetres from where a line was last seen at which it is lost.
LOST = 100.0
#: Degrees to look for a line to the side where it was found last, and then to the other side.
SEARCH = (45.0, 70.0)
#: Degrees to which a camera tilts to see a line, and the seconds that this takes.
FLOOR, TILTING = -30.0, 0.3
#: The position from which a line in the picture is on a side. Between the sides it is in the
#: centre, so a robot that turns towards a line always gets there, even if the line is oblique.
ASIDE = 40.0


class Line(Protocol):
    """Where a line is."""

    @property
    def is_there(self) -> bool: ...
    @property
    def is_left(self) -> bool: ...
    @property
    def is_center(self) -> bool: ...
    @property
    def is_right(self) -> bool: ...


@dataclass(frozen=True, slots=True)
class Sighting:
    """Where ground sensors see a line."""

    is_there: bool = False
    is_left: bool = False
    is_center: bool = False
    is_right: bool = False


NOWHERE = Sighting()
LEFT = Sighting(is_there=True, is_left=True)
CENTER = Sighting(is_there=True, is_center=True)
RIGHT = Sighting(is_there=True, is_right=True)


class LineEdge:
    """A black line, by ground sensors.

    A single sensor can't tell on which side a line is, but it can follow the line's right edge: at
    the edge the line is in the centre, darkness is too far to the left, so the way is to the right,
    and without darkness the line is to the left, until the robot has gone too far from it.

    Args:
        robot: the robot.
    """

    def __init__(self, robot: SensedRobot) -> None:
        self._robot = robot
        self._seen = _LastSeen(robot)

    def look(self) -> Sighting:
        readings = _readings(self._robot)
        if "left" in readings or "right" in readings:
            return _between(readings)
        brightness = readings.get("central", math.inf)
        if brightness > EDGE[1]:
            return LEFT if self._seen.is_near() else NOWHERE
        self._seen.note()
        return RIGHT if brightness < EDGE[0] else CENTER


class GroundLine:
    """A dark line under the robot, by ground sensors.

    A single sensor sees only whether the line is under it. Where it has lost the line it looks for
    it: first on the side where it found the line last, then on the other side.

    Args:
        robot: the robot.
        heading: its heading.
    """

    def __init__(self, robot: SensedRobot, heading: Heading) -> None:
        self._robot = robot
        self._heading = heading
        self._seen = _LastSeen(robot)
        #: The heading at which it lost the line; None while it sees the line.
        self._lost_at: float | None = None
        #: The side on which it looks first, -1 for the left and 1 for the right.
        self._first = -1

    def look(self) -> Sighting:
        readings = _readings(self._robot)
        if "left" in readings or "right" in readings:
            return _between(readings)
        if readings.get("central", math.inf) < DARK:
            self._find()
            return CENTER
        return self._search() if self._seen.is_near() else NOWHERE

    def _find(self) -> None:
        self._seen.note()
        if self._lost_at is not None:
            found_at = self._heading.read()
            self._first = 1 if found_at > self._lost_at else -1
            self._lost_at = None

    def _search(self) -> Sighting:
        heading = self._heading.read()
        if self._lost_at is None:
            self._lost_at = heading
            self._farthest = 0.0
        turned = (heading - self._lost_at) * self._first
        self._farthest = max(self._farthest, turned)
        if self._farthest < SEARCH[0]:
            return LEFT if self._first < 0 else RIGHT
        if turned > -SEARCH[1]:
            return RIGHT if self._first < 0 else LEFT
        return NOWHERE


class CameraLine:
    """A dark line, by a camera that looks at the floor.

    Args:
        robot: the robot.
    """

    def __init__(self, robot: SensedRobot) -> None:
        self._robot = robot

    def look(self) -> Sighting:
        """Where the line is, by its position."""
        view = self.view()
        if view is None or not view.is_there:
            return NOWHERE
        position = _position(view)
        return LEFT if position < -ASIDE else RIGHT if position > ASIDE else CENTER

    def view(self) -> "LineView | None":
        """The line in the picture; None without a picture."""
        self._look_down()
        lines = self._robot.detect("lines")
        return None if lines is None else lines.black

    def _look_down(self) -> None:
        """Tilt the camera to the floor, unless the program has already chosen where it looks."""
        robot = self._robot
        joint = robot.device(JointMotor, "CAMERA") if robot.has(JointMotor, "CAMERA") else None
        if joint is not None and joint.angle is None:
            joint.move(FLOOR)
            robot.clock.sleep(TILTING)
            robot.forget_readings()


class LinePosition:
    """How far to the side a black line is, from -100 (left) to 100 (right), for control loops.

    A robot that has lost the line gets the end of the side on which it was last.

    Args:
        robot: the robot.
        camera: the line in its camera's picture.
    """

    def __init__(self, robot: SensedRobot, camera: CameraLine) -> None:
        self._robot = robot
        self._camera = camera
        self._last = 0.0

    def by_camera(self) -> float:
        """From the shares of the line in the left and the right of the picture."""
        view = self._camera.view()
        return self._lost() if view is None or not view.is_there else self._seen(_position(view))

    def by_ground(self) -> float:
        """From the difference of both sensors, or from a single one at the line's right edge."""
        readings = _readings(self._robot)
        if not {"left", "right"} <= readings.keys():
            return self._seen(100 - 2 * readings.get("central", DARK))
        if min(readings.values()) > EDGE[1]:
            return self._lost()
        return self._seen(readings["left"] - readings["right"])

    def _seen(self, position: float) -> float:
        self._last = min(max(position, -100.0), 100.0)
        return self._last

    def _lost(self) -> float:
        return math.copysign(100.0, self._last)


class _LastSeen:
    """Where the robot was when it saw a line.

    Args:
        robot: the robot.
    """

    def __init__(self, robot: SensedRobot) -> None:
        self._robot = robot
        self._pose: Pose | None = None

    def note(self) -> None:
        """Remember that it sees the line here."""
        self._pose = self._now()

    def is_near(self) -> bool:
        """Whether it was close to here."""
        now = self._now()
        if now is None or self._pose is None:
            return False
        return math.dist(now[:2], self._pose[:2]) < LOST

    def _now(self) -> Pose | None:
        base = self._robot.device(Base)
        return None if base is None else base.pose()


def _position(view: "LineView") -> float:
    """From -100, all of a line in the left of the picture, to 100, all of it in the right."""
    return 100 * (view.right - view.left) / (view.left + view.center + view.right)


def _readings(robot: SensedRobot) -> dict[str, float]:
    """The readings of the sensors that the robot has."""
    readings = robot.read(GroundSensors) or {}
    return {side: value for side, value in readings.items() if value is not None}


def _between(readings: dict[str, float]) -> Sighting:
    """A line by several sensors: in the centre under the central one, or else under both others."""
    left = readings.get("left", BRIGHT) < DARK
    right = readings.get("right", BRIGHT) < DARK
    center = readings["central"] < DARK if "central" in readings else left and right
    return _SIGHTINGS[left, center, right]


def _sighting(*, left: bool, center: bool, right: bool) -> Sighting:
    """The line as it is seen by sensors that are dark."""
    is_left, is_right = left and not right, right and not left
    return Sighting(left or center or right, is_left, center, is_right)


_SIGHTINGS = {
    (left, center, right): _sighting(left=left, center=center, right=right)
    for left, center, right in product((False, True), repeat=3)
}
