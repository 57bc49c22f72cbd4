"""Whether the report tells the truth: how often, and when, the robot got out of the way."""

import math
import re
from itertools import pairwise

#: Slower than this in its own direction, the robot does not drive forward, mm/s.
FORWARD = 30
#: From this rate on it turns, degrees per second.
TURNING = 12
#: So much has to come of it: degrees turned, or mm driven back.
LEAST_TURN = 20
LEAST_BACK = 20
#: Seconds by which a noted time may be early, by rounding down, or late, by rounding up.
EARLY, LATE = 1.25, 0.6
#: The mm driven back and the degrees turned at an obstacle by the program of the first step.
FIRST_BACK = (60, 100)
FIRST_TURN = (85, 115)


def walks_as_written(run):
    """Whether the robot backs away and turns at each obstacle as in the program of the step."""
    detours = split_detours(run.path)
    if len(detours) < 2:
        return "number_of_times", {"count": len(detours)}
    for detour in detours[:2]:
        back = -sum(min(0.0, forward(*pair)) for pair in detour)
        turned = sum(turn_between(*pair) for pair in detour)
        if not FIRST_BACK[0] <= back <= FIRST_BACK[1]:
            return "way_back", {"mm": back}
        if not FIRST_TURN[0] <= turned <= FIRST_TURN[1]:
            return "turned", {"degrees": turned}
    return True


def number_is_right(run):
    """Whether the number in the report is how often the robot got out of the way."""
    numbers = numbers_in(run, r"report: (\d+) obstacles")
    return True if set(numbers) & right_numbers(run) else wrong_number(numbers, run)


def diary_is_right(run):
    """Whether the report has one line for each time, with the right seconds."""
    numbers = numbers_in(run, r"report: (\d+) obstacles")
    seconds = numbers_in(run, r"obstacle after (\d+(?:\.\d+)?) s")
    if not set(numbers) & right_numbers(run):
        return wrong_number(numbers, run)
    if len(seconds) != numbers[0]:
        return "other_number_of_times", {"reported": numbers[0], "count": len(seconds)}
    found = split_detours(run.path)
    starts = [start for detour in found for start in beginnings(detour, run)]
    for second in seconds:
        if not any(start - EARLY <= second <= start + LATE for start in starts):
            return wrong_second(second, found)
    return True


def wrong_second(second, detours):
    for detour in detours:
        if detour[0][0][0] < second <= detour[-1][1][0] + EARLY:
            return "too_late", {"seconds": second}
    return "nothing_there", {"seconds": second}


def beginnings(detour, run):
    """When something was in the way: several times, if several things were, one after the other."""
    first, last = detour[0][0][0], detour[-1][1][0]
    backs = [is_back(*pair) for pair in detour]
    again = [
        pair[0][0]
        for pair, before, now in zip(detour[1:], backs, backs[1:], strict=False)
        if now and not before
    ]
    if not any(backs):
        again = [at for at, name in run.calls if name.startswith("turn") and first <= at <= last]
    return [first, *again]


def is_back(before, after):
    return forward(before, after) / (after[0] - before[0]) < -FORWARD


def right_numbers(run):
    """The numbers that are right: several turns in a row may be one detour, or several."""
    turns = sum(name.startswith("turn") for _, name in run.calls)
    return {len(detours_in(run.path)), turns}


def wrong_number(numbers, run):
    count = len(detours_in(run.path))
    said = f"{numbers[0]:g}" if numbers else "-"
    return "other_number", {"count": count, "reported": said}


def numbers_in(run, pattern):
    """The numbers in the printed lines of a form."""
    found = (re.fullmatch(pattern, " ".join(text.split()).lower()) for _, text in run.prints)
    return [float(one[1]) for one in found if one]


def detours_in(path):
    """When the robot turned or drove back: pairs of the first and the last second."""
    return [(detour[0][0][0], detour[-1][1][0]) for detour in split_detours(path)]


def split_detours(path):
    """The parts of the path in which the robot turned or drove back, as pairs of moments."""
    found = []
    detour = []
    for before, after in pairwise(path):
        if after[0] - before[0] < 0.001:
            continue
        if is_detour(before, after):
            detour.append((before, after))
            continue
        found += ended(detour)
        detour = []
    return found + ended(detour)


def is_detour(before, after):
    seconds = after[0] - before[0]
    turned = turn_between(before, after)
    return forward(before, after) / seconds < FORWARD or abs(turned) / seconds > TURNING


def ended(detour):
    """A detour that is over, if something came of it."""
    turned = abs(sum(turn_between(*pair) for pair in detour))
    back = -sum(forward(*pair) for pair in detour)
    if turned < LEAST_TURN and back < LEAST_BACK:
        return []
    return [detour]


def forward(before, after):
    """The mm driven in the direction in which the robot looks."""
    heading = math.radians(before[3])
    east, north = after[1] - before[1], after[2] - before[2]
    return east * math.cos(heading) - north * math.sin(heading)


def turn_between(before, after):
    return (after[3] - before[3] + 180) % 360 - 180
