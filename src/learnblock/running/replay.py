"""A run again from the commands in its trace, to see whether its poses and goals are true.

The wheels' commands alone decide where a robot drives. A clean world in which they are repeated
therefore shows whether something else has changed the robot, its world, its goals or the trace. It
does not show whether the program has given these commands.
"""

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import zip_longest
from typing import Any

import msgspec

from learnblock import robots
from learnblock.client import Witness
from learnblock.devices import Pose
from learnblock.errors import LearnBlockError
from learnblock.robots.simulated import SimulatedRobot, Simulation, repeat_game

#: The keys of the lines that matter; most lines of a trace have others.
_MARKS = tuple(
    f'"{name}":'.encode() for name in ("run", "device", "pose", "placed", "goal", "game", "end")
)
_STEPS_PER_SECOND = 100
Seen = tuple[Any, ...]


@dataclass(frozen=True, slots=True)
class Replay:
    """What a trace says, and what happens in a clean world.

    Args:
        recorded: the poses and goals in the trace, in order: the robot's name, which of the two,
            the time in s, and the rest.
        repeated: those of the clean world.
    """

    recorded: tuple[Seen, ...]
    repeated: tuple[Seen, ...]

    @property
    def is_true(self) -> bool:
        """Whether the trace is true."""
        return self.recorded == self.repeated

    @property
    def differs_at(self) -> float:
        """The time in s of the first difference; infinite if there is none."""
        pairs = zip_longest(self.recorded, self.repeated)
        different = ((recorded or repeated) for recorded, repeated in pairs if recorded != repeated)
        return next((float(sighting[2]) for sighting in different if sighting), math.inf)


def replay(trace: bytes, world: str | None = None) -> Replay:
    """Repeat a run of simulated robots from its trace.

    Args:
        trace: the trace of a complete run.
        world: the world's name or path; by default the name in the trace.

    Raises:
        LearnBlockError: it is not a trace of simulated robots, or there is no such world.
    """
    lines = [*_lines(trace)]
    runs = [line for line in lines if "run" in line]
    if not runs:
        raise LearnBlockError("run-not-a-trace")
    stage = _Stage(runs, world)
    for line in lines:
        stage.do(line)
    return Replay(tuple(stage.recorded), tuple(stage.repeated))


def _lines(trace: bytes) -> Iterator[dict[str, Any]]:
    decode = msgspec.json.Decoder(dict[str, Any]).decode
    for text in trace.splitlines():
        if any(mark in text for mark in _MARKS):
            try:
                yield decode(text)
            except msgspec.DecodeError as error:
                raise LearnBlockError("run-not-a-trace") from error


@dataclass
class _Eye(Witness):
    """Sees how one robot moves and which goals it reaches, as the recorder of its trace."""

    name: str
    sightings: list[Seen]

    def pose(self, time: float, pose: Pose) -> None:
        rounded = [round(value, 3) + 0.0 for value in pose]
        self.sightings.append((self.name, "pose", round(time, 6), rounded))

    def goal(self, time: float, name: str, state: str) -> None:
        self.sightings.append((self.name, "goal", round(time, 6), name, state))


class _Stage:
    """A clean world with the robots of a trace.

    Args:
        runs: the first line of each robot.
        world: the world's name or path; None for the one in the trace.
    """

    def __init__(self, runs: list[dict[str, Any]], world: str | None) -> None:
        self.recorded: list[Seen] = []
        self.repeated: list[Seen] = []
        self._simulation = _simulation(runs[0]["run"], world)
        for line in runs:
            kind, start = _kind(line["run"]), line["run"].get("start")
            self._simulation.world.add_robot(
                kind.description(), name=_name(line), start=tuple(start) if start else None
            )

    def do(self, line: Mapping[str, Any]) -> None:
        """Repeat what a line says, or note what it says about the world."""
        name, time = _name(line), line.get("t", 0.0)
        self._simulation.advance(round(time * _STEPS_PER_SECOND))
        robot = self._simulation.world.robots[name]
        match line:
            case {"run": _}:
                self._simulation.world.game.join(name, time)
                eye = self._simulation.witnesses[name] = _Eye(name, self.repeated)
                eye.pose(self._simulation.time(), robot.pose)
            case {"device": "Base", "do": "move", "args": args}:
                robot.drive(*args)
            case {"device": "Display", "do": "show_emotion", "args": [emotion]}:
                robot.show_emotion(emotion)
            case {"placed": pose}:
                self._simulation.place(name, *pose)
            case {"game": _}:
                repeat_game(self._simulation, name, line)
            case {"pose": pose}:
                self.recorded.append((name, "pose", time, pose))
            case {"goal": goal, "state": state}:
                self.recorded.append((name, "goal", time, goal, state))
            case {"end": _}:
                self._simulation.finish(name)


def _simulation(run: Mapping[str, Any], world: str | None) -> Simulation:
    return _kind(run).make_simulation(
        world=world or run["world"], seed=run["seed"], pace="free", variant=run.get("variant", 0)
    )


def _kind(run: Mapping[str, Any]) -> type[SimulatedRobot]:
    kind = robots.find(run["robot"]).load()
    if not issubclass(kind, SimulatedRobot):
        raise LearnBlockError("run-not-a-trace")
    return kind


def _name(line: Mapping[str, Any]) -> str:
    name: str = line.get("robot", "robot")
    return name
