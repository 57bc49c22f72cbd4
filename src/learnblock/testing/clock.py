"""Time that passes only while someone sleeps."""


class VirtualClock:
    """A robot's clock on which every `sleep` is over at once.

    >>> clock = VirtualClock()
    >>> clock.sleep(3600)
    >>> clock.time()
    3600.0
    """

    def __init__(self) -> None:
        self._time = 0.0
        self._instant = 0

    @property
    def instant(self) -> int:
        """The number of sleeps so far."""
        return self._instant

    def time(self) -> float:
        """Seconds slept so far."""
        return self._time

    def sleep(self, seconds: float) -> None:
        if seconds > 0:
            self._time += seconds
            self._instant += 1

    def charge(self) -> None:
        """Nothing to do: here an access is free."""
