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
        return "never_comes"
    if next((face for time, face in reversed(run.shows) if time <= middle), "") == "joy":
        return True
    return "not_happy"


def surprised_after_4_seconds(run):
    """Whether it is surprised four seconds after it has become sad for the last time."""
    times = {face: time for time, face in run.shows}
    if "surprise" not in times or "sadness" not in times:
        return "no_surprise"
    lost = times["surprise"] - times["sadness"]
    if abs(lost - ASKED) <= OFF:
        return True
    return "surprised_after", {"seconds": lost}
