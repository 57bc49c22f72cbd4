"""The robot host: it owns the robots, and runs programs as child processes.

In a simulated world programs take turns: each runs until it waits, then the world advances to the
first wake-up. One thread does all this, so a run depends only on program, world and seed.
"""

import math
from collections.abc import Sequence
from contextlib import ExitStack
from time import monotonic

from learnblock.i18n import Phrase
from learnblock.runtime.ending import Ending, How
from learnblock.runtime.run import Run
from learnblock.runtime.world import HostedSimulation

#: Steps between turns of watchers: 25 per second in real time.
STRIDE = 4
#: Seconds of the wall clock between checks on debuggers, resources and variables, at least.
LOOKING_PERIOD = 0.005


class Host:
    """Runs programs to their end: one on a real robot, or any number in one simulated world.

    Args:
        runs: the runs, in the order in which their robots take turns.
        seconds: the run ends when the robot's time reaches this; None for no limit.
    """

    def __init__(self, *runs: Run, seconds: float | None = None) -> None:
        self._runs = runs
        self._seconds = seconds
        #: When the runs last looked around, in seconds of the wall clock.
        self._looked = -LOOKING_PERIOD
        for run in runs:
            run.supervision.seconds = seconds
            run.world.is_private = len(runs) == 1

    def run(self) -> None:
        """Run all programs; return when each has its `ending`."""
        with ExitStack() as endings:
            for run in self._runs:
                endings.callback(run.end)
                run.start()
            for run in self._runs:
                run.serve()
            self._take_turns()

    def stop(self) -> None:
        """End all programs within a second; may be called from any thread."""
        self._stop(Ending(How.STOPPED, Phrase("run-stopped")))

    def abort(self) -> None:
        """Kill all programs, for one that `stop` has not ended; may be called from any thread."""
        for run in self._runs:
            run.abort()

    def _take_turns(self) -> None:
        while parked := [run for run in self._runs if run.wake is not None]:
            simulation = parked[0].simulation
            assert simulation is not None  # noqa: S101 - only a simulated program parks
            limit = self._last_step(simulation)
            wake = min([run.wake for run in parked if run.wake is not None])
            self._advance(simulation, min(wake, limit))
            if simulation.is_over:
                self._stop(Ending.of_game())
            elif simulation.steps >= limit:
                self._stop(Ending.time_is_up(limit * simulation.dt))
            self._wake([run for run in parked if run.stopping or _is_due(run, simulation)])

    def _wake(self, due: Sequence[Run]) -> None:
        """Wake programs together, on all processors, but serve them in turn.

        Commands take effect with the next step, so it makes no difference to the programs or to the
        trace that they run at the same time.
        """
        for run in due:
            if not run.stopping:
                run.release()
        for run in due:
            if run.stopping:
                run.end()
            else:
                run.serve()

    def _advance(self, simulation: HostedSimulation, step: float) -> None:
        """Advance in short strides, so that a watcher sees progress during a long wait."""
        while simulation.steps < step and not (self._is_stopping or simulation.is_over):
            simulation.advance(min(int(step), simulation.steps + STRIDE))
            self._look()

    def _look(self) -> None:
        """Give the watchers a turn after each stride, on which what they do to a world depends.

        Runs look around as well, unless they have just done so: a world may be very fast.
        """
        now = monotonic()
        is_due = now - self._looked >= LOOKING_PERIOD
        if is_due:
            self._looked = now
        for run in self._runs:
            if run.ending is None:
                run.watcher.tick()
                if is_due:
                    run.look()

    @property
    def _is_stopping(self) -> bool:
        """Whether a program that waits for the world has to be stopped."""
        return any(run.stopping and run.wake for run in self._runs)

    def _last_step(self, simulation: HostedSimulation) -> float:
        return math.inf if self._seconds is None else round(self._seconds / simulation.dt)

    def _stop(self, ending: Ending) -> None:
        for run in self._runs:
            run.stop(ending)


def _is_due(run: Run, simulation: HostedSimulation) -> bool:
    """Whether its step has come; a run that has to be stopped interrupts the wait of the others."""
    return run.wake is not None and run.wake <= simulation.steps
