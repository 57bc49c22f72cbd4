"""Whether the robot turns by 90 degrees at an obstacle."""

from itertools import pairwise

#: Degrees by which a turn may be off, and those that drift adds in the course of time.
OFF = 20
#: Degrees in 0.1 s from which on it turns, and the least mm in 0.1 s of driving ahead.
TURNING = 1.0
DRIVING = 3.0


def turns_by_90(run):
    headings = driven_headings(run.path)
    if len(headings) < 2:
        return {"en": "The robot never turns.", "es": "El robot no gira nunca."}
    # At the box there is room on both sides; later two turns in a row may be right.
    if not is_about(turn_between(*headings[:2]), (90,)):
        return wrong(turn_between(*headings[:2]))
    for pair in pairwise(headings):
        if not is_about(turn_between(*pair), (90, 180)):
            return wrong(turn_between(*pair))
    return True


def wrong(turn):
    return {
        "en": f"The robot turned by {turn:.0f}° at an obstacle.",
        "es": f"El robot ha girado {turn:.0f}° en un obstáculo.",
    }


def is_about(turn, angles):
    return any(abs(turn - angle) <= OFF for angle in angles)


def driven_headings(path):
    """The headings in which it drove, one after the other."""
    found = []
    has_turned = True
    for before, after in pairwise(path):
        if turn_between(before[3], after[3]) > TURNING:
            has_turned = True
        elif abs(after[1] - before[1]) + abs(after[2] - before[2]) > DRIVING and has_turned:
            found.append(after[3])
            has_turned = False
    return found


def turn_between(before, after):
    """The degrees between two headings, to either side."""
    return abs((after - before + 180) % 360 - 180)
