"""How well Cozmo's reports arrive, by the robot's own clock."""

from collections import deque

#: Milliseconds of the robot's clock between two of its reports.
PERIOD = 33
#: Reports of about the last two seconds are counted.
COUNTED = 60


class Reception:
    """Compares the number of received reports with the number sent."""

    def __init__(self) -> None:
        self._stamps: deque[int] = deque(maxlen=COUNTED)

    def note(self, timestamp: int) -> None:
        """Count a report.

        Args:
            timestamp: the robot's clock, ms.
        """
        if self._stamps and timestamp < self._stamps[-1]:
            # The robot has restarted.
            self._stamps.clear()
        self._stamps.append(timestamp)

    @property
    def quality(self) -> float | None:
        """The share of the reports that arrived, 0 to 1; None before there are enough."""
        if len(self._stamps) < COUNTED // 4:
            return None
        total = 1 + (self._stamps[-1] - self._stamps[0]) / PERIOD
        return min(1.0, len(self._stamps) / total)
