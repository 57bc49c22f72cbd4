"""A world that advances at a pace and reports what happens in it."""

import threading

from learnblock.client import Witness
from learnblock.runtime.pacing import Pacing
from learnblock.simulator import World, WorldEvent

#: Steps between two entries of a robot's path: 0.1 s.
STEPS_PER_POSE = 10
#: Decimals of a pose at which a hand puts a robot down: those of the trace, so that the world can
#: be run again exactly.
_DECIMALS = 3


class Simulation:
    """A world with its pace, and the receivers of its events.

    Args:
        world: the world.
        pacing: how fast it runs; free by default.
    """

    def __init__(self, world: World, pacing: Pacing | None = None) -> None:
        self.world = world
        self.pacing = pacing or Pacing()
        self.dt = world.dt
        self.seed = world.seed
        #: Held while the world changes; other threads take it to read the world.
        self.lock = threading.RLock()
        #: Receive the poses of a robot, by its name, and the world's goals.
        self.witnesses: dict[str, Witness] = {}

    @property
    def steps(self) -> int:
        """The number of steps so far."""
        return self.world.steps

    def time(self) -> float:
        """The world's time in seconds."""
        return self.world.time

    @property
    def is_over(self) -> bool:
        """Whether the world's game has ended."""
        return self.world.game.is_over

    def advance(self, step: int, given_up: threading.Event | None = None) -> None:
        """Advance, no faster than the pace allows, until `steps` is `step` or the game ends.

        Args:
            step: the number of steps.
            given_up: ends this early, see `Pacing.wait`.
        """
        world, game, pacing, lock = self.world, self.world.game, self.pacing, self.lock
        while world.steps < step and not game.is_over:
            if not pacing.is_free:
                pacing.wait(world.time, given_up)
            if given_up and given_up.is_set():
                return
            with lock:
                world.step()
                self._report()

    def place(self, name: str, x: float, y: float, heading: float) -> None:
        """Lift a robot and set it down elsewhere (mm, mm, degrees); may be called from any thread.

        Raises:
            ValueError: one of them is not a finite number.
        """
        pose = round(x, _DECIMALS), round(y, _DECIMALS), round(heading, _DECIMALS)
        with self.lock:
            self.world.robots[name].place(*pose)
            # At once: the trace has it in its place among the commands of this moment.
            if name in self.witnesses:
                self.witnesses[name].placed(self.world.time, pose)

    def handle(self, name: str, how: str) -> None:
        """Shake or tilt a robot; may be called from any thread.

        Args:
            name: the robot.
            how: see `RobotBody.handle`.
        """
        with self.lock:
            self.world.robots[name].hand.move(how)
            if name in self.witnesses:
                self.witnesses[name].handled(self.world.time, how)

    def finish(self, name: str) -> None:
        """Note that a robot's program has ended, so that it stays where it is."""
        with self.lock:
            self.world.finish(name)
            self._report_goals()
            self._report_drawing()

    def _report(self) -> None:
        world = self.world
        if world.game.has_events:
            self.report_game()
        if world.has_events:
            self._report_goals()
        if world.drawing.ended or world.drawing.unable:
            self._report_drawing()
        if world.steps % STEPS_PER_POSE == 0:
            for name, witness in self.witnesses.items():
                witness.pose(self.world.time, self.world.robots[name].pose)

    def _report_goals(self) -> None:
        for event in self.world.take_events():
            if event.kind == "collision":
                self._report_collision(event)
            else:
                self._report_goal(event)

    def report_game(self) -> None:
        """Report what has happened in the game: to one player, or to all of them."""
        for event in self.world.game.take_events():
            for name, witness in self.witnesses.items():
                if event.player in ("", name):
                    witness.game(event)

    def _report_drawing(self) -> None:
        drawing, time = self.world.drawing, self.world.time
        for stroke in drawing.ended:
            if stroke.robot in self.witnesses:
                self.witnesses[stroke.robot].stroke(
                    time, stroke.points, stroke.colour, stroke.width
                )
        for name in drawing.unable:
            if name in self.witnesses:
                self.witnesses[name].drawing_full(time)
        drawing.ended.clear()
        drawing.unable.clear()

    def _report_collision(self, event: WorldEvent) -> None:
        for robot, thing in ((event.subject, event.other), (event.other, event.subject)):
            if robot in self.witnesses:
                self.witnesses[robot].collision(event.time, thing)

    def _report_goal(self, event: WorldEvent) -> None:
        _, _, state = event.kind.partition("-")
        for name, witness in self.witnesses.items():
            # A missed goal was missed by all robots.
            if event.other in ("", name):
                witness.goal(event.time, event.subject, state)


class WorldClock:
    """The clock of a robot whose program waits elsewhere; it can only be read."""

    def __init__(self, simulation: Simulation) -> None:
        self._simulation = simulation

    @property
    def instant(self) -> int:
        return self._simulation.steps

    def time(self) -> float:
        return self._simulation.time()

    def sleep(self, seconds: float) -> None:
        raise NotImplementedError(f"a robot that others advance cannot sleep {seconds} s")

    def charge(self) -> None:
        """Do nothing: the host that advances the world adds this time."""
