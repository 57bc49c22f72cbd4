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
        return {"en": "It stops too far from the wall.", "es": "Para demasiado lejos de la pared."}
    return {"en": "It stops too close to the wall.", "es": "Para demasiado cerca de la pared."}


def asks_a_distance_sensor(run):
    """Whether the program asks for obstacles ahead."""
    if any(skill in SENSORS for _, skill in run.calls):
        return True
    return {
        "en": "The program never asks the distance sensor.",
        "es": "El programa no pregunta nunca al sensor de distancia.",
    }
