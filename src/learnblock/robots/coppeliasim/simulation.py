"""CoppeliaSim's simulation, which must run while a robot of its scene is used."""

from threading import Event
from time import monotonic

from learnblock.errors import RobotConnectionError
from learnblock.robots.coppeliasim.remote import Remote

#: The states of a simulation, as ``sim.getSimulationState`` numbers them (regular API constants).
STOPPED, PAUSED = 0, 8
#: Those in which robots move: first step after a stop, running, first step after a pause.
MOVING = frozenset({16, 17, 20})


class Simulation:
    """The simulation of a scene; started if nobody has, and then also stopped at the end.

    Args:
        remote: where it runs.
        patience: seconds in which it must have started.
    """

    def __init__(self, remote: Remote, patience: float) -> None:
        self._remote = remote
        self._patience = patience
        self._ours = False

    def start(self) -> None:
        """Have it run, as fast as the wall clock: a robot's time is the program's.

        Raises:
            RobotConnectionError: it does not start.
        """
        real_time = self._remote.constant("boolparam_realtime_simulation")
        self._remote.call("setBoolParam", real_time, True)  # noqa: FBT003 - as the API has it
        deadline, pause = monotonic() + self._patience, Event()
        while (state := self._state()) not in MOVING:
            if monotonic() > deadline:
                raise RobotConnectionError(
                    f"the simulation of {self._remote.place} does not start: does it show an error?"
                )
            if state in {STOPPED, PAUSED}:
                self._ours = self._ours or state == STOPPED
                self._remote.call("startSimulation")
            pause.wait(0.02)

    def check(self) -> None:
        """Say so if somebody has stopped it; paused, it only stands still.

        Raises:
            RobotConnectionError: it is stopped, or cannot be asked.
        """
        if self._state() == STOPPED:
            raise RobotConnectionError(
                f"the simulation of {self._remote.place} was stopped: run the program again"
            )

    def end(self) -> None:
        """Stop it if it was started here."""
        if self._ours:
            self._ours = False
            self._remote.call("stopSimulation")

    def _state(self) -> int:
        state = self._remote.call("getSimulationState")
        if not isinstance(state, int):
            raise self._remote.nonsense("sim.getSimulationState", f"{state!r:.80}")
        return state
