"""Whether the robot backs off at each edge, by about 100 mm, and does not fall."""

import math
from itertools import pairwise

EDGES = 3
#: Degrees by which all turns together may be off.
OFF = 40
#: Degrees in 0.1 s that are no turn.
DRIFT = 0.8
SHORTEST = 65
LONGEST = 145
#: How far the middle of a robot may be from that of the table before it falls, mm.
EAST, NORTH = 440, 340
#: Less than this is no backing off, mm.
NOTHING = 15


def backs_off(run):
    ways = ways_back(run.path)
    if len(ways) < EDGES:
        return "number_of_times", {"count": len(ways)}
    for way in ways:
        if not SHORTEST <= way <= LONGEST:
            return "way_back", {"mm": way}
    return True


def ways_back(path):
    """The mm of each way that it drove backwards without a break."""
    found = [0.0]
    for before, after in pairwise(path):
        heading = math.radians(before[3])
        east, north = after[1] - before[1], after[2] - before[2]
        ahead = east * math.cos(heading) - north * math.sin(heading)
        if ahead < 0:
            found[-1] -= ahead
        elif found[-1]:
            found.append(0.0)
    return [way for way in found if way > NOTHING]


def stays_on_the_table(run):
    """Whether the middle of the robot stays above the table."""
    if all(abs(x) <= EAST and abs(y) <= NORTH for _, x, y, _ in run.path):
        return True
    return "falls"


def turns_around(run):
    """Whether it turns around at each edge, to either side."""
    turned = sum(turn_between(before[3], after[3]) for before, after in pairwise(run.path))
    if abs(turned - 180 * EDGES) <= OFF:
        return True
    return "turned", {"degrees": turned}


def turn_between(before, after):
    """The degrees between two headings, to either side; drift is none."""
    turned = abs((after - before + 180) % 360 - 180)
    return turned if turned > DRIFT else 0
