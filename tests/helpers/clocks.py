"""A clock that a test sets."""


class Clock:
    """A function that returns the time that a test has set, in seconds."""

    def __init__(self, time: float = 0.0) -> None:
        self.time = time

    def __call__(self) -> float:
        return self.time
