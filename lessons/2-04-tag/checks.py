"""Whether a face comes within two seconds after the robot can see a tag."""

import math

#: Degrees from the middle of the picture to the middle of a tag that is certainly in it.
SEEN = 8
#: Degrees at which no part of a tag can be in it.
UNSEEN = 26
#: At most so many seconds later, with 0.3 more for the time that a camera needs.
SOON = 2.3


def joy_at_tag_3(run):
    return _soon(run, "joy", (0, -600))


def surprise_at_tag_5(run):
    return _soon(run, "surprise", (-600, 0))


def _soon(run, face, place):
    shown = [time for time, what in run.shows if what == face]
    if not shown:
        return "never_shown"
    can_see = [one[0] for one in run.path if _off(one, place) <= UNSEEN]
    sees = [one[0] for one in run.path if _off(one, place) <= SEEN]
    if not can_see:
        return "never_looks"
    if shown[0] < can_see[0]:
        return "too_early"
    # A robot that stops as soon as it sees the tag never looks straight at it.
    seen = sorted([*sees[:1], *_stands(run, place)[:1]])
    return "too_late" if seen and shown[0] > seen[0] + SOON else True


def _stands(run, place):
    """When the robot stands still and may see the tag."""
    return [
        after[0]
        for before, after in zip(run.path, run.path[2:], strict=False)
        if _off(after, place) <= UNSEEN and abs(after[3] - before[3]) < 0.5
    ]


def _off(placed, place):
    _, x, y, heading = placed
    bearing = math.degrees(math.atan2(y - place[1], place[0] - x))
    return abs((bearing - heading + 180) % 360 - 180)
