"""Whether faces can be seen, each for at least 0.9 seconds, and notes be heard."""

from itertools import pairwise

LONG_ENOUGH = 0.9
#: Seconds of the shortest note that can be heard.
SHORTEST_NOTE = 0.1


def faces_can_be_seen(run):
    times = [time for time, _ in run.shows]
    if all(after - before >= LONG_ENOUGH for before, after in pairwise(times)):
        return True
    return "face_too_fast"


def notes_can_be_heard(run):
    calls = [*run.calls, (run.time, "")]
    notes = [pair for pair in pairwise(calls) if pair[0][1] == "play_note"]
    # The program goes on when a note is over.
    if all(after[0] - before[0] >= SHORTEST_NOTE for before, after in notes):
        return True
    return "note_too_short"
