"""Whether each arrow key steers its way, and a face follows each thing that is collected."""

import math
from itertools import pairwise

#: Less than this is neither a drive (mm) nor a turn (degrees).
DRIVE, TURN = 20, 10
#: The keys, and for each how it drives and turns: 1, 0 or -1.
KEYS = {"up": (1, 0), "right": (0, 1), "left": (0, -1)}
FACES = {"star": "joy", "bug": "surprise"}
#: Seconds in which its face has to be there; before the end of the game no time is left for one.
LATE, ENDING = 2, 0.5


def each_key_steers(run):
    for key, (drives, turns) in KEYS.items():
        presses = presses_of(run, key)
        if not presses:
            return "not_pressed", {"key": (key, {})}
        driven, turned = (sum(values) / len(presses) for values in zip(*presses, strict=True))
        if sign(driven, DRIVE) != drives or sign(turned, TURN) != turns:
            return "steers", {"key": (key, {}), "mm": driven, "degrees": turned}
    return True


def sign(value, least):
    """Whether it is more than nothing: 1 or -1, else 0."""
    return 0 if abs(value) < least else math.copysign(1, value)


def presses_of(run, key):
    """The mm and the degrees that it drove and turned each time that this key alone was pressed."""
    ends = [time for time, held in run.keys if held][1:]
    starts = [(time, held) for time, held in run.keys if held]
    windows = zip(starts, [*ends, run.time], strict=True)
    return [
        moved([placed for placed in run.path if start <= placed[0] <= end])
        for (start, held), end in windows
        if list(held) == [key]
    ]


def moved(path):
    """The mm driven ahead and the degrees turned to the right."""
    driven = turned = 0.0
    for before, after in pairwise(path):
        heading = math.radians(before[3])
        east, north = after[1] - before[1], after[2] - before[2]
        driven += east * math.cos(heading) - north * math.sin(heading)
        turned += (after[3] - before[3] + 180) % 360 - 180
    return driven, turned


def face_for_each_thing(run):
    """Whether the face after each thing is the right one."""
    collected = [
        (line["t"], line["thing"].split()[0])
        for line in run.game
        if line["game"] == "collected" and "thing" in line
    ]
    for thing, face in FACES.items():
        times = [time for time, kind in collected if kind == thing]
        if not times:
            return "not_collected", {"thing": (thing, {})}
        seen = [time for time in times if time < run.time - ENDING]
        if not all(face_at(run.shows, time + LATE) == face for time in seen):
            return "other_face", {"thing": (thing, {})}
    return True


def face_at(shows, moment):
    """The face at a time, which stays until another one is shown."""
    return next((face for time, face in reversed(shows) if time <= moment), None)
