"""What a run was like at chosen moments, as it was then: nothing here reads the run's log."""

import hashlib
import random
from collections.abc import Callable, Collection, Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from types import FrameType
from typing import Any
from unittest.mock import patch

import msgspec

from learnblock import robots, running
from learnblock.client import Client
from learnblock.monitor.world_monitor import WorldMonitor
from learnblock.robots.simulated import SimulatedRobot
from learnblock.running import Options, ProgramRun, Report
from learnblock.runtime.child import _Program
from learnblock.runtime.inline import InlineWorker
from learnblock.runtime.log.keeping import RunLog
from learnblock.runtime.log.noting import TICK
from learnblock.runtime.log.snapshots import snapshot
from learnblock.runtime.watcher import Watcher
from learnblock.simulator import World
from learnblock.simulator.hand import TILTS
from learnblock.why import EventHistory, Recorded
from learnblock.why.moments import Moments, shown
from learnblock.why.world_again import WorldAgain
from random_programs import random_program

#: How often a hand places or tilts the robot in a run that hands disturb.
HANDS = 4
#: The times of a run that are not looked at in order, so that the world begins anew.
JUMPS = 3


@dataclass(frozen=True)
class Truth:
    """A run at one moment.

    Args:
        world: poses, sensors, joints, lights, goals and drawings, as JSON.
        pictures: a hash of each camera's picture.
        program: its line, its functions, its variables, its `when`s and what it has printed.
    """

    world: bytes
    pictures: tuple[str, ...]
    program: dict[str, Any]


@dataclass(frozen=True)
class Job:
    """A run that can be repeated.

    Args:
        path: the program's file.
        robot: the twin.
        options: of the run.
        hands: the seed of what hands do to the robot; None for no hands.
    """

    path: Path
    robot: str
    options: Options
    hands: int | None = None


@dataclass(frozen=True)
class Remembered:
    """A run, what it was like, and its log.

    Args:
        report: its report.
        truths: by step of the world.
        log: the log.
    """

    report: Report
    truths: dict[int, Truth]
    log: RunLog


def remembered(job: Job, moments: int, seed: int, watcher: Callable[[], Watcher]) -> Remembered:
    """Run a program, and remember what it was like at random moments.

    Args:
        job: the run.
        moments: their number.
        seed: chooses them.
        watcher: makes who answers its questions and presses its keys.
    """
    plain = _Run(job, watcher()).run(())
    last = round(plain.report.time / TICK)
    rng = random.Random(seed)  # noqa: S311 - not a secret
    steps = rng.sample(range(last), min(moments, last))
    with_log = _Run(job, watcher(), log=True).run(steps)
    # Endless recursion ends some calls earlier with a log.
    if "RecursionError" not in str(plain.report.error):
        assert with_log.report.trace_sha256 == plain.report.trace_sha256, "the log changed the run"
    return with_log


def differences(run: Remembered, seed: int = 0) -> list[str]:
    """Where the log of a run shows something else than was; an empty list if nowhere."""
    recorded = Recorded.of(run.log.blocks)
    moments, world = Moments(EventHistory(recorded)), WorldAgain(recorded)
    while world.prepare():
        pass
    lines = []
    for step in _order([*run.truths], seed):
        truth = run.truths[step]
        robot = world.seek(step * TICK)
        again = Truth(_world(robot), _pictures(robot), _told(moments, step * TICK))
        lines += [f"step {step}: {difference}" for difference in _unlike(truth, again)]
    return lines


def _order(steps: list[int], seed: int) -> list[int]:
    """The steps in order, but for some."""
    steps = sorted(steps)
    rng = random.Random(seed)  # noqa: S311 - not a secret
    jumps = rng.sample(steps, min(JUMPS, len(steps)))
    return [*steps, *jumps]


def _unlike(truth: Truth, again: Truth) -> Iterator[str]:
    if truth.world != again.world:
        yield _first_difference(truth.world, again.world)
    if truth.pictures != again.pictures:
        yield "another picture"
    for name, was in truth.program.items():
        answer = again.program[name]
        if was != answer:
            yield f"{name}: was {_only(was, answer)}, told {_only(answer, was)}"


def _only(one: Any, other: Any) -> Any:
    """What is in one dictionary and not the same in the other."""
    if isinstance(one, dict) and isinstance(other, dict):
        return {name: value for name, value in one.items() if other.get(name) != value}
    return one


def _first_difference(was: bytes, answer: bytes) -> str:
    same = next((i for i, (a, b) in enumerate(zip(was, answer, strict=False)) if a != b), len(was))
    first = max(0, same - 60)
    return f"world: was {was[first : same + 30]!r}, told {answer[first : same + 30]!r}"


class _Seen(Watcher):
    """What the page would have shown of a program; a person answers its questions."""

    def __init__(self, person: Watcher) -> None:
        self.last_line = self.characters = 0
        self.held_keys, self.input = person.held_keys, person.input  # type: ignore[method-assign]
        self._heard = person.printed

    def line(self, number: int) -> None:
        self.last_line = number

    def printed(self, text: str) -> None:
        self.characters += len(text)
        self._heard(text)


class _Run:
    """One run of a job, looked at from outside whenever its world is about to move."""

    def __init__(self, job: Job, watcher: Watcher, *, log: bool = False) -> None:
        source, entry = running.read(job.path), robots.find(job.robot)
        program = running.program(source, entry)
        self._filename = program.name
        self._log = RunLog(program)
        self._hands = _hands(job.hands)
        self._workers: list[InlineWorker] = []
        self._programs: list[_Program] = []
        self._seen = _Seen(watcher)
        self._run = ProgramRun(
            running.Job(program, entry, replace(job.options, pace="free")),
            worker=self._worker,
            watcher=self._seen,
            log=self._log if log else None,
        )

    def run(self, steps: Collection[int]) -> Remembered:
        truths: dict[int, Truth] = {}
        sample = frozenset(steps)
        step, began = World.step, _Program.__init__

        def looked_at(world: World) -> None:
            self._touch(world)
            if world.steps in sample:
                truths[world.steps] = self._truth()
            step(world)

        def begins(program: _Program, *args: Any, **more: Any) -> None:
            self._programs.append(program)
            began(program, *args, **more)

        with (
            patch.object(World, "step", looked_at),
            patch.object(_Program, "__init__", begins),
        ):
            report = self._run.run()
        return Remembered(report, truths, self._log)

    def _worker(self) -> InlineWorker:
        self._workers.append(InlineWorker())
        return self._workers[-1]

    def _touch(self, world: World) -> None:
        client = self._run.client
        assert isinstance(client, SimulatedRobot)
        for how in self._hands.pop(world.steps, ()):
            if isinstance(how, str):
                client.simulation.handle(client.name, how)
            else:
                client.simulation.place(client.name, *how)

    def _truth(self) -> Truth:
        client = self._run.client
        assert isinstance(client, SimulatedRobot)
        frames = [*_frames(self._workers[-1]._program.gr_frame, self._filename)]
        names = [frame.f_code.co_name for frame in frames]
        inner = frames[0]
        is_function = inner.f_locals is not inner.f_globals
        robot = self._programs[-1]._robot
        assert robot
        program = {
            "line": self._seen.last_line,
            "stack": [name for name in reversed(names) if not name.startswith("<")],
            "shared": _values(inner.f_globals),
            "local": _values(inner.f_locals) if is_function else {},
            "whens": dict(_whens(robot, client.simulation.steps)),
            "printed": self._seen.characters,
        }
        return Truth(_world(client), _pictures(client), program)


def _whens(robot: Client, steps: int) -> Iterator[tuple[str, tuple[bool, float]]]:
    """The state of each `when`; the program's own clock stands still while it waits."""
    assert robot.clock.instant is not None
    waited = (steps - robot.clock.instant) * TICK
    for when in robot._whens:
        active, time = when.state
        yield when.name, (active, round(time + waited, 3) if active else 0.0)


def _frames(frame: FrameType | None, filename: str) -> Iterator[FrameType]:
    while frame:
        if frame.f_code.co_filename == filename and frame.f_code.co_name != "<lambda>":
            yield frame
        frame = frame.f_back


def _values(names: dict[str, Any]) -> dict[str, str]:
    return {
        name: shown(msgspec.msgpack.decode(msgspec.msgpack.encode(snapshot(value))))
        for name, value in names.items()
        if not (name.startswith("__") or callable(value) or isinstance(value, Client))
        and type(value).__name__ != "module"
    }


def _told(moments: Moments, time: float) -> dict[str, Any]:
    moment = moments.at(time)
    return {
        "line": moment.line,
        "stack": [*moment.stack],
        "shared": moment.shared,
        "local": moment.local,
        "whens": {name: state for name, state in moment.whens.items() if name != "start"},
        "printed": moment.printed,
    }


def _world(robot: SimulatedRobot) -> bytes:
    monitor = WorldMonitor.of(robot)
    body = robot.body
    more = [body.odometry, body.distance_driven, body.wheels_rolled, body.log]
    strokes = [[stroke.colour, stroke.width, stroke.points] for stroke in monitor.strokes()]
    # Order is that of dictionaries; every digit of each number is compared.
    return msgspec.json.encode([monitor.state(), more, strokes], order="sorted")


def _pictures(robot: SimulatedRobot) -> tuple[str, ...]:
    return tuple(
        hashlib.sha256(robot.body.view(camera.key).picture().tobytes()).hexdigest()
        for camera in robot.body.description.camera
    )


def _hands(seed: int | None) -> dict[int, list[Any]]:
    if seed is None:
        return {}
    rng = random.Random(seed)  # noqa: S311 - not a secret
    touches: dict[int, list[Any]] = {}
    for _ in range(HANDS):
        pose = (rng.uniform(-300, 300), rng.uniform(-300, 300), rng.uniform(-180, 180))
        how = rng.choice((pose, pose, rng.choice(("shake", *TILTS))))
        touches.setdefault(rng.randrange(300), []).append(how)
    return touches


def random_job(folder: Path, seed: int) -> Job:
    """The run of a random program, every third one disturbed by hands."""
    program = random_program(seed)
    path = folder / f"random{seed}.bt"
    path.write_text(program.text, encoding="utf-8")
    options = Options(world=program.world, seconds=20, seed=seed)
    return Job(path, program.robot, options, seed if seed % 3 == 0 else None)
