"""Whether averages are right, and it measures often, drives little and reports at the end."""

import math
import re
from itertools import pairwise

NUMBER = r"-?\d+(?:\.\d+)?"
#: mm in 0.1 s from which on it drives, and the longest drive between two measurements, mm.
MOVING = 0.5
LONGEST_DRIVE = 36
#: The distance at which it parks, and by how much a good average may be off, mm.
PARKED = 300
OFF = 45


def five_and_average(run):
    """Whether it prints five numbers, and then their average."""
    texts = [text.strip() for _, text in run.prints]
    values = [float(text) for text in texts if re.fullmatch(NUMBER, text)]
    averages = [found for text in texts if (found := re.fullmatch(rf"average ({NUMBER})", text))]
    if len(values) != 5 or len(averages) != 1 or len(texts) != 6:
        return "other_numbers"
    if sum(skill == "get_min_distance" for _, skill in run.calls) < 5:
        return "too_few_measurements"
    if abs(float(averages[0][1]) - sum(values) / 5) > 1:
        return "other_average"
    return True


def ten_each_time(run):
    """Whether the sensor is asked ten times for each decision."""
    asked = sum(skill == "get_min_distance" for _, skill in run.calls)
    if asked and asked % 10 == 0:
        return True
    return "not_ten", {"count": asked}


def short_drives(run):
    """Whether it drives about 25 mm between two measurements."""
    longest = max(drives_in(run.path), default=0)
    if longest <= LONGEST_DRIVE:
        return True
    return "long_drive", {"mm": longest}


def reports_at_the_end(run):
    """Whether it prints a new measurement when it has parked."""
    reports = [
        (time, float(found[1]))
        for time, text in run.prints
        if (found := re.fullmatch(rf"parked at ({NUMBER}) mm", text.strip(), re.IGNORECASE))
    ]
    if not reports:
        return "no_report"
    time, distance = reports[-1]
    if time < last_drive(run.path):
        return "printed_too_early"
    if abs(distance - PARKED) > OFF:
        return "other_distance", {"mm": distance}
    return True


def shows_it_at_the_end(run):
    """Whether it shows one text, when it has parked."""
    texts = [(time, text.strip().lower()) for time, text in run.shows]
    if [text for _, text in texts] != ["parked"]:
        return "not_shown_once"
    if texts[0][0] < last_drive(run.path):
        return "shown_too_early"
    return True


def last_drive(path):
    """The time of the last moment in which the robot drove, in seconds."""
    return max(
        (
            before[0]
            for before, after in pairwise(path)
            if math.hypot(after[1] - before[1], after[2] - before[2]) >= MOVING
        ),
        default=0,
    )


def drives_in(path):
    """The mm of each drive from one stop to the next."""
    driven = 0.0
    for before, after in pairwise(path):
        step = math.hypot(after[1] - before[1], after[2] - before[2])
        if step >= MOVING:
            driven += step
        elif driven:
            yield driven
            driven = 0.0
    if driven:
        yield driven
