"""Whether the robot parks at the right distance from the wall, wherever it starts."""

#: Where the middle of a robot is, in mm, when its front is 100 mm from the wall.
PARKED = 414
#: By how much this differs between robots.
OFF = 28


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
