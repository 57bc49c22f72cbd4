"""How a client comes by its sensors' readings: at once, once an instant, or by polling."""

import threading
from collections.abc import Callable, Hashable, Iterator
from contextlib import contextmanager
from typing import Any

from learnblock.clock import Clock

Key = Hashable
Read = Callable[[], Any]

#: The pace of what is read in no time: all but what has to be looked for in pictures.
SENSORS = "sensors"


class Readings:
    """The latest reading of each sensor in use.

    At one instant of a clock that stands still between waits a sensor is read once; with a clock
    that flows by itself every question reads anew. Inside `snapshot` every reading is made once.

    Args:
        clock: the robot's.
    """

    def __init__(self, clock: Clock) -> None:
        self._clock = clock
        self._instant: int | None = None
        self._read: dict[Key, Any] = {}
        #: Whether a snapshot is being taken.
        self.frozen = False

    def latest(self, key: Key, read: Read, pace: str = SENSORS) -> Any:
        """The reading of the sensor called `key`, which `read` makes when one is due.

        Args:
            key: of the sensor.
            read: reads it.
            pace: sensors of one pace are read one after the other, and wait for no others.
        """
        if not self.frozen:
            self._forget_the_past()
        if key not in self._read:
            self._read[key] = self._make(key, read, pace)
        return self._read[key]

    @contextmanager
    def snapshot(self) -> Iterator[None]:
        """Within it, all questions are answered from the same readings."""
        self._read.clear()
        self.frozen = True
        try:
            yield
        finally:
            self.frozen = False

    def forget(self) -> None:
        """Read anew at the next question, as after a command that changes what is read."""
        if not self.frozen:
            self._read.clear()

    def close(self) -> None:
        """Nothing runs beside the program."""

    def _forget_the_past(self) -> None:
        instant = self._clock.instant
        if instant is None or instant != self._instant:
            self._read.clear()
            self._instant = instant

    def _make(self, key: Key, read: Read, pace: str) -> Any:  # noqa: ARG002 - for who polls
        return read()


class Glance:
    """Different questions that are asked in one breath are answered from one picture.

    Whether a line is to the left, in the middle or to the right are three questions. On a robot
    whose camera does not wait for them they would fall on different pictures now and then, and all
    be answered no. A glance ends when a question is repeated, and after `LASTS` seconds.

    Args:
        clock: the robot's; it flows by itself.
    """

    #: Seconds; a camera of 30 pictures a second takes one or two meanwhile.
    LASTS = 0.05

    def __init__(self, clock: Clock) -> None:
        self._clock = clock
        self._began = -self.LASTS
        self._asked: set[str] = set()
        self._seen: dict[Key, Any] = {}

    def see(self, question: str, key: Key, look: Read) -> Any:
        """What is seen by `look`, which is called once a glance for each `key`."""
        now = self._clock.time()
        if question in self._asked or now - self._began >= self.LASTS:
            self._asked.clear()
            self._seen.clear()
            self._began = now
        self._asked.add(question)
        if key not in self._seen:
            self._seen[key] = look()
        return self._seen[key]


class PolledReadings(Readings):
    """Readings of a real robot: threads renew those in use, so that asking never waits.

    The first question about a sensor reads it at once; from then on it is in use. An error of a
    reading thread is raised at the next question about that sensor. Each pace has a thread of its
    own, so that a detector that thinks long holds up no distance sensor.

    Args:
        clock: the robot's.
        period: seconds between two readings of a sensor.
    """

    def __init__(self, clock: Clock, period: float) -> None:
        super().__init__(clock)
        self._period = period
        self._pollers: dict[str, _Poller] = {}
        self._results: dict[Key, tuple[Any, Exception | None]] = {}
        self._changed = 0
        self._lock = threading.Lock()

    def forget(self) -> None:
        super().forget()
        with self._lock:
            self._changed += 1
            self._results.clear()

    def close(self) -> None:
        pollers = tuple(self._pollers.values())
        for poller in pollers:
            poller.end()
        for poller in pollers:
            poller.await_end()

    def poll(self, pace: str = SENSORS) -> None:
        """Read every sensor of that pace that is in use once."""
        self._pollers[pace].poll()

    def _make(self, key: Key, read: Read, pace: str) -> Any:
        result = self._results.get(key)
        if result is None:
            result = self._results[key] = _outcome(read)
            self._poller(pace).add(key, read)
        reading, error = result
        if error:
            raise error
        return reading

    def _poller(self, pace: str) -> "_Poller":
        if pace not in self._pollers:
            self._pollers[pace] = _Poller(pace, self._period, self._renew)
        return self._pollers[pace]

    def _renew(self, key: Key, read: Read) -> None:
        changed = self._changed
        result = _outcome(read)
        with self._lock:
            # What was read while the program changed it, such as a gyroscope's zero, is old.
            if changed == self._changed:
                self._results[key] = result


class _Poller:
    """A thread that renews sensors one after the other; it begins with the first.

    Args:
        name: of the thread.
        period: seconds that it rests between two rounds.
        renew: reads a sensor.
    """

    def __init__(self, name: str, period: float, renew: Callable[[Key, Read], None]) -> None:
        self._period = period
        self._renew = renew
        self._sensors: dict[Key, Read] = {}
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._run, name=name, daemon=True)

    def add(self, key: Key, read: Read) -> None:
        """Renew one more sensor."""
        self._sensors[key] = read
        if not self._thread.is_alive() and not self._ended.is_set():
            self._thread.start()

    def poll(self) -> None:
        """Renew each sensor once."""
        for key, read in tuple(self._sensors.items()):
            self._renew(key, read)

    def end(self) -> None:
        """Begin no other round."""
        self._ended.set()

    def await_end(self) -> None:
        """Wait until the thread has ended, for a moment."""
        if self._thread.is_alive() and self._thread is not threading.current_thread():
            # A reading that hangs must not keep the robot from being stopped.
            self._thread.join(timeout=2 * self._period + 0.1)

    def _run(self) -> None:
        while not self._ended.wait(self._period):
            self.poll()


def _outcome(read: Read) -> tuple[Any, Exception | None]:
    try:
        return read(), None
    except Exception as error:  # noqa: BLE001 - it is raised again where the program asks
        return None, error
