"""Whether the robot prints bench at the bench, backs away from it and turns by 120 degrees."""

import math
from itertools import pairwise

#: The mm that it has to drive back, and the degrees that it has to turn.
LEAST_BACK = 60
TURN = (105, 135)
#: The bench: its middle and its half size, mm.
BENCH = (300, 0)
HALF = (40, 150)
#: From the middle of the robot to the bench when its sensor sees it, mm, and to the side, degrees.
SEEN, ASIDE = 260, 70
#: Two lines in so many seconds are one meeting with the bench, printed twice.
APART = 2


def backs_away(run):
    times = [time for time, text in run.prints if text.strip().lower() == "bench"]
    if any(after - before < APART for before, after in pairwise(times)):
        return "printed_twice"
    # The last one may be cut off by the end of the time.
    for time in times[:1]:
        back, turned = detour_after(run.path, time)
        if back < LEAST_BACK:
            return "way_back", {"mm": back}
        if not TURN[0] <= turned <= TURN[1]:
            return "turned", {"degrees": turned}
    return True


def detour_after(path, time):
    """The mm driven back and the degrees turned before it drives forward again."""
    back = turned = 0.0
    for before, after in pairwise(path):
        if after[0] <= time:
            continue
        ahead = forward(before, after)
        if ahead > 4 and (back or turned > 5):
            break
        back += max(0.0, -ahead)
        turned += abs((after[3] - before[3] + 180) % 360 - 180)
    return back, turned


def forward(before, after):
    """The mm driven in the direction in which the robot looks."""
    heading = math.radians(before[3])
    east, north = after[1] - before[1], after[2] - before[2]
    return east * math.cos(heading) - north * math.sin(heading)


def bench_at_the_bench(run):
    """Whether it prints bench only where the bench is ahead."""
    for time, text in run.prints:
        if text.strip().lower() == "bench" and not is_bench_ahead(place_at(run.path, time)):
            return "bench_not_ahead", {"seconds": time}
    return True


def place_at(path, time):
    """Where the robot is at a time."""
    return min(path, key=lambda placed: abs(placed[0] - time))


def is_bench_ahead(placed):
    _, x, y, heading = placed
    east, north = (
        min(max(here, middle - half), middle + half) - here
        for here, middle, half in zip((x, y), BENCH, HALF, strict=True)
    )
    bearing = -math.degrees(math.atan2(north, east))
    aside = abs((bearing - heading + 180) % 360 - 180)
    return math.hypot(east, north) <= SEEN and aside <= ASIDE
