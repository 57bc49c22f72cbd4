"""The log of a run as far as it has been read, and its moments; slow to load."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from time import monotonic

from learnblock.errors import LearnBlockError
from learnblock.monitor.monitor import Picture
from learnblock.monitor.world_monitor import WorldMonitor
from learnblock.runtime.log.blocks import EventBlock
from learnblock.runtime.log.noting import TICK
from learnblock.server import messages
from learnblock.server.runs import telemetry
from learnblock.server.runs.line_blocks import LineBlocks
from learnblock.server.runs.reported import Reported
from learnblock.server.runs.telemetry import Drawn
from learnblock.why import EventHistory
from learnblock.why.answers import Answers
from learnblock.why.moments import Moments
from learnblock.why.recorded import Recorded
from learnblock.why.steps import START, Place, Steps, To
from learnblock.why.things import seen_in
from learnblock.why.values_there import values_there
from learnblock.why.world_again import WorldAgain


@dataclass(frozen=True)
class Reading:
    """What a log tells about a run; if the run continues, it is read again as a new `Reading`.

    Args:
        history: what happened.
        moments: what was true when.
        steps: the places that one can go to.
        reported: what a real robot reported.
        world: the world, run again; None for a real robot, or if the world is not here.
        blocks: the blocks of the program's lines.
        size: how many blocks the log had.
        read_at: when it had been read, on the system's clock.
        cost: how long that took, in s.
    """

    history: EventHistory
    moments: Moments
    steps: Steps
    reported: Reported
    world: WorldAgain | None
    blocks: LineBlocks
    size: int
    read_at: float
    cost: float

    @classmethod
    def of(
        cls, log: Sequence[EventBlock], blocks: LineBlocks, before: "Reading | None"
    ) -> "Reading":
        """Read a log.

        Args:
            log: its blocks.
            blocks: the blocks of the program's lines.
            before: what had been read of it; its world is continued.
        """
        began = monotonic()
        recorded = Recorded.of(log)
        history = EventHistory(recorded)
        moments = Moments(history)
        steps, reported = Steps(history, moments), Reported(recorded)
        world = before.extended_world(recorded) if before else None
        world = world or _world_again(recorded)
        now = monotonic()
        return cls(history, moments, steps, reported, world, blocks, len(log), now, now - began)

    def extended_world(self, recorded: Recorded) -> WorldAgain | None:
        """Its world, continued; None if the new log does not simply extend the old one."""
        before, lines = self.history.recorded.lines, recorded.lines
        known = len(before)
        is_longer = known and lines[known - 1] == before[-1]
        # The lines of the other robots of a team are known at its end only.
        if not is_longer or self.world is None or recorded.team:
            return None
        self.world.extend(lines[known:])
        return self.world

    @cached_property
    def answers(self) -> Answers:
        """What answers questions about it."""
        return Answers(self.history, seen_in(self.world) if self.world else None)

    def past(self, asked: messages.LookBack) -> messages.Past:
        """The run at a place, or at the one before or after it."""
        place, reached = self._place(asked), self.reached(asked)
        tick, event = reached or place
        time = min(asked.time, self.history.end) if reached == place else round(tick * TICK, 3)
        moment = self.moments.at(time, event)
        is_whole = event == self.history.at(time)
        line = moment.line if is_whole else self.steps.line_at((tick, event))
        whens = tuple(messages.WhenNow(name, *state) for name, state in moment.whens.items())
        return messages.Past(
            time,
            event,
            messages.RunningLine(line, self.blocks.at(line)),
            messages.Variables(moment.local, moment.shared, whens),
            reached is not None,
            self._values(event, line),
            moment.stack,
            moment.printed,
            *self._world_at(time),
        )

    def reached(self, asked: messages.LookBack) -> Place | None:
        """The place to which a request leads; None if there is none. The world stays as it is."""
        place = self._place(asked)
        return self._go(asked, place) if asked.step else place

    def last_values(self) -> tuple[messages.ValueThere, ...]:
        """The values next to the lines after the last event."""
        history = self.history
        return self._values(len(history.events) - 1, self.moments.line_at(history.end))

    def picture(self, time: float) -> Picture | None:
        """What the robot's camera saw at a time in s; None if that is not known."""
        return WorldMonitor.of(self.world.seek(time)).camera() if self.world else None

    def _place(self, asked: messages.LookBack) -> Place:
        tick, last = self.steps.at(min(asked.time, self.history.end))
        return tick, last if asked.event is None else min(asked.event, last)

    def _go(self, asked: messages.LookBack, place: Place) -> Place | None:
        to = To(asked.to)
        subject = self.blocks.lines(asked.subject) if to is To.RUN else asked.subject
        reached = self.steps.go(asked.step, place, to, subject)
        if reached or to not in (To.LINE, To.EVENT, To.TURN):
            return reached
        # The run begins before the first line, and ends after the last one.
        end = START if asked.step < 0 else self.steps.at(self.history.end)
        return None if end == place else end

    def _values(self, event: int, line: int) -> tuple[messages.ValueThere, ...]:
        heads = self.blocks.heads(node.line for node in self.history.nodes)
        return tuple(
            messages.ValueThere(heads[value.line], value.name, value.value)
            for value in values_there(self.history, self.moments, event, line)
            if value.line in heads
        )

    def _world_at(self, time: float) -> tuple[messages.Telemetry | None, messages.Drawing | None]:
        if self.world is None:
            state = self.reported.at(time)
            return telemetry.of_state(state) if state else None, None
        monitor = WorldMonitor.of(self.world.seek(time))
        return telemetry.telemetry(monitor), Drawn().news(monitor.strokes())


def _world_again(recorded: Recorded) -> WorldAgain | None:
    try:
        return WorldAgain(recorded)
    except LearnBlockError:
        # A real robot, or a world that is not here: the recorded data can still be shown.
        return None
