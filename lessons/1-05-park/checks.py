"""Whether the robot parks at the right distance from the wall, and finds it with its sensor."""

#: Where the middle of a robot is, in mm, when its front is 100 mm from the wall.
PARKED = 414
#: By how much this differs between robots.
OFF = 28
SENSORS = {
    "is_front_obstacle",
    "get_min_distance",
    "is_obstacle_free",
    "get_obstacle_direction",
}


def parks_100_mm_from_the_wall(run):
    """Whether the robot ends 100 mm from the wall; pupils may have dragged it along the wall."""
    if not run.path:
        return False
    away = run.path[-1][1] - PARKED
    if abs(away) <= OFF:
        return True
    if away < 0:
        return "too_far"
    return "too_close"


def asks_a_distance_sensor(run):
    """Whether the program asks for obstacles ahead."""
    if any(skill in SENSORS for _, skill in run.calls):
        return True
    return "never_asks"
