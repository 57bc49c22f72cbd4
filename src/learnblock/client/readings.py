"""The three ways a client reads its sensors: on demand, in step with its world, or by polling."""

import threading
from collections.abc import Callable, Hashable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Any

from learnblock.client.clock import Clock

Key = Hashable
Read = Callable[[], Any]

#: The pace of sensors that are fast to read: all except detectors.
SENSORS = "sensors"
#: The pace of sensors that are watched but not used by the program.
WATCHED = "watched"
#: Seconds between readings of a watched sensor; the page does not update more often.
WATCHED_PERIOD = 0.05
# Why: docs/decisions.md, "A repeated question waits for a new reading"
#: Seconds between two readings of a sensor.
READING = 0.02
#: Seconds for which a picture is used; a camera with 30 a second takes one or two in this time.
PICTURE = 0.05


class Readings:
    """The latest reading of each sensor in use.

    In a simulated world, a sensor is read at most once per time step; with a wall clock, it is read
    at every query. Inside `snapshot` every sensor is read once.

    Args:
        clock: the robot's clock.
    """

    def __init__(self, clock: Clock) -> None:
        self._clock = clock
        self._instant: int | None = None
        self._read: dict[Key, Any] = {}
        #: Whether a snapshot is being taken.
        self.frozen = False

    def ask(self, question: Key, pace: str = SENSORS) -> None:
        """Begin a question of the program, before the sensors that answer it are read.

        Args:
            question: the question with its arguments. The same object again continues the question,
                since a skill may read several sensors; an equal object repeats it.
            pace: the pace of these sensors.
        """

    def latest(self, key: Key, read: Read, pace: str = SENSORS) -> Any:
        """The latest reading of a sensor, which is read if necessary.

        Args:
            key: identifies the sensor.
            read: reads it.
            pace: sensors with the same pace share a thread, and do not wait for other sensors.
        """
        if not self.frozen:
            self._forget_the_past()
        if key not in self._read:
            self._read[key] = self._make(key, read, pace)
        return self._read[key]

    @contextmanager
    def snapshot(self) -> Iterator[None]:
        """Answer all queries from the same readings while the context is open."""
        self._read.clear()
        self.frozen = True
        try:
            yield
        finally:
            self.frozen = False

    def forget(self) -> None:
        """Read again at the next query, for example after a command that changes a sensor."""
        if not self.frozen:
            self._read.clear()

    def forget_questions(self) -> None:
        """Allow each question to be repeated once without waiting."""

    def watch(self, key: Key, read: Read) -> None:
        """Keep a sensor's reading up to date for an observer, in the background if possible.

        Args:
            key: identifies the sensor.
            read: reads it.
        """

    def newest(self, key: Key) -> Any:
        """The newest reading of a sensor, without reading it; None if there is none."""
        return self._read.get(key)

    def error(self, key: Key) -> Exception | None:  # noqa: ARG002 - see `PolledReadings`
        """The error of the last attempt to read a sensor; None if it succeeded."""
        return None

    def age(self) -> float | None:
        """Seconds since a sensor was last read; None while nothing reads sensors regularly."""
        return None

    def close(self) -> None:
        """Do nothing: no thread runs."""

    def _forget_the_past(self) -> None:
        instant = self._clock.instant
        if instant is None or instant != self._instant:
            self._read.clear()
            self._instant = instant

    def _make(self, key: Key, read: Read, pace: str) -> Any:  # noqa: ARG002 - polling needs them
        return read()


@dataclass(slots=True)
class _Interval:
    """The time between two readings of the sensors of one pace.

    Args:
        end: the robot's time in s at which it is over.
    """

    end: float
    #: The questions that have been answered in it.
    answered: set[str] = field(default_factory=set)
    #: The pictures that were taken in it, or what was found in them.
    pictures: dict[Key, Any] = field(default_factory=dict)


class SteppedReadings(Readings):
    """Readings of a program in a world that waits for it.

    A picture is kept until the next one is due. A repeated question waits for a new reading, so a
    loop that polls without sleeping runs as often as its sensors are read, not as often as the
    computer can run it.

    Args:
        clock: the robot's clock, which moves only while the program waits.
    """

    def __init__(self, clock: Clock) -> None:
        super().__init__(clock)
        self._asking: Key = None
        self._intervals: dict[str, _Interval] = {}

    def ask(self, question: Key, pace: str = SENSORS) -> None:
        if self.frozen or question is self._asking:
            return
        self._asking = question
        # As text, since a question's arguments may not be comparable.
        question_text = repr(question)
        interval = self._interval(pace)
        if question_text in interval.answered:
            self._clock.sleep(interval.end - self._clock.time())
            interval = self._interval(pace)
        interval.answered.add(question_text)

    def forget_questions(self) -> None:
        for interval in self._intervals.values():
            interval.answered.clear()

    def latest(self, key: Key, read: Read, pace: str = SENSORS) -> Any:
        if pace == SENSORS:
            return super().latest(key, read, pace)
        pictures = self._interval(pace).pictures
        if key not in pictures:
            pictures[key] = read()
        return pictures[key]

    def forget(self) -> None:
        super().forget()
        self._intervals.clear()

    def _interval(self, pace: str) -> _Interval:
        """The current interval of a pace; if the last one is over, a new one begins now."""
        now = self._clock.time()
        interval = self._intervals.get(pace)
        if interval is None or now >= interval.end:
            length = READING if pace == SENSORS else PICTURE
            interval = self._intervals[pace] = _Interval(round(now + length, 9))
        return interval


# Why: docs/decisions.md, "Questions that belong together are answered from one picture"
class Glance:
    """Answers queries in quick succession from the same picture.

    "Line on the left?", "in the middle?" and "on the right?" are three queries. With a real
    camera they could be answered from different pictures, all with no. A glance ends when a
    query is repeated, or after `PICTURE` seconds.

    Args:
        clock: the robot's wall clock.
    """

    def __init__(self, clock: Clock) -> None:
        self._clock = clock
        self._began = -PICTURE
        self._asked: set[str] = set()
        self._seen: dict[Key, Any] = {}

    def see(self, question: str, key: Key, look: Read) -> Any:
        """The result of `look`, called once per glance and `key`."""
        now = self._clock.time()
        if question in self._asked or now - self._began >= PICTURE:
            self._asked.clear()
            self._seen.clear()
            self._began = now
        self._asked.add(question)
        if key not in self._seen:
            self._seen[key] = look()
        return self._seen[key]


class PolledReadings(Readings):
    """Readings of a real robot: threads poll the sensors in use, so that queries never wait.

    The first query of a sensor reads it at once; from then on it is polled. An error in a
    polling thread is raised at the next query of that sensor. Each pace has its own thread,
    so that a slow detector does not delay a distance sensor.

    Args:
        clock: the robot's clock.
        period: seconds between two readings of a sensor.
    """

    def __init__(self, clock: Clock, period: float) -> None:
        super().__init__(clock)
        self._period = period
        self._pollers: dict[str, _Poller] = {}
        #: The program, the page and the log may each be the first to ask.
        self._creating = threading.Lock()
        self._results: dict[Key, tuple[Any, Exception | None]] = {}
        #: The sensors that the program uses.
        self._used: set[Key] = set()
        self._last_read: float | None = None
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

    def watch(self, key: Key, read: Read) -> None:
        self._poller(WATCHED).add(key, read)

    def newest(self, key: Key) -> Any:
        return self._results.get(key, (None, None))[0]

    def error(self, key: Key) -> Exception | None:
        return self._results.get(key, (None, None))[1]

    def age(self) -> float | None:
        return None if self._last_read is None else self._clock.time() - self._last_read

    def poll(self, pace: str = SENSORS) -> None:
        """Read every sensor in use with this pace once."""
        self._pollers[pace].poll()

    def _make(self, key: Key, read: Read, pace: str) -> Any:
        result = self._results.get(key) if key in self._used else None
        if result is None:
            result = self._results[key] = _outcome(read)
            self._used.add(key)
            self._poller(pace).add(key, read)
        reading, error = result
        if error:
            raise error
        return reading

    def _poller(self, pace: str) -> "_Poller":
        with self._creating:
            if pace not in self._pollers:
                watched = pace == WATCHED
                period = max(self._period, WATCHED_PERIOD) if watched else self._period
                renew = self._renew_unused if watched else self._renew
                self._pollers[pace] = _Poller(pace, period, renew)
            return self._pollers[pace]

    def _renew_unused(self, key: Key, read: Read) -> None:
        """The program's sensors are polled anyway, so they need not be polled twice."""
        if key not in self._used:
            self._renew(key, read)

    def _renew(self, key: Key, read: Read) -> None:
        version = self._changed
        result = _outcome(read)
        if result[1] is None:
            self._last_read = self._clock.time()
        with self._lock:
            # A reading that overlaps a change of the sensor, such as a reset, is out of date.
            if version == self._changed:
                self._results[key] = result


class _Poller:
    """A thread that polls sensors one after the other; it starts with the first sensor.

    Args:
        name: the thread's name.
        period: seconds between two rounds.
        renew: reads a sensor.
    """

    def __init__(self, name: str, period: float, renew: Callable[[Key, Read], None]) -> None:
        self._period = period
        self._renew = renew
        self._sensors: dict[Key, Read] = {}
        self._ended = threading.Event()
        self._starting = threading.Lock()
        self._thread = threading.Thread(target=self._run, name=name, daemon=True)

    def add(self, key: Key, read: Read) -> None:
        """Poll one more sensor."""
        self._sensors[key] = read
        with self._starting:
            if not self._thread.is_alive() and not self._ended.is_set():
                self._thread.start()

    def poll(self) -> None:
        """Read each sensor once."""
        for key, read in tuple(self._sensors.items()):
            self._renew(key, read)

    def end(self) -> None:
        """Stop after this round."""
        self._ended.set()

    def await_end(self) -> None:
        """Wait a moment for the thread to end."""
        if self._thread.is_alive() and self._thread is not threading.current_thread():
            # A reading that hangs must not prevent the robot from being stopped.
            self._thread.join(timeout=2 * self._period + 0.1)

    def _run(self) -> None:
        while not self._ended.wait(self._period):
            self.poll()


def _outcome(read: Read) -> tuple[Any, Exception | None]:
    try:
        return read(), None
    except Exception as error:  # noqa: BLE001 - raised again when the program asks
        return None, error
