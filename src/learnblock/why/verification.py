"""Logs from elsewhere: read with limits, and checked before anything shows them.

A log is data, and nothing in it is run. But a damaged or hostile one could unpack to any size, or
make its readers fail or work for hours, so all of that is tried once, here.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from time import monotonic
from typing import Any

from learnblock.errors import LearnBlockError
from learnblock.runtime.log.blocks import MAGIC, EventBlock, EventStream, stored
from learnblock.why.calls import calls
from learnblock.why.history import EventHistory
from learnblock.why.moments import Moments
from learnblock.why.recorded import Recorded
from learnblock.why.world_again import WorldAgain

#: The largest file, in bytes; ours have 32 MiB and the last addition.
LARGEST = 40 * 1024 * 1024
#: The most bytes that it may unpack to.
MOST_DATA = 192 * 1024 * 1024
#: The longest run that is shown, in s.
LONGEST = 1_000_000.0
#: How long its world may take to run again, in s.
PATIENCE = 20.0
#: The part of a run, in s, after which that is checked.
PART = 10.0
#: Lines about the whole run, and those with a place: mm, mm and degrees.
_TIMELESS, _PLACES = frozenset({"run", "robot", "team"}), ("pose", "odometry", "placed")
#: Characters that are in a path and not in the name of a world.
_OF_PATHS = frozenset("/\\:")


@dataclass(frozen=True)
class Verified:
    """A log that can be shown.

    Args:
        blocks: what it contains.
        recorded: the same, read.
        has_world: whether its world can be shown at any moment.
    """

    blocks: tuple[EventBlock, ...]
    recorded: Recorded
    has_world: bool

    @property
    def complete_since(self) -> int:
        """The oldest detail that it has, in ticks."""
        return complete_since(self.blocks)


def complete_since(blocks: Iterable[EventBlock]) -> int:
    """The oldest detail that a log has, in ticks: a full one has given up what was before."""
    return next((block.first for block in blocks if block.stream is EventStream.PROGRAM), 0)


def verified(data: bytes, now: Callable[[], float] = monotonic) -> Verified:
    """Check the bytes of a log's file.

    Args:
        data: the file.
        now: returns the time of a monotonic clock in seconds.

    Raises:
        LearnBlockError: it is not a log, too large, or takes too long.
    """
    blocks = _blocks(data)
    with _refusing():
        history = _sound(blocks)
        has_world = _runs_again(history.recorded, history.end, now)
    return Verified(blocks, history.recorded, has_world)


def history_of(data: bytes) -> EventHistory:
    """Read the bytes of a log's file, for all that does not need its world.

    Raises:
        LearnBlockError: it is not a log, or too large.
    """
    blocks = _blocks(data)
    with _refusing():
        return _sound(blocks)


@contextmanager
def _refusing() -> Iterator[None]:
    """Refuse a log for any error that a hostile one may cause in its readers."""
    try:
        yield
    except LearnBlockError:
        raise
    except Exception as error:
        raise LearnBlockError("log-not-a-log") from error


def _sound(blocks: Iterable[EventBlock]) -> EventHistory:
    history = EventHistory(Recorded.of(blocks))
    _require_sound(history)
    Moments(history).at(history.end)
    calls(history)
    return history


def _blocks(data: bytes) -> tuple[EventBlock, ...]:
    if len(data) > LARGEST:
        raise LearnBlockError("log-file-too-large", most=LARGEST // 2**20)
    if not data.startswith(MAGIC):
        raise LearnBlockError("log-not-a-log")
    blocks = tuple(stored(data[len(MAGIC) :]))
    unpacked = 0
    for block in blocks:
        try:
            unpacked += len(block.data)
        except ValueError as error:
            raise LearnBlockError("log-not-a-log") from error
        if unpacked > MOST_DATA:
            raise LearnBlockError("log-file-too-large", most=LARGEST // 2**20)
    return blocks


def _require_sound(history: EventHistory) -> None:
    if not 0 <= history.end <= LONGEST or not all(map(_is_sound, history.recorded.lines)):
        raise LearnBlockError("log-not-a-log")
    nodes = len(history.nodes)
    if any(not 0 <= node < nodes for node in history.of_node):
        # A negative number would be another place.
        raise LearnBlockError("log-not-a-log")


def _is_sound(line: Mapping[str, Any]) -> bool:
    """Whether a line has its time, and places that are places."""
    has_time = isinstance(line.get("t"), int | float) or not _TIMELESS.isdisjoint(line)
    places = (line[name] for name in _PLACES if name in line)
    return has_time and all(map(_is_place, places))


def _is_place(value: object) -> bool:
    if not isinstance(value, list) or len(value) != 3:
        return False
    return all(isinstance(number, int | float) for number in value)


def _runs_again(recorded: Recorded, end: float, now: Callable[[], float]) -> bool:
    """Run the world again to its end; return whether there is one here.

    Raises:
        LearnBlockError: that takes too long.
    """
    world = recorded.robot.get("world")
    if isinstance(world, dict) and _OF_PATHS & set(str(world.get("name", ""))):
        # A path would be opened on this computer.
        raise LearnBlockError("log-not-a-log")
    try:
        again = WorldAgain(recorded)
    except LearnBlockError:
        return False
    deadline, time = now() + PATIENCE, 0.0
    while time < end:
        time = min(time + PART, end)
        again.seek(time)
        if now() > deadline:
            raise LearnBlockError("log-takes-too-long", most=PATIENCE)
    return True
