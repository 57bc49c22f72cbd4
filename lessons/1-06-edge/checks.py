"""Whether the robot backs off at each edge, by about 100 mm."""

import math
from itertools import pairwise

EDGES = 3
SHORTEST = 65
LONGEST = 145
#: Less than this is no backing off, mm.
NOTHING = 15


def backs_off(run):
    ways = ways_back(run.path)
    if len(ways) < EDGES:
        return {
            "en": f"The robot backed off {len(ways)} times.",
            "es": f"El robot ha ido hacia atrás {len(ways)} veces.",
        }
    for way in ways:
        if not SHORTEST <= way <= LONGEST:
            return {
                "en": f"The robot backed off by {way:.0f} mm.",
                "es": f"El robot ha ido {way:.0f} mm hacia atrás.",
            }
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
