"""How long an open project waits before it saves, looks at its file, and closes."""

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Periods:
    """How long an open project waits, in seconds.

    Args:
        save: from the first unsaved change to the save.
        retry: from a save that failed to the next attempt.
        watch: between two checks whether another program has changed the file.
        grace: without a page until it closes, so that a page that is reloaded finds its program
            still running.
    """

    save: float = 0.5
    retry: float = 2.0
    watch: float = 1.0
    grace: float = 60.0
