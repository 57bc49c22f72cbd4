"""Where a twin is and how it moves, by the time of its own world."""

import math
from itertools import pairwise

from waiting import wait_for


def pose(twin):
    """Return its position in mm and its heading in degrees."""
    with twin.body() as body:
        return body.pose


def x_of(twin):
    """Return how far it has moved along x, in mm."""
    return pose(twin)[0]


def emotion(twin):
    """Return the emotion on its face."""
    with twin.body() as body:
        return body.emotion


def strokes(twin):
    """Return what has been drawn on its floor."""
    with twin._simulation.lock:
        return list(twin._simulation.world.drawing.strokes)


def let_pass(twin, seconds):
    """Wait for seconds of its world's time."""
    until = twin.time + seconds
    wait_for(lambda: twin.time >= until, "its world advances")


def speed(twin):
    """Return its speed in mm/s over a tenth of a second."""
    start, before = _moment(twin)
    let_pass(twin, 0.1)
    end, after = _moment(twin)
    return math.dist(after[:2], before[:2]) / (end - start)


def stands_after(twin):
    """Return the seconds until it stops; it stands once it has not moved for 0.3 s."""
    began, last = _moment(twin)
    since = began

    def stands():
        nonlocal last, since
        now, here = _moment(twin)
        if math.dist(here[:2], last[:2]) > 0.05:
            last, since = here, now
        return now >= since + 0.3

    wait_for(stands, "it stands")
    return since - began


def _moment(twin):
    """Return the time and the pose in the same step of its world."""
    with twin.body() as body:
        return twin.time, body.pose


def furthest(path, other):
    """Return the largest distance in mm of the places of a path from those of another path."""
    return max(min(math.dist(here[:2], there[:2]) for there in other) for here in path)


def off(path, other):
    """Return the largest distance in mm of the places of a path from the lines of another path."""
    legs = [leg for leg in pairwise(place[:2] for place in other) if leg[0] != leg[1]]
    return max(min(_away(place[:2], leg) for leg in legs) for place in path)


def _away(point, leg):
    """Return the distance of a point from a straight line."""
    (x, y), (to_x, to_y) = leg
    along_x, along_y = to_x - x, to_y - y
    part = ((point[0] - x) * along_x + (point[1] - y) * along_y) / (along_x**2 + along_y**2)
    part = min(max(part, 0), 1)
    return math.dist(point, (x + part * along_x, y + part * along_y))
