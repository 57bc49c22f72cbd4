"""Whether the robot measures as often as it should."""

from itertools import pairwise

#: The share by which the time between two measurements may differ.
OFF = 0.3


def every_tenth(run):
    return measures_every(run, 0.1)


def every_twentieth(run):
    return measures_every(run, 0.05)


def measures_every(run, asked):
    times = [time for time, skill in run.calls if skill == "get_line_position"]
    waits = sorted(after - before for before, after in pairwise(times))
    if not waits:
        return "never_asks"
    usual = waits[len(waits) // 2]
    if abs(usual - asked) <= OFF * asked:
        return True
    return "usual_time", {"seconds": usual}
