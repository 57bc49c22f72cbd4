"""Event-driven programs: `when`, its state and time, and the cycle that runs them."""

from collections.abc import Callable
from contextlib import AbstractContextManager, nullcontext

from learnblock.client.clock import Clock

Condition = Callable[[], object]
Body = Callable[[], object]


class When:
    """A block of code that runs in every cycle while it is active.

    A condition, if given, decides at the start of each cycle whether it is active; without one,
    only `activate` and `deactivate` change that:

        @robot.when(lambda: robot.is_front_obstacle())
        def avoid():
            robot.turn_right()

        @robot.when
        def celebrate():
            robot.expressJoy()
            celebrate.deactivate()
    """

    def __init__(self, clock: Clock, function: Body | Condition) -> None:
        self._clock = clock
        # `@robot.when` passes the body. `@robot.when(condition)` passes the condition, which only
        # becomes clear when the result is called with the body.
        self._body: Body = function
        self._condition: Condition | None = None
        self._since: float | None = None

    def __call__(self, body: Body) -> "When":
        """Complete ``@robot.when(condition)`` with the body."""
        self._condition, self._body = self._body, body
        return self

    @property
    def name(self) -> str:
        return self._body.__name__

    @property
    def active(self) -> bool:
        """Whether the body runs in this cycle."""
        return self._since is not None

    @property
    def time(self) -> float:
        """Seconds since activation; 0 while inactive."""
        # A loop that only waits for it must let time pass.
        self._clock.charge()
        return self._elapsed()

    @property
    def state(self) -> tuple[bool, float]:
        """Whether it is active and its time; looking at it takes no time."""
        return self.active, self._elapsed()

    def activate(self) -> None:
        """Make it active, unless it already is."""
        if self._since is None:
            self._since = self._clock.time()

    def deactivate(self) -> None:
        """Make it inactive; a running body still runs to its end."""
        self._since = None

    def evaluate(self) -> None:
        """Update the state from the condition, if there is one."""
        if self._condition is None:
            return
        if self._condition():
            self.activate()
        else:
            self.deactivate()

    def run(self) -> None:
        """Run the body to its end if active."""
        if self._since is not None:
            self._body()

    def _elapsed(self) -> float:
        if self._since is None:
            return 0.0
        # Rounded like the clock's time, so that 0.03 - 0.01 is 0.02.
        return round(self._clock.time() - self._since, 9)

    def __repr__(self) -> str:
        return f"<when {self.name}: {'active' if self.active else 'inactive'}>"


class Events:
    """The event-driven part of a robot, which collects the `when`s and runs them in cycles.

    In each cycle, all conditions are evaluated in source order on one snapshot of the sensors; then
    every active `when` runs its body to the end, in source order. A cycle takes at least `period`.
    """

    #: The shortest duration of a cycle, in seconds of the robot's time.
    period = 0.02
    clock: Clock

    def __init__(self) -> None:
        self._whens: list[When] = []
        self._starts: list[When] = []

    @property
    def stopped(self) -> bool:
        """Whether the robot has been stopped, which ends the cycles."""
        return False

    def when_states(self) -> dict[str, tuple[bool, float]]:
        """Whether each `when` is active and for how many seconds, by name."""
        return {when.name: when.state for when in self._whens}

    def when(self, function: Body | Condition) -> When:
        """Decorate a function that runs in every cycle while it is active.

        ``@robot.when(condition)`` makes it active while the condition is true. After a bare
        ``@robot.when`` only `When.activate` and `When.deactivate` change its state.
        """
        when = When(self.clock, function)
        self._whens.append(when)
        return when

    def when_start(self, body: Body) -> When:
        """Decorate a function that runs once, before the first cycle; several run in order."""
        start = When(self.clock, body)
        self._starts.append(start)
        return start

    def wait_until(self, condition: Condition) -> None:
        """Wait until a condition is true; meanwhile the robot keeps moving.

            robot.wait_until(lambda: robot.is_front_obstacle())

        The condition is evaluated at once, and then every `period`.
        """
        while not condition():
            self.clock.sleep(self.period)

    def run(self) -> None:
        """Run cycles until the robot is stopped."""
        for start in self._starts:
            start.activate()
            start.run()
            start.deactivate()
        while self._whens and not self.stopped:
            self._cycle()

    def _cycle(self) -> None:
        began = self.clock.time()
        with self._snapshot():
            for when in self._whens:
                when.evaluate()
        for when in self._whens:
            if self.stopped:
                return
            self._begin_pass()
            when.run()
        if self.stopped:
            return
        # Rounding errors in sums of times must not cause another sleep.
        remaining = self.period - (self.clock.time() - began)
        if remaining > 1e-9:
            self.clock.sleep(remaining)

    def _snapshot(self) -> AbstractContextManager[None]:
        """Answer all sensor queries from the same readings while the context is open."""
        return nullcontext()

    def _begin_pass(self) -> None:
        """Prepare for a pass of a body, which may repeat earlier questions without waiting."""
