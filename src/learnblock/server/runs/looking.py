"""Looks back at a run: its moments, and its call graph."""

import re
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from threading import Lock, Thread
from time import monotonic
from typing import TYPE_CHECKING, Protocol

from msgspec.structs import replace

from learnblock.runtime.log.blocks import EventBlock, EventStream
from learnblock.runtime.log.noting import TICK
from learnblock.server import messages
from learnblock.server.messages.looking import MOST_MARKS, MOST_POINTS
from learnblock.server.runs.line_blocks import LineBlocks
from learnblock.server.runs.live_timeline import LiveTimeline
from learnblock.server.runs.reported import predicted

if TYPE_CHECKING:
    from learnblock.monitor.monitor import Picture
    from learnblock.server.runs.reading import Reading
    from learnblock.why import Recorded
    from learnblock.why.calls import Calls

#: Reading the log of a run that goes on is long from so many seconds on; then it is not read again
#: before so many times that time has passed.
LONG, PATIENCE = 0.05, 20
NO_TIMELINE = messages.Timeline(0.0)


class Log(Protocol):
    """The log of a run in progress, or of a kept one."""

    @property
    def blocks(self) -> tuple[EventBlock, ...]:
        """Its current content, oldest first."""

    @property
    def complete_since(self) -> int:
        """The oldest detail that it still has, in ticks."""


class Looking:
    """A run that pages look back at; its methods are slow, and may be called from any thread.

    Args:
        log: the log of the run, which may be in progress.
        blocks: for each line of the program's Python, its block; None for a line without one.
    """

    def __init__(self, log: Log, blocks: Sequence[str | None]) -> None:
        self.log = log
        self._blocks = LineBlocks(blocks)
        #: The log as far as it has been read; None before the first look.
        self._reading: Reading | None = None
        self._live = LiveTimeline()
        self._lock = Lock()
        #: Held by the next caller; see `_turn`.
        self._next = Lock()
        self._preparing: Thread | None = None

    def timeline(self, *, live: bool = False) -> messages.Timeline:
        """The run so far.

        Args:
            live: whether it is in progress, so that only what is quickly found out is included.
        """
        with self._turn():
            if live:
                return self._live.read(self.log.blocks)
            reading = self._now()
            if reading.world:
                self._prepare()
            marks = reading.moments.marks[-MOST_MARKS:]
            return messages.Timeline(
                reading.history.end,
                reading.world is not None,
                round(self.log.complete_since * TICK, 2),
                tuple(messages.TimeMark(mark.time, mark.kind, mark.text) for mark in marks),  # type: ignore[arg-type] # the same kinds
                way(reading.history.recorded),
                _missed(reading.history.recorded),
            )

    def wait_until_prepared(self) -> None:
        """Wait until going back in the world is fast."""
        if self._preparing:
            self._preparing.join()

    def past(self, request: messages.LookBack) -> messages.Past:
        """The run at a place, or at the one before or after it."""
        with self._turn():
            return self._now(request.time).past(request)

    def reached(self, request: messages.LookBack) -> tuple[float, int] | None:
        """The time in s and the event to which a request leads; None if there is no such place.

        Much faster than `past`, since the world need not be run up to there.
        """
        with self._turn():
            place = self._now(request.time).reached(request)
        return place and (round(place[0] * TICK, 3), place[1])

    def picture(self, time: float) -> "Picture | None":
        """What the robot's camera saw at a time in s; None if that is not known."""
        with self._turn():
            return self._now(time).picture(time)

    def predicted(self) -> messages.Predicted:
        """Where the twin of a real robot would have been."""
        with self._turn():
            recorded = self._now().history.recorded
        return predicted(recorded)

    def values(self, now: Mapping[str, str]) -> messages.ValuesThere:
        """The values next to the lines of a program that is paused now.

        Args:
            now: the program's variables as it reported them; a log that is not up to date yet
                gives nothing.
        """
        with self._turn():
            values = self._now().last_values()
        if any(_is_late(value, now) for value in values):
            return messages.ValuesThere()
        return messages.ValuesThere(
            tuple(replace(value, value=now.get(value.name, value.value)) for value in values)
        )

    def calls(self, first: float, last: float | None) -> messages.CallGraph:
        """The call graph of a part of the run."""
        from learnblock.why.calls import calls  # noqa: PLC0415 - the page opens before it is needed

        with self._turn():
            graph = calls(self._now().history, first, last)
        return call_graph(graph)

    def questions(self, block: str, time: float | None) -> messages.Questions:
        """What can be asked about the run, about a block, or about the robot at a time in s."""
        from learnblock.server.runs.answering import questions  # noqa: PLC0415 - as above

        with self._turn():
            reading = self._now()
        return questions(reading, block, time)

    def answer(self, question: messages.WhyQuestion) -> messages.WhyAnswer:
        """The answer to a question."""
        from learnblock.server.runs.answering import answer  # noqa: PLC0415 - as above

        with self._turn():
            return answer(self._now(), question)

    @contextmanager
    def _turn(self) -> Iterator[None]:
        """Get exclusive use of the run; the thread that prepares the world lets others go first."""
        with self._next:
            self._lock.acquire()
        try:
            yield
        finally:
            self._lock.release()

    def _now(self, time: float | None = None) -> "Reading":
        """The run as it is now, or at least up to a time in s; read again if it has continued."""
        from learnblock.server.runs.reading import Reading  # noqa: PLC0415 - as above

        if self._reading is None or not self._is_enough(self._reading, time):
            self._reading = Reading.of(self.log.blocks, self._blocks, self._reading)
        return self._reading

    def _is_enough(self, reading: "Reading", time: float | None) -> bool:
        """Whether what has been read is enough for a time in s, or for all; see `_now`."""
        if time is not None and time <= reading.history.end:
            # What has happened by then no longer changes.
            return True
        blocks = self.log.blocks
        if time is not None and blocks[-1].stream is not EventStream.ENDING:
            is_early = monotonic() - reading.read_at < PATIENCE * reading.cost
            return reading.cost > LONG and is_early
        return len(blocks) == reading.size

    def _prepare(self) -> None:
        """Prepare for going back in the world while no page is looking back."""
        if self._preparing is None or not self._preparing.is_alive():
            self._preparing = Thread(target=self._prepare_world, name="past", daemon=True)
            self._preparing.start()

    def _prepare_world(self) -> None:
        more = True
        while more:
            with self._turn():
                world = self._reading.world if self._reading else None
                more = world is not None and world.prepare()


def _is_late(value: messages.ValueThere, now: Mapping[str, str]) -> bool:
    """Whether the log has another value than the program; it cuts long ones and has no objects."""
    is_whole = not re.search(r"<|\.\.\.| more", value.value)
    return is_whole and now.get(value.name, value.value) != value.value


def call_graph(graph: "Calls") -> messages.CallGraph:
    """A call graph as pages draw it."""
    numbers = {node.called: number for number, node in enumerate(graph.nodes)}
    return messages.CallGraph(
        graph.robot,
        graph.first,
        graph.last,
        tuple(
            messages.CalledFunction(
                int(node.called.layer), node.called.name, node.count, node.seconds, node.share
            )
            for node in graph.nodes
        ),
        tuple(
            messages.CallEdge(
                numbers[edge.caller],
                numbers[edge.callee],
                edge.count,
                edge.seconds,
                edge.share,
                edge.first,
                edge.event,
            )
            for edge in graph.edges
        ),
    )


def _missed(recorded: "Recorded") -> messages.MissedGoal | None:
    """The first goal that a run has missed, if that has a place."""
    from learnblock.why.missed import first_missed  # noqa: PLC0415 - the page opens before it is needed

    miss = first_missed(recorded)
    if miss is None or miss.place is None or miss.nearest is None:
        return None
    return messages.MissedGoal(miss.words, miss.place, miss.nearest)


def way(recorded: "Recorded") -> tuple[tuple[float, float, float], ...]:
    """Where the robot was, if that is known: the time in s, mm east and mm north."""
    reported = ((line, line.get("pose") or line.get("odometry")) for line in recorded.lines)
    poses = [(line["t"], pose[0], pose[1]) for line, pose in reported if pose]
    return tuple(poses[:: 1 + len(poses) // MOST_POINTS])
