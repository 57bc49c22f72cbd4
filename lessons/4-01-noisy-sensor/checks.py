"""Whether the average is right, ten measurements are made each time, and drives are short."""

import math
import re
from itertools import pairwise

NUMBER = r"-?\d+(?:\.\d+)?"
#: mm in 0.1 s from which on it drives, and the longest drive between two measurements, mm.
MOVING = 0.5
LONGEST_DRIVE = 36


def five_and_average(run):
    """Whether it prints five numbers, and then their average."""
    texts = [text.strip() for _, text in run.prints]
    values = [float(text) for text in texts if re.fullmatch(NUMBER, text)]
    averages = [found for text in texts if (found := re.fullmatch(rf"average ({NUMBER})", text))]
    if len(values) != 5 or len(averages) != 1 or len(texts) != 6:
        return {
            "en": "It has to print five numbers, and then one average.",
            "es": "Tiene que escribir cinco números y después una media.",
        }
    if sum(skill == "get_min_distance" for _, skill in run.calls) < 5:
        return {
            "en": "It has to measure five times, too.",
            "es": "También tiene que medir cinco veces.",
        }
    if abs(float(averages[0][1]) - sum(values) / 5) > 1:
        return {
            "en": "This is not the average of the five numbers.",
            "es": "Esa no es la media de los cinco números.",
        }
    return True


def ten_each_time(run):
    """Whether the sensor is asked ten times for each decision."""
    asked = sum(skill == "get_min_distance" for _, skill in run.calls)
    if asked and asked % 10 == 0:
        return True
    return {
        "en": f"The robot measured {asked} times: that is not ten each time.",
        "es": f"El robot ha medido {asked} veces: no son diez cada vez.",
    }


def short_drives(run):
    """Whether it drives about 25 mm between two measurements."""
    longest = max(drives_in(run.path), default=0)
    if longest <= LONGEST_DRIVE:
        return True
    return {
        "en": f"Between two measurements the robot drives {longest:.0f} mm.",
        "es": f"Entre dos medidas el robot avanza {longest:.0f} mm.",
    }


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
