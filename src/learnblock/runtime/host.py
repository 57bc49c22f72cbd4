"""The robot host: it owns the robots, and runs programs as child processes.

In a simulated world programs take turns: each runs until it waits, then the world advances to the
first wake-up. One thread does all this, so a run depends only on program, world and seed.
"""

from collections.abc import Sequence
from contextlib import ExitStack

from learnblock.i18n import Phrase
from learnblock.runtime.ending import Ending, How
from learnblock.runtime.run import Run
from learnblock.runtime.world import Simulation

#: Steps between checks on watchers and debuggers: 25 checks per second in real time.
STRIDE = 4


class Host:
    """Runs programs to their end: one on a real robot, or any number in one simulated world.

    Args:
        runs: the runs, in the order in which their robots take turns.
        seconds: the run ends when the robot's time reaches this; None for no limit.
    """

    def __init__(self, *runs: Run, seconds: float | None = None) -> None:
        self._runs = runs
        self._seconds = seconds
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

    def _take_turns(self) -> None:
        while parked := [run for run in self._runs if run.wake is not None]:
            simulation = parked[0].simulation
            assert simulation is not None  # noqa: S101 - only a simulated program parks
            wake = min(run.wake for run in parked if run.wake is not None)
            limit = self._last_step(simulation)
            self._advance(simulation, wake if limit is None else min(wake, limit))
            if limit is not None and simulation.steps >= limit:
                self._stop(Ending.time_is_up(limit * simulation.dt))
            self._wake([run for run in parked if run.wake == wake or run.stopping])

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

    def _advance(self, simulation: Simulation, step: int) -> None:
        """Advance in short strides, so that a watcher sees progress during a long wait."""
        while simulation.steps < step and not any(run.stopping for run in self._runs if run.wake):
            simulation.advance(min(step, simulation.steps + STRIDE))
            for run in self._runs:
                run.look()

    def _last_step(self, simulation: Simulation) -> int | None:
        return None if self._seconds is None else round(self._seconds / simulation.dt)

    def _stop(self, ending: Ending) -> None:
        for run in self._runs:
            run.stop(ending)
