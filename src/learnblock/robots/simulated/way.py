"""The way that a robot has driven, for notebooks, which show it."""

from bisect import bisect_left
from itertools import pairwise
from operator import itemgetter

from learnblock.client import Witness
from learnblock.devices import Pose
from learnblock.simulator import PenStroke, WorldDescription
from learnblock.simulator.robot_description import Body

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

    def since(self, time: float) -> tuple[tuple[float, float, float, float], ...]:
        """The points from a time in s on."""
        return tuple(self.points[bisect_left(self.points, time, key=itemgetter(0)) :])

    def moves_after(self, time: float) -> bool:
        """Whether the robot has moved or turned since a time in s."""
        return any(before[1:] != after[1:] for before, after in pairwise(self.since(time)))


def draw_way(
    title: str,
    body: Body,
    world: WorldDescription,
    points: tuple[tuple[float, float, float, float], ...],
    strokes: tuple[PenStroke, ...] = (),
) -> str:
    """Draw a way in its world, as SVG in the colours of the reader's theme.

    Args:
        title: of the picture.
        body: of the robot, which is drawn at both ends.
        world: where it drove.
        points: the way; see `DrivenWay`.
        strokes: what its pen has drawn.
    """
    from learnblock.simulator.picture import DrivenRun, PictureScene, draw_svg  # noqa: PLC0415 - slow

    drive = DrivenRun(body=body, path=points, strokes=strokes)
    return draw_svg(PictureScene(world=world, drives=(drive,), title=title), follows_theme=True)
