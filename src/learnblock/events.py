"""Event-driven programs: `when`, its state and time, and the cycle that runs them."""

from collections.abc import Callable
from contextlib import AbstractContextManager, nullcontext

from learnblock.clock import Clock

Condition = Callable[[], object]
Body = Callable[[], object]


class When:
    """A piece of a program that runs in every cycle in which it is active.

    With a condition, which decides its state at the start of each cycle, or without one, when only
    `activate` and `deactivate` do:

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
        # `@robot.when` gives us the body. `@robot.when(condition)` gives us the condition, and only
        # being called with the body then tells us so.
        self._body: Body = function
        self._condition: Condition | None = None
        self._since: float | None = None
        self._activations = 0
        self._first_pass = True

    def __call__(self, body: Body) -> "When":
        """Complete ``@robot.when(condition)``: what was given first was the condition."""
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
        """Seconds since activation; 0 throughout the first pass, and while not active."""
        if self._since is None or self._first_pass:
            return 0.0
        # Rounded as a clock's own time is, so that 0.03 - 0.01 is 0.02.
        return round(self._clock.time() - self._since, 9)

    def activate(self) -> None:
        """Make it active; nothing changes if it already is."""
        if self._since is None:
            self._since = self._clock.time()
            self._activations += 1
            self._first_pass = True

    def deactivate(self) -> None:
        """Make it inactive; a body that is running goes on to its end."""
        self._since = None

    def evaluate(self) -> None:
        """Let the condition, if there is one, decide the state."""
        if self._condition is None:
            return
        if self._condition():
            self.activate()
        else:
            self.deactivate()

    def run(self) -> None:
        """Run the body to its end if active."""
        if self._since is None:
            return
        activation = self._activations
        self._body()
        # A body may deactivate and activate itself: then its next pass is a first one again.
        if self._activations == activation:
            self._first_pass = False

    def __repr__(self) -> str:
        return f"<when {self.name}: {'active' if self.active else 'inactive'}>"


class Events:
    """The event-driven half of a robot: it collects the `when`s and cycles through them.

    One cycle: all conditions are evaluated in source order on one snapshot of the sensors; then
    every active `when` runs its body to the end, in source order. A cycle takes at least `period`.
    """

    #: The least time of one cycle, in seconds of the robot's time.
    period = 0.02
    clock: Clock

    def __init__(self) -> None:
        self._whens: list[When] = []
        self._start: When | None = None

    @property
    def stopped(self) -> bool:
        """Whether the robot has been stopped, which ends the cycle."""
        return False

    def when_states(self) -> dict[str, tuple[bool, float]]:
        """Of each `when`, by name, whether it is active and since how many seconds."""
        return {when.name: (when.active, when.time) for when in self._whens}

    def when(self, function: Body | Condition) -> When:
        """Decorate a function that runs in every cycle while active: ``@robot.when(condition)``.

        A bare ``@robot.when`` has no condition: only `When.activate` and `When.deactivate` change
        its state.
        """
        when = When(self.clock, function)
        self._whens.append(when)
        return when

    def when_start(self, body: Body) -> When:
        """Decorate the function that runs once, before the first cycle."""
        self._start = When(self.clock, body)
        return self._start

    def run(self) -> None:
        """Cycle through the `when`s until the robot is stopped."""
        if self._start:
            self._start.activate()
            self._start.run()
            self._start.deactivate()
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
            when.run()
        if self.stopped:
            return
        # Sums of times carry rounding errors; a cycle is over when it has taken its period.
        remaining = self.period - (self.clock.time() - began)
        if remaining > 1e-9:
            self.clock.sleep(remaining)

    def _snapshot(self) -> AbstractContextManager[None]:
        """Within it, all questions to sensors are answered from the same readings."""
        return nullcontext()
