"""Runs the world of a run again from its commands, to show any moment of it exactly.

A simulated world depends on its description, its seed and the commands to its robot, and on nothing
else. So the log needs neither poses nor pictures: they are what the world shows when it runs again.
"""

from bisect import bisect_right
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from learnblock import robots
from learnblock.client import endings
from learnblock.errors import LearnBlockError
from learnblock.robots.simulated import SimulatedRobot, Simulation, repeat_game, world_of_data
from learnblock.runtime.log.noting import TICK
from learnblock.simulator import World
from learnblock.why.recorded import Recorded

#: The longest run that is run again, in s; an hour takes some seconds.
LONGEST = 4 * 3600.0
#: What decides about the world, by the name of its line in the trace.
_DECISIVE = ("device", "again", "placed", "handled", "game", "end")
#: The name of a robot that is alone in its world.
NAME = "robot"
#: Steps between two moments at which the world is kept, and the most of them.
APART, MOST_KEPT = 1000, 64


# Why: docs/decisions.md, "The log holds no poses and no pictures of a simulated run"
class WorldAgain:
    """The world of a run at any moment.

    Args:
        recorded: the log of a run on a simulated robot.
        make: makes the robot in its world; by default those of the log.
        lines: the first of its lines; all by default.

    Raises:
        LearnBlockError: it is not; then only the recorded data can be shown.
    """

    def __init__(
        self,
        recorded: Recorded,
        make: Callable[[], SimulatedRobot] | None = None,
        lines: Iterable[dict[str, Any]] | None = None,
    ) -> None:
        self._make = _alone(make) if make else _recorded_robots(recorded)
        self._lines: list[dict[str, Any]] = []
        #: The step at which each line takes effect.
        self._steps: list[int] = []
        self._shown = self._begin()
        #: Copies of earlier worlds, from which it continues, in order of time.
        self._kept: list[_Kept] = []
        #: The world that runs ahead to find copies to keep.
        self._leader: _Run | None = None
        self.extend(recorded.team or recorded.lines if lines is None else lines)

    @property
    def robot(self) -> SimulatedRobot:
        """The robot as it was at the moment of the last `seek`; it can be asked, not commanded."""
        return self._shown.robot

    def extend(self, lines: Iterable[dict[str, Any]]) -> None:
        """Add what has happened since.

        Args:
            lines: of the log, in order of time, after those that it already has.

        Raises:
            LearnBlockError: the run is too long.
        """
        new = [line for line in lines if any(name in line for name in _DECISIVE)]
        if not new:
            return
        first = _step(new[0])
        self._lines.extend(new)
        self._steps.extend(map(_step, new))
        if self._steps[-1] * TICK > LONGEST:
            raise LearnBlockError("log-too-long", most=LONGEST)
        # A world that is already past them has missed them.
        self._kept = [world for world in self._kept if world.step < first]
        if self._leader and self._leader.step >= first:
            self._leader = None
        if self._shown.step >= first:
            self._shown = self._before(first - 1)

    def seek(self, time: float) -> SimulatedRobot:
        """Show the moment at a time in s."""
        step = round(min(max(time, 0.0), LONGEST) / TICK)
        best = self._before(step, self._shown)
        self._shown = best
        self._advance(best, step)
        return best.robot

    def prepare(self) -> bool:
        """Keep the world at one more moment, so that seeking need not begin at the start.

        A copy of a world lacks the contacts that its physics remembers. So it is kept only if it
        continues exactly as the world itself, up to the next moment.

        Returns:
            whether there is more to prepare.
        """
        last = self._steps[-1] if self._steps else 0
        apart = max(APART, last // MOST_KEPT)
        leader = self._leader or self._before(last)
        self._leader = leader
        if leader.step + apart > last:
            return False
        state = _Kept(leader.step, leader.next_line, leader.simulation.world.copy())
        again = self._again(state)
        for run in (leader, again):
            self._advance(run, state.step + apart)
        if again.state == leader.state:
            self._kept.append(state)
        return True

    def _before(self, step: int, *others: "_Run") -> "_Run":
        """A run of the world that can continue to a step: the nearest, or one from the start."""
        candidates = [run for run in others if run.step <= step]
        index = bisect_right(self._kept, step, key=lambda world: world.step) - 1
        state = self._kept[index] if index >= 0 else None
        if candidates and (state is None or candidates[0].step >= state.step):
            return candidates[0]
        return self._again(state) if state else self._begin()

    def _again(self, state: "_Kept") -> "_Run":
        return self._shown.within(state.world.copy(), state.next_line)

    def _begin(self) -> "_Run":
        return _Run(self._make())

    def _advance(self, run: "_Run", step: int) -> None:
        while run.next_line < len(self._lines) and self._steps[run.next_line] <= step:
            run.simulation.advance(self._steps[run.next_line])
            run.do(self._lines[run.next_line])
            run.next_line += 1
        run.simulation.advance(step)


@dataclass(frozen=True)
class _Kept:
    """A copy of an earlier world.

    Args:
        step: the number of its steps.
        next_line: the index of the first line that had not taken effect.
        world: a copy that does not advance itself.
    """

    step: int
    next_line: int
    world: World


class _Run:
    """A world that is run again, with its robots.

    Args:
        team: the robots in it; the first one is that of the log.
        next_line: the index of the first line that has not taken effect.
    """

    def __init__(self, team: Sequence[SimulatedRobot], next_line: int = 0) -> None:
        self.robot = team[0]
        self.simulation: Simulation = self.robot.simulation
        self._team = {robot.name: robot for robot in team}
        # Shown robots are never stopped; without this, Python would keep them to its end.
        for robot in team:
            endings.forget(robot.stop)
        self._devices = {
            (robot.name, type(device).__name__, key): device
            for robot in team
            for key, device in robot.devices()
        }
        self.next_line = next_line

    @property
    def step(self) -> int:
        """The number of its steps."""
        return self.simulation.steps

    @property
    def state(self) -> object:
        """The state that decides how it continues."""
        return self.simulation.world.state

    def within(self, world: World, next_line: int) -> "_Run":
        """The same robots in another world, in which the lines before this one took effect."""
        simulation = Simulation(world)
        team = [
            type(robot)(simulation=simulation, start=robot.start, name=robot.name)
            for robot in self._team.values()
        ]
        return _Run(team, next_line)

    def do(self, line: Mapping[str, Any]) -> None:
        # The twin of a real robot among several has a name of its own.
        name = line["robot"] if line.get("robot") in self._team else self.robot.name
        match line:
            case {"device": kind, "key": key, "do": function, "args": args}:
                self._devices[name, kind, key].functions[function](*args)
            case {"again": again}:
                self.do({**again, "robot": name})
            case {"placed": pose}:
                self.simulation.place(name, *pose)
            case {"handled": how}:
                self.simulation.handle(name, how)
            case {"game": _}:
                repeat_game(self.simulation, name, line)
            case {"end": _}:
                self.simulation.finish(name)


def _alone(make: Callable[[], SimulatedRobot]) -> Callable[[], Sequence[SimulatedRobot]]:
    return lambda: (make(),)


def _recorded_robots(recorded: Recorded) -> Callable[[], Sequence[SimulatedRobot]]:
    """A function that makes the world of a log again, with its robots, that of the log first."""
    run, world = recorded.conditions, recorded.robot.get("world")
    if not run or world is None or any("lost" in line for line in recorded.lines):
        raise LearnBlockError("log-no-world")
    own = recorded.name
    roster = recorded.roster or ({**run, "name": own},)
    kinds = {str(member["name"]): _kind(member) for member in roster}
    starts = {str(member["name"]): tuple(member.get("start") or ()) or None for member in roster}
    if own not in kinds:
        raise LearnBlockError("log-no-world")
    description = world_of_data(world)

    def make() -> Sequence[SimulatedRobot]:
        simulation = Simulation(World(description, seed=run.get("seed", 0)))
        for name, kind in kinds.items():
            simulation.world.add_robot(kind.description(), name, starts[name])
        return [
            kinds[name](simulation=simulation, start=starts[name], name=name)
            for name in sorted(kinds, key=lambda name: name != own)
        ]

    return make


def _kind(robot: Mapping[str, Any]) -> type[SimulatedRobot]:
    kind = robots.find(str(robot.get("robot", ""))).load()
    if not issubclass(kind, SimulatedRobot):
        raise LearnBlockError("log-no-world")
    return without_extra_camera(kind)


def without_extra_camera(kind: type[SimulatedRobot]) -> type[SimulatedRobot]:
    """The same robot, but with this computer's camera off: it is only shown."""
    # It finds its description next to its module.
    changes = {"has_extra_camera": False, "__module__": kind.__module__}
    return type(kind.__name__, (kind,), changes)


def _step(line: Mapping[str, Any]) -> int:
    return round(float(line["t"]) / TICK)
