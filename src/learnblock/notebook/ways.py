"""The ways of robots in the cells of a notebook."""

import weakref
from abc import ABC, abstractmethod
from collections.abc import Mapping
from contextlib import suppress

from learnblock.client import Client
from learnblock.devices import Base, Pose
from learnblock.errors import LearnBlockError
from learnblock.robots.real import RealRobot
from learnblock.robots.simulated.robot import SimulatedRobot
from learnblock.robots.simulated.way import DrivenWay, draw_way
from learnblock.simulator import WorldDescription, load_robot
from learnblock.simulator.robot_description import Body
from learnblock.simulator.world_description import Floor

#: mm around the way of a real robot, whose room is not known, and the widest floor.
_AROUND, _WIDEST = 300.0, 10_000.0
#: The body of a real robot whose picture is not known.
_PLAIN = Body(shape="disc", radius=60.0, height=60.0, mass=0.5)


def way_of(robot: Client) -> "CellWay":
    """The way of a robot that has just been connected."""
    return SimulatedWay(robot) if isinstance(robot, SimulatedRobot) else MeasuredWay(robot)


def name_of(robot: Client) -> str:
    """The name of a robot as commands have it, such as ``ev3``."""
    return robot.name() if isinstance(robot, RealRobot) else type(robot).__module__


class CellWay(ABC):
    """A robot's way, and where the present cell began on it.

    Attributes:
        is_asked_for: whether it is shown after this cell even if the robot has not moved.
    """

    def __init__(self) -> None:
        self.is_asked_for = False
        self._began = self.mark()

    def begin_cell(self) -> None:
        """Note that a cell begins."""
        self.is_asked_for = False
        self._began = self.mark()

    def is_worth_showing(self) -> bool:
        """Whether the cell that ends has moved the robot, or asks for its picture."""
        self.mark()
        return self.is_asked_for or self.driven.moves_after(self._began)

    @property
    def span(self) -> tuple[float, float]:
        """The times in s at which the present cell began, and now."""
        return self._began, self.mark()

    @property
    @abstractmethod
    def driven(self) -> DrivenWay:
        """Where the robot has been."""

    @abstractmethod
    def mark(self) -> float:
        """Add where the robot is; return its time in s."""

    @abstractmethod
    def shown(self) -> Mapping[str, str]:
        """The way of the cell, by the types that notebooks show."""


class SimulatedWay(CellWay):
    """The way of a simulated robot in its world.

    Args:
        robot: the robot.
    """

    def __init__(self, robot: SimulatedRobot) -> None:
        # What shows a robot must not keep it, or a kernel would fill with worlds.
        self._robot = weakref.proxy(robot)
        super().__init__()

    @property
    def driven(self) -> DrivenWay:
        driven: DrivenWay = self._robot.driven_way
        return driven

    def mark(self) -> float:
        time: float = self._robot.simulation.time()
        self.driven.pose(time, self._robot.where())
        return time

    def shown(self) -> Mapping[str, str]:
        picture = self._robot.drawn_way(self._began)
        return {"text/plain": self._robot.__repr__(), "image/svg+xml": picture}


class MeasuredWay(CellWay):
    """The way of a real robot by its own odometry, on a floor without a world.

    Args:
        robot: the robot.
    """

    def __init__(self, robot: Client) -> None:
        self._robot = weakref.proxy(robot)
        self._name = name_of(robot)
        self._driven = DrivenWay()
        base = next((base for _, base in robot.devices() if isinstance(base, Base)), None)
        self._read = base.pose if base else None
        super().__init__()
        if base:
            # As for the page: in the background, whether or not the program asks for it.
            robot.readings.watch((CellWay, "pose"), self._pose)

    @property
    def driven(self) -> DrivenWay:
        return self._driven

    def mark(self) -> float:
        # A robot that is out of reach stays where it was last.
        with suppress(LearnBlockError):
            self._pose()
        return self._driven.points[-1][0] if self._driven.points else 0.0

    def shown(self) -> Mapping[str, str]:
        points = self._driven.since(self._began)
        if not points:
            return {"text/plain": self._robot.__repr__()}
        model = self._robot.model
        body = load_robot(model).body if model else _PLAIN
        farthest = max(max(abs(x), abs(y)) for _, x, y, _ in points)
        side = min(2 * (farthest + _AROUND), _WIDEST)
        room = WorldDescription(name="room", floor=Floor(size=(side, side)))
        picture = draw_way(self._name, body, room, points)
        return {"text/plain": self._robot.__repr__(), "image/svg+xml": picture}

    def _pose(self) -> Pose | None:
        if self._read is None or self._robot.stopped:
            return None
        x, y, heading = self._read()
        pose = round(x, 1), round(y, 1), round(heading, 1)
        self._driven.pose(self._robot.clock.time(), pose)
        return pose
