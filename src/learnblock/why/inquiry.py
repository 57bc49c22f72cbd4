"""The data for answering one question about a run."""

from dataclasses import dataclass
from functools import cached_property

from learnblock.why.history import EventHistory
from learnblock.why.position import Position
from learnblock.why.readings import Readings
from learnblock.why.sentences import Draft
from learnblock.why.slices import Slices
from learnblock.why.unused import Unused
from learnblock.why.wheel_commands import WheelCommands


@dataclass(frozen=True)
class Inquiry:
    """One question about a run: the data about the run, and the answer so far.

    Args:
        slices: of the run.
        readings: of the run.
        unused: of the run.
        draft: the answer so far; it never repeats a sentence.
        time: the moment in question, or the end of the time, in s; None for the whole run.
        since: the start of the time in question, in s; None for a moment or the whole run.
    """

    slices: Slices
    readings: Readings
    unused: Unused
    draft: Draft
    time: float | None = None
    since: float | None = None

    @property
    def history(self) -> EventHistory:
        """The history of the run."""
        return self.slices.history

    @cached_property
    def position(self) -> Position:
        """Where the program of the run was."""
        return Position(self.slices)

    @cached_property
    def commands(self) -> WheelCommands:
        """The commands to the wheels of the run."""
        return WheelCommands(self.slices)
