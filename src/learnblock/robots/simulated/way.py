"""The way that a robot has driven, for notebooks, which show it."""

from learnblock.client import Witness
from learnblock.devices import Pose
from learnblock.simulator import RobotBody, World

#: Points; of a longer way every second one is dropped.
_MOST_POINTS = 20_000


class DrivenWay(Witness):
    """The way that a robot has driven so far.

    Attributes:
        points: (time in s, x in mm, y in mm, heading in degrees), in chronological order.
    """

    def __init__(self) -> None:
        self.points: list[tuple[float, float, float, float]] = []

    def pose(self, time: float, pose: Pose) -> None:
        self.points.append((time, *pose))
        if len(self.points) > _MOST_POINTS:
            del self.points[1:-1:2]

    def draw(self, body: RobotBody, world: World, name: str) -> str:
        """Draw the way in its world, as SVG.

        Args:
            body: the robot, where it is now.
            world: its world.
            name: its name in the world, by which strokes of its pen are known.
        """
        from learnblock.simulator.picture import DrivenRun, PictureScene, draw_svg  # noqa: PLC0415 - slow

        drive = DrivenRun(
            body=body.description.body,
            path=(*self.points, (world.time, *body.pose)),
            strokes=tuple(stroke for stroke in world.drawing.strokes if stroke.robot == name),
        )
        title = f"{body.description.title}: {world.description.name}"
        return draw_svg(PictureScene(world=world.description, drives=(drive,), title=title))
