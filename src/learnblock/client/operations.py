"""What a driver calls on its robot by name, such as ``differentialrobot.setSpeedBase``."""

import threading
from collections.abc import Callable
from typing import Any


class Operations:
    """Finds out which function of a device makes a driver call which operation of its robot.

    A driver whose robot has operations with names tells `note` each of them as it calls it.
    """

    def __init__(self) -> None:
        #: Called with a device's function and the operation, the first time that it is called.
        self.found: Callable[[str, str], object] | None = None
        self._known: set[tuple[str, str]] = set()
        #: Sensors are read in several threads.
        self._now = threading.local()

    def serve(self, of: str, function: Callable[..., Any], *args: Any) -> Any:
        """Call a function of a device, such as ``Base:ROBOT.move``."""
        before = getattr(self._now, "of", "")
        self._now.of = of
        try:
            return function(*args)
        finally:
            self._now.of = before

    def note(self, operation: str) -> None:
        """Note that the driver calls an operation."""
        of = getattr(self._now, "of", "")
        if of and self.found and (of, operation) not in self._known:
            self._known.add((of, operation))
            self.found(of, operation)
