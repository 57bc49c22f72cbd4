"""Whether the robot is happy after the gap, and surprised four seconds after the line's end."""

ASKED = 4
#: Seconds by which it may be late or early: a round of the program takes some time.
OFF = 0.6
#: This far to the east, in mm, the robot is in the middle of the second line.
MIDDLE = 500


def happy_on_the_second_line(run):
    """Whether it looks happy again when it has found the line behind the gap."""
    middle = next((time for time, x, _, _ in run.path if x >= MIDDLE), None)
    if middle is None:
        return {
            "en": "The robot never comes to the second line.",
            "es": "El robot no llega a la segunda línea.",
        }
    if next((face for time, face in reversed(run.shows) if time <= middle), "") == "joy":
        return True
    return {
        "en": "On the second line the robot does not look happy.",
        "es": "En la segunda línea el robot no pone cara alegre.",
    }


def surprised_after_4_seconds(run):
    """Whether it is surprised four seconds after it has become sad for the last time."""
    times = {face: time for time, face in run.shows}
    if "surprise" not in times or "sadness" not in times:
        return {
            "en": "The robot has to look sad, and then surprised.",
            "es": "El robot tiene que ponerse triste y después sorprendido.",
        }
    lost = times["surprise"] - times["sadness"]
    if abs(lost - ASKED) <= OFF:
        return True
    return {
        "en": f"The robot is surprised {lost:.1f} s after it has got lost.",
        "es": f"El robot se sorprende {lost:.1f} s después de perderse.",
    }
