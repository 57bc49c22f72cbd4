"""Places on a robot's way, and how far it is from one of them, in words."""

import math
from collections.abc import Callable, Sequence
from itertools import pairwise

from learnblock.evidence.evidence import Moment, TimedPose
from learnblock.i18n import Phrase
from learnblock.simulator.polyline import Polyline

XY = tuple[float, float]

#: The mm and degrees by which a robot may move and still count as standing still.
STILL = (2.0, 2.0)
#: mm: places that are nearer to each other give no direction.
_NO_WAY = 20


def xy(placed: TimedPose) -> XY:
    """Where a robot was."""
    return placed.x, placed.y


def nearest_point(way: Sequence[TimedPose], place: XY) -> XY:
    """The point of a way that is nearest to a place."""
    points = [_on_piece(xy(before), xy(after), place) for before, after in pairwise(way)]
    return min(points or [xy(way[0])], key=lambda point: math.dist(point, place))


def _on_piece(begin: XY, end: XY, place: XY) -> XY:
    """The point between two others that is nearest to a place."""
    (x, y), (dx, dy) = begin, (end[0] - begin[0], end[1] - begin[1])
    square = dx * dx + dy * dy
    if square == 0:
        return begin
    share = min(1.0, max(0.0, ((place[0] - x) * dx + (place[1] - y) * dy) / square))
    return x + share * dx, y + share * dy


def place_at(path: Sequence[TimedPose], moment: Moment) -> XY:
    """Where the robot was at a moment."""
    before = [placed for placed in path if placed.moment.time <= moment.time]
    return xy(before[-1] if before else path[0])


def direction(begin: XY, end: XY) -> float:
    """The heading from one place to another, in degrees clockwise from the east."""
    return math.degrees(math.atan2(begin[1] - end[1], end[0] - begin[0]))


def heading_between(before: float, after: float) -> float:
    """The degrees from one heading to another, from -180 to 180."""
    return (after - before + 180) % 360 - 180


def is_on_line(path: Sequence[TimedPose], middle: Polyline, distance: float) -> Sequence[bool]:
    """Whether the robot was at most so many mm from the middle of a line, at each place."""
    return [middle.distance(placed.x, placed.y) <= distance for placed in path]


def turned_along(path: Sequence[TimedPose]) -> float:
    """The degrees that the robot turned along a way, negative to the left."""
    return sum(heading_between(before.heading, after.heading) for before, after in pairwise(path))


def longest_stand(
    path: Sequence[TimedPose], is_there: Callable[[XY], bool] = lambda _: True
) -> tuple[float, XY]:
    """How long the robot stood still at most, in seconds, and its place meanwhile."""
    longest, where, since = 0.0, xy(path[-1]), path[0]
    for placed in path:
        moved = math.dist(xy(since), xy(placed)) > STILL[0]
        turned = abs(heading_between(since.heading, placed.heading)) > STILL[1]
        if moved or turned or not is_there(xy(placed)):
            since = placed
        elif placed.moment.time - since.moment.time > longest:
            longest, where = placed.moment.time - since.moment.time, xy(since)
    return longest, where


def gap_words(before: XY, nearest: XY, place: XY) -> Phrase:
    """How far a point is from a place, seen from where the robot came from."""
    away, way = math.dist(nearest, place), math.dist(before, place)
    if way < _NO_WAY:
        return length_words("away", away)
    ahead = ((place[0] - before[0]) / way, (place[1] - before[1]) / way)
    dx, dy = nearest[0] - place[0], nearest[1] - place[1]
    along, left = ahead[0] * dx + ahead[1] * dy, ahead[0] * dy - ahead[1] * dx
    if abs(along) >= abs(left):
        return length_words("short" if along < 0 else "past", away)
    return length_words("left" if left > 0 else "right", away)


def length_words(where: str, mm: float) -> Phrase:
    """A length and where it lacks: ``short``, ``past``, ``left``, ``right`` or ``away``."""
    return Phrase(f"miss-gap-{where}", mm=rounded_mm(mm))


def turn_words(off: float) -> Phrase:
    """Degrees by which a robot faces too far to one side."""
    return Phrase(f"miss-gap-turned-{'right' if off > 0 else 'left'}", degrees=round(abs(off)))


def rounded_mm(value: float) -> int:
    """A length that can be read at a glance: to 10 mm, a short one to 5 mm."""
    step = 10 if value >= 50 else 5
    return max(step, round(value / step) * step)


def rounded_seconds(value: float) -> float:
    """Seconds to a tenth."""
    return round(value, 1)
