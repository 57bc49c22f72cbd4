"""A clock on which time passes only during `sleep`."""


class VirtualClock:
    """A robot's clock whose `sleep` returns at once.

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
        """Do nothing: access to a device takes no time here."""
