"""Robots of the embedded simulator: the twins, which run wherever LearnBlock is installed."""

import inspect
import math
import os
import random
import threading
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cached_property, partial
from pathlib import Path
from typing import Any, ClassVar, Self

from learnblock.client import Client, Goal, Outcome, Witness
from learnblock.clock import Clock
from learnblock.devices import (
    MP3,
    Accelerometer,
    Animator,
    Base,
    Bumper,
    Camera,
    Device,
    Display,
    DistanceSensors,
    GroundSensors,
    Gyroscope,
    Infrared,
    JointMotor,
    Led,
    LightSensor,
    Matrix,
    Pose,
    RGBLed,
    Speaker,
)
from learnblock.errors import DeviceValueError, LearnBlockError, UnknownNameError
from learnblock.home import home
from learnblock.runtime.lockstep import LockStepClock
from learnblock.runtime.pacing import Pacing
from learnblock.runtime.standalone import trace_main_program
from learnblock.runtime.trace import Recorder
from learnblock.runtime.usertime import use_robot_time
from learnblock.simulator import (
    GoalState,
    RobotBody,
    RobotDescription,
    World,
    WorldDescription,
    WorldEvent,
    load_robot,
    load_world,
    world_names,
)

#: Steps between two entries of a robot's path: 0.1 s.
STEPS_PER_POSE = 10


class Simulation:
    """A world with its pace, and those who are told what happens in it.

    Args:
        world: the world.
        pacing: how fast it runs; free by default.
    """

    def __init__(self, world: World, pacing: Pacing | None = None) -> None:
        self.world = world
        self.pacing = pacing or Pacing()
        self.dt = world.dt
        self.seed = world.seed
        #: Held while the world changes: who looks at it from another thread takes it as well.
        self.lock = threading.RLock()
        #: Are told where a robot is, by its name, and of the world's goals.
        self.witnesses: dict[str, Witness] = {}
        self._placed: list[tuple[str, float, Pose]] = []

    @property
    def steps(self) -> int:
        """The steps made so far."""
        return self.world.steps

    def time(self) -> float:
        """Seconds the world has existed."""
        return self.world.time

    def advance(self, step: int) -> None:
        """Make steps, no faster than the pace allows, until `steps` is `step`."""
        while self.world.steps < step:
            self.pacing.wait(self.world.time)
            with self.lock:
                self.world.step()
                self._report()

    def place(self, name: str, x: float, y: float, heading: float) -> None:
        """Lift a robot and set it down elsewhere (mm, mm, degrees); from any thread.

        Raises:
            ValueError: one of them is no finite number.
        """
        with self.lock:
            self.world.robots[name].place(x, y, heading)
            # Told with the next step: a trace is written by one thread alone.
            self._placed.append((name, self.world.time, (x, y, heading)))

    def _report(self) -> None:
        for name, time, pose in self._placed:
            if name in self.witnesses:
                self.witnesses[name].placed(time, pose)
        self._placed.clear()
        for event in self.world.take_events():
            self._report_goal(event)
        if self.world.steps % STEPS_PER_POSE == 0:
            for name, witness in self.witnesses.items():
                witness.pose(self.world.time, self.world.robots[name].pose)

    def _report_goal(self, event: WorldEvent) -> None:
        kind, _, state = event.kind.partition("-")
        if kind != "goal":
            return
        for name, witness in self.witnesses.items():
            # A goal that was missed was missed by all.
            if event.other in ("", name):
                witness.goal(event.time, event.subject, state)


class WorldClock:
    """The time of a robot whose program waits elsewhere: it is only looked at."""

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
        """Whoever advances the world charges for it."""


class SimulatedRobot(Client):
    """A robot of the embedded simulator.

    A program that is run by itself, as ``python square.py``, gets a world of its own, which
    advances while the program waits (``LEARNBLOCK_TRACE`` names a file for its trace):

        from learnblock.robots.sim_ebo import Robot

        robot = Robot(world="line")
        robot.move_straight()
        robot.sleep(2)

    Args:
        world: a world's name or the path of its file; the environment's ``LEARNBLOCK_WORLD``, or
            else the robot's own default.
        seed: of all noise; ``LEARNBLOCK_SEED`` or else 0.
        pace: ``"free"``, ``"real"`` or a factor of real time; ``LEARNBLOCK_PACE`` or else free.
        start: (x mm, y mm, heading in degrees) where it is put; by default a start pose of the
            world.
        simulation: the world of a host that advances it itself.
        name: the robot's among those of the world.

    Raises:
        UnknownNameError: there is no such world.
        WorldError: the world's file is wrong.
        DeviceValueError: the seed or pace is no such thing.
    """

    lockstep = True
    #: The name of the robot's description.
    description_name: ClassVar[str]

    def __init__(
        self,
        *,
        world: str | None = None,
        seed: int | None = None,
        pace: str | float | None = None,
        start: Pose | None = None,
        simulation: Simulation | None = None,
        name: str = "robot",
    ) -> None:
        self.name = name
        self.start = _start(start)
        self._restore_time: Callable[[], None] | None = None
        self._end_trace: Callable[[], None] | None = None
        self.simulation = simulation or self.make_simulation(world=world, seed=seed, pace=pace)
        clock: Clock = WorldClock(self.simulation) if simulation else self._own_clock()
        super().__init__(clock=clock)
        if simulation is None:
            self._hold_the_program()

    @classmethod
    def description(cls) -> RobotDescription:
        """What kind of robot it is: a file beside its module says so, or one of ours."""
        return load_robot(cls.description_name, folders=(Path(inspect.getfile(cls)).parent,))

    @classmethod
    def device_names(cls) -> frozenset[str]:
        return cls.description().devices()

    @classmethod
    def make_simulation(
        cls,
        *,
        world: str | None = None,
        seed: int | None = None,
        pace: str | float | None = None,
    ) -> Simulation:
        """The world a robot of this kind gets, from arguments, environment or defaults."""
        chosen = world or os.environ.get("LEARNBLOCK_WORLD") or cls.description().world
        description = find_world(chosen)
        return Simulation(World(description, seed=_seed(seed)), Pacing(_factor(pace)))

    @cached_property
    def body(self) -> RobotBody:
        """The robot in its world."""
        world = self.simulation.world
        return world.add_robot(self.description(), name=self.name, start=self.start)

    @classmethod
    def check_wishes(cls, wishes: Mapping[str, Any]) -> None:
        cls._prepared(wishes)

    @classmethod
    def hosted(cls, arguments: Mapping[str, Any], wishes: Mapping[str, Any]) -> Self:
        simulation, start = cls._prepared({**arguments, **wishes})
        return cls(simulation=simulation, start=start)

    @classmethod
    def _prepared(cls, wishes: Mapping[str, Any]) -> tuple[Simulation, Pose | None]:
        others = {name: wish for name, wish in wishes.items() if name != "start"}
        return cls.make_simulation(**others), _start(wishes.get("start"))

    def conditions(self) -> dict[str, object]:
        world = self.simulation.world
        named = {"world": world.description.name, "seed": world.seed}
        # Only where it was chosen: else the world says where it is.
        start = {} if self.start is None else {"start": list(self.start)}
        return {**super().conditions(), **named, **start}

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
        for name in sorted(self.body.description.devices()):
            kind, _, key = name.partition(":")
            self.add(_DEVICES[kind](self.body, key), key)

    def disconnect(self) -> None:
        if self._restore_time:
            self._restore_time()
        if self._end_trace:
            self._end_trace()

    def _own_clock(self) -> LockStepClock:
        simulation = self.simulation

        def wait(steps: int) -> int:
            simulation.advance(simulation.steps + steps)
            return simulation.steps

        return LockStepClock(wait, simulation.steps, simulation.dt)

    def _hold_the_program(self) -> None:
        """The program's own randomness and time follow the world, so that it can be repeated."""
        random.seed(self.simulation.seed)
        self._restore_time = use_robot_time(self.clock)
        if os.environ.get("LEARNBLOCK_TRACE"):
            self._end_trace = trace_main_program(self, Path(os.environ["LEARNBLOCK_TRACE"]))


def find_world(name_or_path: str) -> WorldDescription:
    """A world of the user's own folder, of ours, or of a plugin, or one by its path.

    Raises:
        UnknownNameError: there is no such world.
        WorldError: its file is wrong.
    """
    try:
        return load_world(name_or_path, folders=(own_worlds(),))
    except UnknownNameError:
        # Plugins last: to know them one has to search all that is installed.
        return load_world(name_or_path, folders=(own_worlds(), *_plugin_worlds()))


def worlds() -> Iterator[WorldDescription]:
    """Every world there is: ours, the user's own and those of plugins."""
    for name in known_worlds():
        yield find_world(name)


def known_worlds() -> tuple[str, ...]:
    """The names of every world there is."""
    return world_names(folders=(own_worlds(), *_plugin_worlds()))


def own_worlds() -> Path:
    """The folder of the user's own worlds, which need not be there."""
    return home() / "worlds"


def _plugin_worlds() -> Iterator[Path]:
    """The folders of the packages that entry points of the group ``learnblock.worlds`` name."""
    from importlib.metadata import entry_points  # noqa: PLC0415 - see `find_world`
    from importlib.util import find_spec  # noqa: PLC0415

    for point in entry_points(group="learnblock.worlds"):
        found = find_spec(point.module)
        if found and found.submodule_search_locations:
            yield Path(found.submodule_search_locations[0])


def draw(robot: Client, recorder: Recorder, path: Path, title: str) -> None:
    """Draw a run on a simulated robot, as .png or .svg.

    Raises:
        LearnBlockError: the robot is no simulated one.
    """
    if not isinstance(robot, SimulatedRobot):
        raise LearnBlockError("only a run on a simulated robot can be drawn")
    from learnblock.simulator.picture import Scene, draw_png, draw_svg  # noqa: PLC0415 - if asked

    scene = Scene(
        world=robot.simulation.world.description,
        body=robot.body.description.body,
        path=tuple((time, *pose) for time, pose in recorder.path),
        marks=tuple(
            (mark.time, mark.kind, mark.text, mark.pose[0], mark.pose[1])
            for mark in recorder.marks
            if mark.pose
        ),
        title=title,
    )
    drawn = draw_svg(scene).encode() if path.suffix == ".svg" else draw_png(scene)
    path.write_bytes(drawn)


def pace_factor(pace: str | float) -> float | None:
    """``free`` as None, ``real`` as 1, a positive number as itself.

    Raises:
        DeviceValueError: it is none of these.
    """
    if pace == "free":
        return None
    if pace == "real":
        return 1.0
    try:
        factor = float(pace)
    except ValueError:
        factor = 0.0
    if not 0 < factor < float("inf"):
        raise DeviceValueError(
            f"`pace` must be free, real or a positive factor of real time such as 5, not {pace!r}"
        )
    return factor


def goal_of(goal: GoalState) -> Goal:
    """A goal of a world as reports tell it."""
    if goal.reached_at is not None:
        return Goal(goal.name, goal.kind, "reached", goal.reached_at)
    return Goal(
        goal.name, goal.kind, "open" if goal.failed_at is None else "failed", goal.failed_at
    )


def _factor(pace: str | float | None) -> float | None:
    return pace_factor(os.environ.get("LEARNBLOCK_PACE") or "free" if pace is None else pace)


def _seed(seed: int | None) -> int:
    chosen = os.environ.get("LEARNBLOCK_SEED") or 0 if seed is None else seed
    try:
        return int(chosen)
    except ValueError:
        raise DeviceValueError(f"`seed` must be a whole number, not {chosen!r}") from None


def _start(start: Sequence[float] | None) -> Pose | None:
    if start is None:
        return None
    try:
        x, y, heading = (float(value) for value in start)
    except (TypeError, ValueError):
        raise DeviceValueError(f"`start` must be (x, y, heading), not {start!r}") from None
    if not all(map(math.isfinite, (x, y, heading))):
        raise DeviceValueError(f"`start` must be three finite numbers, not {start!r}")
    return x, y, heading


# One function for each type of device: what it is built from in the simulator.


def _base(body: RobotBody, _key: str) -> Base:
    return Base(move=body.drive, read=lambda: body.pose)


def _logged(body: RobotBody, device: str, action: str) -> Callable[..., None]:
    return partial(body.note, device, action)


def _speaker(body: RobotBody, _key: str) -> Speaker:
    note = partial(_logged, body, "Speaker")
    return Speaker(say=note("say"), play=note("play"), tone=note("tone"))


def _matrix(body: RobotBody, _key: str) -> Matrix:
    note = partial(_logged, body, "Matrix")
    return Matrix(icon=note("icon"), number=note("number"), text=note("text"))


def _mp3(body: RobotBody, _key: str) -> MP3:
    note = partial(_logged, body, "MP3")
    return MP3(
        select=note("select"),
        action=note("action"),
        volume=note("volume"),
        equalizer=note("equalizer"),
        loop=note("loop"),
    )


def _led(body: RobotBody, key: str) -> Led:
    return Led(set=lambda on: body.set_led(key, (255, 255, 255) if on else (0, 0, 0)))


def _rgb_led(body: RobotBody, key: str) -> RGBLed:
    return RGBLed(set_color=lambda red, green, blue: body.set_led(key, (red, green, blue)))


def _joint(body: RobotBody, key: str) -> JointMotor:
    return JointMotor(move=partial(body.set_joint, key), read=partial(body.joint, key))


_DEVICES: dict[str, Callable[[RobotBody, str], Device]] = {
    "Accelerometer": lambda body, _: Accelerometer(body.acceleration),
    "Animator": lambda body, _: Animator(_logged(body, "Animator", "play")),
    "Base": _base,
    "Bumper": lambda body, _: Bumper(body.bumper),
    "Camera": lambda body, key: Camera(partial(body.frame, key), drawn=True, focal=body.focal(key)),
    "Display": lambda body, _: Display(show_emotion=body.show_emotion),
    "DistanceSensors": lambda body, _: DistanceSensors(body.distances),
    "GroundSensors": lambda body, _: GroundSensors(body.ground),
    "Gyroscope": lambda body, _: Gyroscope(body.gyroscope, body.reset_gyroscope),
    "Infrared": lambda body, _: Infrared(lambda: None, _logged(body, "Infrared", "send")),
    "JointMotor": _joint,
    "Led": _led,
    "LightSensor": lambda body, _: LightSensor(body.light),
    "MP3": _mp3,
    "Matrix": _matrix,
    "RGBLed": _rgb_led,
    "Speaker": _speaker,
}
