"""What a check finds in a run, or in its part so far."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Literal

from learnblock.evidence.evidence import Evidence, Moment
from learnblock.i18n import Phrase
from learnblock.simulator import WorldDescription

State = Literal["open", "met", "failed"]
#: Seconds by which a rounded time may be late.
ROUNDING = 1e-6


@dataclass(frozen=True, slots=True)
class Finding:
    """What a check has found: see `Verdict`."""

    state: State
    at: float | None = None
    reason: Phrase | None = None


OPEN = Finding("open")


@dataclass(frozen=True)
class RunSoFar:
    """A run, or its part so far.

    Args:
        evidence: what is known of it.
        world: its world.
        seconds: the most seconds that it takes.
    """

    evidence: Evidence
    world: WorldDescription | None
    seconds: float

    @property
    def has_ended(self) -> bool:
        """Whether it is over."""
        return self.evidence.has_ended

    @property
    def now(self) -> float:
        """Seconds of the robot's time."""
        return self.evidence.now

    def is_over(self, within: float | None) -> bool:
        """Whether nothing counts any more that happens from now on."""
        return self.has_ended or (within is not None and self.now > within)

    def in_time(self, occurrences: Sequence[Moment], within: float | None) -> Sequence[Moment]:
        """What happened within some seconds, if there is such a limit."""
        return (
            occurrences
            if within is None
            else [moment for moment in occurrences if moment.time <= within + ROUNDING]
        )


def met_at(at: float | None) -> Finding:
    """The finding of a check that is met at a time in s."""
    return Finding("met", at)


def failed_at(at: float | None, code: str, /, **values: Any) -> Finding:
    """The finding of a check that has failed at a time in s, with the code of the reason."""
    return Finding("failed", at, Phrase(code, **values))
