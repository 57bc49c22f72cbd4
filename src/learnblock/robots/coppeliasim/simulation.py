"""Starts and stops CoppeliaSim's simulation."""

from learnblock.errors import RobotConnectionError
from learnblock.robots.coppeliasim.remote import Remote
from learnblock.timing import MONOTONIC, Deadline, SteadyClock

#: Seconds between two looks at a simulation that is starting.
PAUSE = 0.02

#: The states of a simulation, by the numbers of ``sim.getSimulationState`` (regular API constants).
STOPPED, PAUSED = 0, 8
#: The states in which robots move: first step after a stop, running, first step after a pause.
MOVING = frozenset({16, 17, 20})


class SceneSimulation:
    """The simulation of a scene; if LearnBlock has started it, LearnBlock also stops it.

    Args:
        remote: the connection to CoppeliaSim.
        timeout: how long to wait for the start, in seconds.
        clock: the clock of this limit.
    """

    def __init__(self, remote: Remote, timeout: float, clock: SteadyClock = MONOTONIC) -> None:
        self._remote = remote
        self._timeout = timeout
        self._clock = clock
        self._ours = False

    def start(self) -> None:
        """Run the simulation in real time, like the program.

        Raises:
            RobotConnectionError: it does not start.
        """
        real_time = self._remote.constant("boolparam_realtime_simulation")
        self._remote.call("setBoolParam", real_time, True)  # noqa: FBT003 - the API's signature
        deadline = Deadline.after(self._timeout, self._clock)
        while (state := self._state()) not in MOVING:
            if deadline.is_over:
                raise RobotConnectionError("coppeliasim-not-started", place=self._remote.place)
            if state in {STOPPED, PAUSED}:
                self._ours = self._ours or state == STOPPED
                self._remote.call("startSimulation")
            self._clock.sleep(min(PAUSE, deadline.left))

    def check(self) -> None:
        """Check that the simulation has not been stopped; it may be paused.

        Raises:
            RobotConnectionError: it is stopped, or CoppeliaSim does not respond.
        """
        if self._state() == STOPPED:
            raise RobotConnectionError("coppeliasim-stopped", place=self._remote.place)

    def end(self) -> None:
        """Stop the simulation if LearnBlock has started it."""
        if self._ours:
            self._ours = False
            self._remote.call("stopSimulation")

    def _state(self) -> int:
        state = self._remote.call("getSimulationState")
        if not isinstance(state, int):
            raise self._remote.bad_answer("sim.getSimulationState", f"{state!r:.80}")
        return state
