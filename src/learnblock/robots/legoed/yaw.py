"""Counts turns beyond 180 degrees, where a motion sensor's angle jumps."""


class YawCount:
    """How far a robot has turned since its first report.

    Attributes:
        degrees: clockwise positive.
    """

    def __init__(self) -> None:
        self.degrees = 0.0
        self._last: float | None = None

    def follow(self, yaw: float) -> None:
        """Take an angle from -180 to 180 degrees; less than half a turn after the last one."""
        if self._last is not None:
            self.degrees += (yaw - self._last + 180) % 360 - 180
        self._last = yaw
