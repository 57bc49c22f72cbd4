"""What a robot senses, by whichever of its devices serve a sense best.

A skill asks for a sense, not for a sensor, so that it has one meaning on every robot. The table of
the senses, with what can serve each of them, is `learnblock.senses`.
"""

from itertools import chain

from learnblock.client.senses.heading import Heading
from learnblock.client.senses.lines import (
    NOWHERE,
    CameraLine,
    GroundLine,
    Line,
    LineEdge,
    LinePosition,
)
from learnblock.client.senses.motion import Motion
from learnblock.client.senses.sensed_robot import SensedRobot
from learnblock.devices import NOTHING_SEEN, Bumper, Camera, DistanceSensors, LightSensor
from learnblock.senses import served_by

__all__ = ["Heading", "Line", "Senses"]

#: Levels of a light sensor, 0 to 1023, for one level of a picture, 0 to 255.
_LEVELS = 1023 / 255
#: Degrees to the right, by the sides of the sensors that see the nearest obstacle; where these
#: contradict each other, it is ahead.
_DIRECTIONS = {
    frozenset(("left",)): -90.0,
    frozenset(("left", "front")): -45.0,
    frozenset(("front", "right")): 45.0,
    frozenset(("right",)): 90.0,
    frozenset(("back",)): 180.0,
}


class Senses:
    """The senses of one robot.

    Args:
        robot: the robot.
    """

    def __init__(self, robot: SensedRobot) -> None:
        self._robot = robot
        self._heading = Heading(robot)
        self._edge = LineEdge(robot)
        self._ground_line = GroundLine(robot, self._heading)
        self._camera_line = CameraLine(robot)
        self._line_position = LinePosition(robot, self._camera_line)
        self._motion = Motion(robot)

    def heading(self) -> float | None:
        """Degrees turned to the right since `reset_heading`; None on a robot that can't tell."""
        return None if self._server("heading") is None else self._heading.read()

    def reset_heading(self) -> None:
        """Set the current heading to 0."""
        if self._server("heading") is not None:
            self._heading.reset()

    def line(self, colour: str) -> Line:
        """The line of a colour, ``black``, ``red`` or ``blue``, ahead of or under the robot.

        A camera looks at the floor for a black line, which sensors under other robots see as well.
        """
        server = self._server(f"{colour}-line")
        if server == "GroundSensors:line":
            return self._edge.look()
        if server == "Camera" and colour == "black":
            return self._camera_line.view() or NOWHERE
        lines = None if server is None else self._robot.detect("lines")
        line: Line = NOWHERE if lines is None else getattr(lines, colour)
        return line

    def line_position(self) -> float | None:
        """The position of the black line, -100 (left) to 100 (right); None without a sensor."""
        server = self._server("black-line")
        if server is None:
            return None
        position = self._line_position
        return position.by_camera() if server == "Camera" else position.by_ground()

    def ground_line(self) -> Line:
        """The dark line under the robot; a camera looks at the floor for it."""
        server = self._server("ground-line")
        if server is None:
            return NOWHERE
        return self._camera_line.look() if server == "Camera" else self._ground_line.look()

    def distance(self, side: str) -> float | None:
        """Millimetres to the nearest obstacle ``front``, ``left``, ``right`` or ``back``.

        2000 if there is none in sight; None on a robot that can't tell.
        """
        server = self._server(f"obstacle-{side}")
        if server is None:
            return None
        if server == "Bumper":
            # It feels only what it touches.
            return 0.0 if self._robot.read(Bumper) else NOTHING_SEEN
        readings = self._robot.read(DistanceSensors) or {}
        return min(readings.get(side, ()), default=None)

    def obstacle_direction(self) -> float | None:
        """Degrees to the right to the nearest obstacle in sight, in steps of 45.

        None if there is none, and on a robot that can't tell.
        """
        server = self._server("obstacle-front")
        if server == "Bumper":
            return 0.0 if self._robot.read(Bumper) else None
        readings = (self._robot.read(DistanceSensors) or {}) if server else {}
        nearest = min(chain.from_iterable(readings.values()), default=NOTHING_SEEN)
        if nearest >= NOTHING_SEEN:
            return None
        sides = frozenset(side for side, all_mm in readings.items() if nearest in all_mm)
        return _DIRECTIONS.get(sides, 0.0)

    def brightness(self) -> float | None:
        """The brightness around the robot, 0 (dark) to 1023; None on a robot that can't tell."""
        server = self._server("brightness")
        if server != "Camera":
            return None if server is None else self._robot.read(LightSensor)
        frame = self._robot.read(Camera)
        return None if frame is None else round(float(frame.mean()) * _LEVELS, 1)

    def is_shaken(self) -> bool:
        """Whether a person shakes the robot, now or in the last half second."""
        return self._server("shaking") is not None and self._motion.is_shaken()

    def tilt(self) -> tuple[float, float] | None:
        """Degrees by which its front and its left side are raised; None if it can't tell."""
        return None if self._server("tilting") is None else self._motion.tilt()

    def text_display(self) -> str | None:
        """The device that shows text, ``Matrix`` or ``Screen``; None on a robot without one."""
        return self._server("text-display")

    def _server(self, sense: str) -> str | None:
        """What serves a sense; that nothing does is reported."""
        server = served_by(sense, self._robot.equipment)
        if server is None:
            self._robot.note_missing(sense)
        return server
