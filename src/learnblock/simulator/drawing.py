"""Drawings on the floor of a world, and the pens of the robots that draw them.

A drawing is for the eyes of people: cameras and ground sensors do not see it, so that drawing never
changes what a robot measures.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass, field

from learnblock.simulator.colours import RGB
from learnblock.simulator.geometry import Pose

Point = tuple[float, float]

MOST_POINTS = 20_000
"""The points of all strokes in a world; about 60 m of lines."""
SPACING = 3.0
"""mm between two points of a stroke."""
PEN_COLOUR: RGB = (25, 70, 215)
PEN_WIDTH = 6.0
"""The width of a new pen's strokes, mm."""
WIDTHS = (1.0, 50.0)
"""The thinnest and the thickest stroke, mm."""


@dataclass(slots=True, eq=False)
class PenStroke:
    """A line drawn without lifting the pen; it grows while the pen is down.

    Args:
        robot: the name of the robot.
        colour: red, green and blue.
        width: mm.
        points: places on the floor in mm; points are only added, at the end.
    """

    robot: str
    colour: RGB
    width: float
    points: list[Point] = field(default_factory=list)


class Drawing:
    """The strokes on a world's floor."""

    def __init__(self) -> None:
        #: In the order in which they were begun.
        self.strokes: list[PenStroke] = []
        #: The strokes that have ended, until they are taken.
        self.ended: list[PenStroke] = []
        #: The pens that are down, by the name of their robot.
        self.pens: dict[str, DrawingPen] = {}
        #: The robots that could not draw any further, until they are taken.
        self.unable: list[str] = []
        self._points = 0
        self._is_full = False

    def extend(self) -> None:
        """Continue the strokes of all pens that are down; called after each step."""
        for pen in self.pens.values():
            pen.follow()

    def add(self, stroke: PenStroke, x: float, y: float) -> None:
        """Add a point to a stroke, which becomes part of the drawing, if there is room for it."""
        if self._points >= MOST_POINTS:
            if not self._is_full:
                self.unable.append(stroke.robot)
            self._is_full = True
            return
        if not stroke.points:
            self.strokes.append(stroke)
        # Tenths of a millimetre hide differences in arithmetic between machines.
        stroke.points.append((round(x, 1) + 0.0, round(y, 1) + 0.0))
        self._points += 1

    def end(self, stroke: PenStroke) -> None:
        """Note that a stroke has ended."""
        if stroke.points:
            self.ended.append(stroke)

    def clear(self, robot: str) -> None:
        """Remove the strokes of a robot."""
        self.strokes = [stroke for stroke in self.strokes if stroke.robot != robot]
        self._points = sum(len(stroke.points) for stroke in self.strokes)
        self._is_full = False


class DrawingPen:
    """The pen of a robot, at the middle between its wheels.

    Args:
        drawing: the drawing on the floor.
        robot: the robot's name.
        pose: returns its pose.
    """

    def __init__(self, drawing: Drawing, robot: str, pose: Callable[[], Pose]) -> None:
        self._drawing = drawing
        self._robot = robot
        self._pose = pose
        self._colour = PEN_COLOUR
        self._width = PEN_WIDTH
        #: The stroke that it draws; None while it is up.
        self._stroke: PenStroke | None = None

    def set(self, down: bool) -> None:  # noqa: FBT001 - a pen is either down or up
        """Put the pen down, or lift it."""
        if down and self._stroke is None:
            self._begin()
        elif not down and self._stroke is not None:
            self._end(self._stroke)

    def set_color(self, red: int, green: int, blue: int) -> None:
        """Change its colour: red, green and blue, 0 to 255."""
        self._change((red, green, blue), self._width)

    def set_width(self, width: float) -> None:
        """Change the width of its strokes, mm; it is limited to `WIDTHS`."""
        self._change(self._colour, min(max(width, WIDTHS[0]), WIDTHS[1]))

    def clear(self) -> None:
        """Remove what it has drawn; a pen that is down goes on with a new stroke."""
        is_down = self._stroke is not None
        self.set(False)
        self._drawing.clear(self._robot)
        self.set(is_down)

    def follow(self) -> None:
        """Extend its stroke to where the robot is now."""
        if self._stroke is None or not self._stroke.points:
            return
        pose = self._pose()
        x, y = self._stroke.points[-1]
        if math.hypot(pose.x - x, pose.y - y) >= SPACING:
            self._drawing.add(self._stroke, pose.x, pose.y)

    def jump(self) -> None:
        """Begin a new stroke, because a person lifted the robot and set it down elsewhere."""
        if self._stroke is not None:
            self._drawing.end(self._stroke)
            self._begin()

    def _change(self, colour: RGB, width: float) -> None:
        if (colour, width) == (self._colour, self._width):
            return
        is_down = self._stroke is not None
        self.set(False)
        self._colour, self._width = colour, width
        self.set(is_down)

    def _begin(self) -> None:
        self._stroke = PenStroke(self._robot, self._colour, self._width)
        pose = self._pose()
        self._drawing.add(self._stroke, pose.x, pose.y)
        self._drawing.pens[self._robot] = self

    def _end(self, stroke: PenStroke) -> None:
        pose = self._pose()
        at = (round(pose.x, 1) + 0.0, round(pose.y, 1) + 0.0)
        if stroke.points and stroke.points[-1] != at:
            self._drawing.add(stroke, pose.x, pose.y)
        self._stroke = None
        del self._drawing.pens[self._robot]
        self._drawing.end(stroke)
