"""Supervision of a running program: its silence, its output and its time."""

from collections.abc import Callable
from time import monotonic, thread_time

from learnblock.i18n import Phrase
from learnblock.runtime.activity import Activity, Silence
from learnblock.runtime.containment.scratch import Usage
from learnblock.runtime.ending import Ending, How
from learnblock.runtime.hosted_robot import HostedRobot
from learnblock.runtime.limits import MEGABYTE, Limits

#: Seconds of the wall clock between two checks.
PERIOD = 0.05
#: Seconds of the wall clock between two checks of resources, which take longer.
USAGE_PERIOD = 0.1
#: Calls of a program at one moment of its world that count: honest ones make time pass.
MOST_CALLS_AT_ONE_TIME = 1000


class Supervision:
    """Decides when a program has to be stopped.

    Args:
        limits: the resources that the program may use.
        robot: the program's robot.
    """

    def __init__(self, limits: Limits, robot: HostedRobot) -> None:
        #: Seconds of a real robot's time after which the run ends; None for no limit.
        self.seconds: float | None = None
        self.limits = limits
        self._robot = robot
        self._printed = 0
        self._last_check = self._last_usage = 0.0
        self._called = True
        self._calls = 0
        self._silence = Silence()
        #: The processor time of this thread at the last check, and what of it the log has taken.
        self._worked = self._logging = 0.0
        self._began = monotonic()

    def note_time(self) -> None:
        """Record that the program waited, and time passed."""
        self._calls = 0
        self._called = True

    def note_call(self) -> None:
        """Record that the program made a call, in which no time passes."""
        self._calls += 1
        if self._calls <= MOST_CALLS_AT_ONE_TIME:
            self._called = True

    def note_output(self) -> None:
        """Record that the program printed; how much is limited."""
        self._called = True

    def note_log(self, seconds: float) -> None:
        """Record that this thread has spent so much processor time on the program's log."""
        self._logging += seconds

    def allows_log(self, activity: Callable[[], Activity | None]) -> bool:
        """Whether the program's log takes no longer to keep than the program itself takes.

        Args:
            activity: says what the program has done.
        """
        if self._logging <= self.limits.silence:
            return True
        done = activity()
        own = monotonic() - self._began if done is None else done.processor
        return self._logging <= self.limits.silence + own

    @property
    def no_call(self) -> Ending:
        """How a run ends whose program makes no call."""
        return Ending(How.NO_CALL, Phrase("run-no-call", seconds=self.limits.silence))

    @property
    def is_due(self) -> bool:
        """Whether the last check is more than a period ago."""
        return monotonic() - self._last_check > PERIOD

    def check(self, activity: Callable[[], Activity | None]) -> Ending | None:
        """Check silence, link and time; return how the run has to end, or None.

        Args:
            activity: says what the program has done.

        Raises:
            RobotConnectionError: the link to a real robot is gone.
        """
        before, self._last_check = self._last_check, monotonic()
        worked, self._worked = self._worked, thread_time()
        if self._robot.client is not None and self._robot.world.simulation is None:
            # A real robot does not wait for its program, so long silence is not an error there.
            self._robot.check_link()
            if self._robot.client.game.play.result:
                return Ending.of_game()
            return self._check_time(self._robot.client.clock.time())
        if self._called:
            self._called = False
            self._silence.begin(activity())
        else:
            handling = self._worked - worked
            self._silence.look(self._last_check - before, activity(), handling)
        return self._check_silence()

    def check_output(self, characters: int) -> Ending | None:
        """Count printed characters; return how the run has to end if there are too many."""
        self._printed += max(1, characters)
        if self._printed <= self.limits.output:
            return None
        return Ending(
            How.OUTPUT_LIMIT,
            Phrase("run-too-much-output", megabytes=self.limits.output / MEGABYTE),
        )

    def check_usage(self, measure: Callable[[Limits], Usage]) -> Ending | None:
        """Check the resources that the program uses; return how the run ends if it uses too many.

        Args:
            measure: returns the resources it uses; not called at every check.
        """
        if monotonic() - self._last_usage < USAGE_PERIOD:
            return None
        self._last_usage = monotonic()
        used, limits = measure(self.limits), self.limits
        if used.disk > limits.disk:
            megabytes = limits.disk / MEGABYTE
            return Ending(How.KILLED, Phrase("run-too-much-disk", megabytes=megabytes))
        if used.files > limits.files:
            return Ending(How.KILLED, Phrase("run-too-many-files", limit=limits.files))
        if used.threads > limits.threads:
            return Ending(How.KILLED, Phrase("run-too-many-threads", limit=limits.threads))
        return None

    def _check_silence(self) -> Ending | None:
        limits, ready = self.limits, self._robot.client is not None
        if self._silence.waiting > limits.blocked:
            return Ending(How.NO_CALL, Phrase("run-blocked", seconds=limits.blocked))
        if ready and self._silence.computing > limits.silence:
            return self.no_call
        if not ready and self._silence.computing > limits.preparation:
            return Ending(How.NO_CALL, Phrase("run-no-robot", seconds=limits.preparation))
        return None

    def _check_time(self, time: float) -> Ending | None:
        if self.seconds is None or time < self.seconds:
            return None
        return Ending.time_is_up(self.seconds)
