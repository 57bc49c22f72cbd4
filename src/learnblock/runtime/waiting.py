"""Waiting in a run that nobody watches, for which the host needs no turn."""

import math
from collections.abc import Callable

from learnblock.runtime.supervision import Supervision
from learnblock.runtime.world import HostedSimulation

#: Steps between two looks at whether the run is ending.
STRIDE = 10


class Waiting:
    """Lets the time of a world pass for its only program, whose run nobody watches.

    Args:
        simulation: the world.
        supervision: that of the program.
        look: looks around during the wait; returns whether the run is ending.
    """

    def __init__(
        self, simulation: HostedSimulation, supervision: Supervision, look: Callable[[], bool]
    ) -> None:
        self._simulation = simulation
        self._supervision = supervision
        self._look = look
        seconds = supervision.seconds
        self._last = math.inf if seconds is None else round(seconds / simulation.dt)

    def wait(self, steps: int) -> int | None:
        """Let so many steps pass; return the world's step counter.

        None if the run ends meanwhile: then the program has to wait as if no time had passed.
        """
        simulation = self._simulation
        wake = simulation.steps + steps
        if wake >= self._last:
            return None
        while simulation.steps < wake and not simulation.is_over:
            if self._look():
                return None
            simulation.advance(min(wake, simulation.steps + STRIDE))
        if simulation.is_over:
            return None
        self._supervision.note_time()
        return wake
