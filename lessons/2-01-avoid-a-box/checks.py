"""Whether the robot asks its sensor, turns by 90 degrees at obstacles, and shows its feelings."""

from itertools import groupby, pairwise

#: Degrees by which a turn may be off, and those that drift adds in the course of time.
OFF = 20
#: Degrees in 0.1 s from which on it turns, and the least mm in 0.1 s of driving ahead.
TURNING = 1.0
DRIVING = 3.0
#: Shorter movements are none, in seconds.
SHORTEST = 0.4

SENSORS = {
    "is_front_obstacle",
    "get_min_distance",
    "is_obstacle_free",
    "get_obstacle_direction",
}


def turns_by_90(run):
    headings = driven_headings(run.path)
    if len(headings) < 2:
        return "never_turns"
    # At the box there is room on both sides; later two turns in a row may be right.
    if not is_about(turn_between(*headings[:2]), (90,)):
        return wrong(turn_between(*headings[:2]))
    for pair in pairwise(headings):
        if not is_about(turn_between(*pair), (90, 180)):
            return wrong(turn_between(*pair))
    return True


def wrong(turn):
    return "turned", {"degrees": turn}


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


def asks_a_distance_sensor(run):
    """Whether the program asks for obstacles ahead."""
    if any(skill in SENSORS for _, skill in run.calls):
        return True
    return "never_asks"


def happy_on_the_way_and_scared_at_obstacles(run):
    """Whether it looks scared in the middle of each turn, and happy in the middle of each drive."""
    found = movements(run.path)
    for movement, face in FACES.items():
        middles = [middle for kind, middle in found if kind == movement]
        if not middles:
            return f"never_{movement}"
        for middle in middles:
            if face_at(run.shows, middle) != face:
                return f"other_face_{movement}", {"seconds": middle}
    return True


FACES = {"turns": "fear", "drives": "joy"}


def face_at(shows, time):
    """The face that the robot shows at a time."""
    return next((face for at, face in reversed(shows) if at <= time), "")


def movements(path):
    """Each turn and each drive, and the time of its middle."""
    found = []
    for movement, steps in groupby(pairwise(path), lambda step: movement_of(*step)):
        times = [after[0] for _, after in steps]
        if movement and times[-1] - times[0] >= SHORTEST:
            found.append((movement, (times[0] + times[-1]) / 2))
    return found


def movement_of(before, after):
    if turn_between(before[3], after[3]) > TURNING:
        return "turns"
    is_far = abs(after[1] - before[1]) + abs(after[2] - before[2]) > DRIVING
    return "drives" if is_far else ""
