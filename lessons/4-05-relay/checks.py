"""Whether the robots drive at the right speed."""

import math
from itertools import pairwise

#: The share by which a speed may differ.
OFF = 0.15
#: Slower than this it stands, or speeds up, mm/s.
DRIVING = 40


def at_100(run):
    return drives_at(run, 100)


def at_120(run):
    return drives_at(run, 120)


def drives_at(run, asked):
    speeds = sorted(speeds_of(run.path))
    if not speeds:
        return "never_drives"
    usual = speeds[len(speeds) // 2]
    if abs(usual - asked) <= OFF * asked:
        return True
    return "speed", {"speed": usual}


def speeds_of(path):
    """The speeds at which it drove, one for each moment."""
    for before, after in pairwise(path):
        seconds = after[0] - before[0]
        if seconds < 0.01:
            continue
        speed = math.hypot(after[1] - before[1], after[2] - before[2]) / seconds
        if speed > DRIVING:
            yield speed
