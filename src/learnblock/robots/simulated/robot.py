"""Robots of the embedded simulator: the twins, which run wherever LearnBlock is installed."""

import inspect
import os
import random
from collections.abc import Callable, Mapping
from functools import cached_property
from operator import itemgetter
from pathlib import Path
from typing import Any, ClassVar, Literal, Self

from learnblock.client import Client, Goal, Outcome, Witness
from learnblock.client.clock import Clock
from learnblock.client.game import Game
from learnblock.client.readings import Readings
from learnblock.devices import Pose
from learnblock.robots.simulated.devices import WORLD_DEVICES, make_device
from learnblock.robots.simulated.options import (
    chosen_pace,
    chosen_seed,
    chosen_start,
    chosen_variant,
)
from learnblock.robots.simulated.play import WorldPlay
from learnblock.robots.simulated.simulation import Simulation, WorldClock
from learnblock.robots.simulated.way import DrivenWay, draw_way
from learnblock.robots.simulated.worlds import described_world, find_world
from learnblock.runtime.lockstep import LockStepClock
from learnblock.runtime.pacing import Pacing
from learnblock.runtime.standalone import main_program, report_main_program, trace_main_program
from learnblock.runtime.usertime import use_robot_time
from learnblock.simulator import (
    GoalState,
    RobotBody,
    RobotDescription,
    World,
    load_robot,
    make_variant,
)
from learnblock.wheels import Drivetrain


class SimulatedRobot(Client):
    """A robot of the embedded simulator.

    A program without a host, such as ``python square.py``, gets its own world, which
    advances while the program waits (``LEARNBLOCK_TRACE`` names a file for its trace):

        from learnblock.robots.sim_ebo import Robot

        robot = Robot(world="line")
        robot.move_straight()
        robot.sleep(2)

    Args:
        world: a world's name or the path of its file; by default ``LEARNBLOCK_WORLD`` of the
            environment, else the robot's own default.
        seed: the seed of all noise; by default ``LEARNBLOCK_SEED``, else 0.
        pace: ``"free"``, ``"real"`` or a factor of real time; by default ``LEARNBLOCK_PACE``, else
            free.
        variant: the number of the world's variant; by default ``LEARNBLOCK_VARIANT``, else 0, the
            world as it is drawn.
        start: (x mm, y mm, heading in degrees) where it starts; by default a start pose of the
            world.
        simulation: a world that its host advances.
        name: the robot's name in the world.

    Raises:
        UnknownNameError: there is no such world.
        WorldError: the world's file is invalid, or has no such variant.
        DeviceValueError: the seed, the pace or the variant is invalid.
    """

    lockstep = True
    sees_drawn_faces = True
    #: The name of the robot's description.
    description_name: ClassVar[str]

    def __init__(
        self,
        *,
        world: str | None = None,
        seed: int | None = None,
        pace: str | float | None = None,
        variant: int | None = None,
        start: Pose | None = None,
        simulation: Simulation | None = None,
        name: str = "robot",
    ) -> None:
        self.name = name
        self.start = chosen_start(start)
        self._restore_time: Callable[[], None] | None = None
        self._end_trace: Callable[[], None] | None = None
        #: The name of the program that reports what the robot did.
        self._program: str | None = None
        #: What it has driven, where a person enters its commands, as in a notebook.
        self.driven_way = DrivenWay()
        self.simulation = simulation or self.make_simulation(
            world=world, seed=seed, pace=pace, variant=variant
        )
        clock: Clock = WorldClock(self.simulation) if simulation else self._own_clock()
        # A host calls no skills, and attaches those that others may call.
        super().__init__(skills=() if simulation else None, clock=clock)
        self.game = Game(WorldPlay(self.simulation, self.name))
        if simulation is None:
            self._hold_the_program()

    @classmethod
    def description(cls) -> RobotDescription:
        """The description of the robot: a file next to its module, or a built-in one."""
        return load_robot(cls.description_name, folders=(Path(inspect.getfile(cls)).parent,))

    @classmethod
    def device_names(cls) -> frozenset[str]:
        return frozenset((*cls.description().devices(), *WORLD_DEVICES))

    @classmethod
    def abilities(cls) -> frozenset[str]:
        return cls.description().abilities()

    @classmethod
    def drivetrain(cls) -> Drivetrain:
        return cls.description().wheels.drivetrain

    @classmethod
    def make_simulation(
        cls,
        *,
        world: str | None = None,
        seed: int | None = None,
        pace: str | float | None = None,
        variant: int | None = None,
    ) -> Simulation:
        """The world for such a robot, from arguments, environment or defaults."""
        world_name = world or os.environ.get("LEARNBLOCK_WORLD") or cls.description().world
        description = make_variant(find_world(world_name), chosen_variant(variant))
        return Simulation(World(description, seed=chosen_seed(seed)), Pacing(chosen_pace(pace)))

    @cached_property
    def body(self) -> RobotBody:
        """The robot in its world, where its host may have put it."""
        world = self.simulation.world
        return world.robots.get(self.name) or world.add_robot(
            self.description(), name=self.name, start=self.start
        )

    @classmethod
    def check_wishes(cls, wishes: Mapping[str, Any]) -> None:
        cls._prepared(wishes)

    @classmethod
    def prepared(cls, wishes: Mapping[str, Any]) -> World:
        world = cls._prepared(wishes)[0].world
        # A picture of the user's is for contained processes only, and none of them shares it.
        if cls.description().camera and not world.description.floor.picture:
            world.floor.mips.complete()
        return world

    @classmethod
    def hosted(cls, arguments: Mapping[str, Any], wishes: Mapping[str, Any]) -> Self:
        simulation, start = cls._prepared({**arguments, **wishes})
        return cls(simulation=simulation, start=start)

    @classmethod
    def _prepared(cls, wishes: Mapping[str, Any]) -> tuple[Simulation, Pose | None]:
        others = {name: wish for name, wish in wishes.items() if name != "start"}
        return cls.make_simulation(**others), chosen_start(wishes.get("start"))

    def conditions(self) -> dict[str, object]:
        world = self.simulation.world
        world_conditions = {"world": world.description.name, "seed": world.seed}
        if world.description.variant:
            world_conditions["variant"] = world.description.variant
        # Only if it was chosen; otherwise the world decides.
        start = {} if self.start is None else {"start": list(self.start)}
        return {**super().conditions(), **world_conditions, **start}

    def surroundings(self) -> Mapping[str, object]:
        world = self.simulation.world.description
        return {"world": described_world(world)}

    def where(self) -> Pose:
        return self.body.pose

    def observe(self, witness: Witness) -> None:
        self.simulation.witnesses[self.name] = witness
        witness.pose(self.simulation.time(), self.where())

    def outcome(self) -> Outcome:
        x, y, heading = self.where()
        return Outcome(
            pose=(round(x, 3), round(y, 3), round(heading, 3)),
            distance=round(self.body.distance_driven, 3),
            goals=tuple(map(goal_of, self.simulation.world.goals)),
        )

    def connect(self) -> None:
        devices = (*self.body.description.devices(), *WORLD_DEVICES)
        names = (name.partition(":") for name in devices)
        # The first device of a type, which skills use by default, is the first of the file.
        for kind, _, key in sorted(names, key=itemgetter(0)):
            self.add(make_device(self.body, kind, key), key)

    def disconnect(self) -> None:
        if self.name in self.simulation.world.robots:
            self.simulation.finish(self.name)
        self.leave_time()
        if self._program:
            report_main_program(self, self._program, self.simulation.time())
        if self._end_trace:
            self._end_trace()

    def take_time(self) -> None:
        """Let the program's `time` be that of its world from now on."""
        if self._restore_time is None:
            self._restore_time = use_robot_time(self.clock)

    def leave_time(self) -> None:
        """Let the program's `time` be as without the robot, as between the cells of a notebook."""
        if self._restore_time is not None:
            self._restore_time()
            self._restore_time = None

    def _repr_mimebundle_(self, **options: object) -> Mapping[str, str]:  # noqa: ARG002 - for all
        """What notebooks show of it: its world with the way that it has driven."""
        return {"text/plain": repr(self), "image/svg+xml": self.drawn_way()}

    def drawn_way(self, since: float = 0.0) -> str:
        """Its world with the way that it has driven, as SVG.

        Args:
            since: the time in s at which the way begins.
        """
        world, body = self.simulation.world, self.body.description
        return draw_way(
            f"{body.title}: {world.description.name}",
            body.body,
            world.description,
            (*self.driven_way.since(since), (world.time, *self.where())),
            tuple(stroke for stroke in world.drawing.strokes if stroke.robot == self.name),
        )

    def _make_readings(self) -> Readings:
        if isinstance(self.clock, WorldClock):
            # The program has a robot of its own, elsewhere, which waits for new readings.
            return Readings(self.clock)
        return super()._make_readings()

    def _own_clock(self) -> LockStepClock:
        simulation = self.simulation

        def wait(steps: int) -> int:
            simulation.advance(simulation.steps + steps)
            if simulation.is_over:
                raise SystemExit
            return simulation.steps

        return LockStepClock(wait, simulation.steps, simulation.dt)

    def _hold_the_program(self) -> None:
        """Tie the program's random numbers and time to the world, so that runs are reproducible."""
        random.seed(self.simulation.seed)
        self.take_time()
        self._program = main_program()
        if self._program is None and self.name not in self.simulation.witnesses:
            self.observe(self.driven_way)
        if os.environ.get("LEARNBLOCK_TRACE"):
            self._end_trace = trace_main_program(self, Path(os.environ["LEARNBLOCK_TRACE"]))


def goal_of(goal: GoalState) -> Goal:
    """A goal of a world as it appears in reports."""
    if goal.reached_at is not None:
        return Goal(goal.name, goal.kind, "reached", goal.reached_at, goal.team)
    state: Literal["open", "failed"] = "open" if goal.failed_at is None else "failed"
    return Goal(goal.name, goal.kind, state, goal.failed_at, goal.team)
