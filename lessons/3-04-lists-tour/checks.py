"""Whether the robot drives at 120 mm/s, and what it does at the places."""

import math
from itertools import pairwise

ASKED = 120
OFF = 15
#: Slower than this it stands, speeds up or turns, mm/s.
DRIVING = 40
#: The places of the tour in their order, and where they are.
PLACES = (
    ("bakery", (0, -300)),
    ("school", (0, 100)),
    ("park", (400, 100)),
    ("home", (400, -300)),
)
#: So near, in mm, the robot is at a place.
NEAR = 60
#: Seconds between two moments of the path.
TICK = 0.11
#: Seconds of the shortest note that counts as one beat: half of one.
SHORTEST_NOTE = 0.25


def at_120(run):
    speeds = sorted(speeds_of(run.path))
    if not speeds:
        return "never_drives"
    usual = speeds[len(speeds) // 2]
    if abs(usual - ASKED) <= OFF:
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


def name_and_note_at_each_place(run):
    """Whether each name is printed and one note is played while the robot is there.

    Name and note may come in any order.
    """
    after = 0.0
    for name, place in PLACES:
        stay = stay_at(run.path, place, after)
        if stay is None:
            return "never_comes", {"place": (name, {})}
        names = [text.strip().lower() for time, text in run.prints if is_in(time, stay)]
        if not set(names) & set(run.texts[name]):
            return "no_name", {"place": (name, {})}
        notes = [time for time, skill in run.calls if skill == "play_note" and is_in(time, stay)]
        if len(notes) != 1:
            return "other_notes", {"count": len(notes), "place": (name, {})}
        after = stay[1]
    return notes_last(run)


def notes_last(run):
    """Whether each note can be heard: the program goes on when a note is over."""
    calls = [*run.calls, (run.time, "")]
    for (start, skill), (end, _) in pairwise(calls):
        if skill == "play_note" and end - start < SHORTEST_NOTE:
            return "note_too_short"
    return True


def stay_at(path, place, after):
    """The first and the last second for which the robot is at a place; None if it never is."""
    stay = None
    for time, x, y, _ in path:
        if time < after:
            continue
        if math.hypot(x - place[0], y - place[1]) <= NEAR:
            stay = (stay[0], time) if stay else (time, time)
        elif stay:
            break
    return stay


def is_in(time, stay):
    return stay[0] - TICK <= time <= stay[1] + TICK
