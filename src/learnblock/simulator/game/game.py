"""The game of a world: its things, what they count, and how it ends."""

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence

from learnblock.scores import GameEvent, GameResult, Scores
from learnblock.simulator.game.checks import THINGS
from learnblock.simulator.game.description import GameRules
from learnblock.simulator.game.solids import DoorNow, MovingSolid, SwitchNow
from learnblock.simulator.game.teams import Teams
from learnblock.simulator.game.things import (
    Contestant,
    ContestantBody,
    GameEffects,
    GateOrder,
    LyingThing,
    ZoneNow,
)
from learnblock.simulator.geometry import Pose
from learnblock.simulator.goal import GoalState
from learnblock.simulator.physics import Physics
from learnblock.simulator.world_description import Box, Cylinder, WorldDescription


class WorldGame:
    """The game of a world; it begins when the first robot with a program joins it.

    Args:
        world: the description of the world.
        physics: the plane in which its solid things are.
        seed: the seed of random ways.
        period: seconds between two looks at it.
    """

    def __init__(self, world: WorldDescription, physics: Physics, seed: int, period: float) -> None:
        self._rules = world.game or GameRules()
        #: Worlds without rules have goals, too, which end nothing.
        self._ends_with_goals = world.game is not None and world.game.goals_win
        #: Whether single goals win the game; then the others don't end it.
        self._has_winning_goals = any(goal.wins for _, _, goal in world.goal.all())
        self.teams = Teams(world)
        self.scores = Scores(self._rules.lives)
        self._effects = GameEffects(self.scores)
        self._period = period
        self._pushed = physics.pushed
        self.lying = [
            LyingThing(thing, f"{thing.kind} {number}", f"{seed}\0collectable {number}")
            for number, thing in enumerate(world.collectable, 1)
        ]
        self.solids = [
            MovingSolid(mover, physics, f"{seed}\0mover {number}")
            for number, mover in enumerate(world.mover, 1)
        ]
        objects = {thing.thing.name: thing for thing in physics.pushed}
        self._zones = [ZoneNow(zone, objects.get(zone.object or "")) for zone in world.zone]
        self._gates = GateOrder(world.gate)
        self.doors = [DoorNow(door, physics) for door in world.door]
        self.switches = [SwitchNow(switch) for switch in world.switch]
        self._robots: list[Contestant] = []
        self._has_begun = False
        #: Whether the world has things of games; what programs count needs none of them.
        self.has_things = any(getattr(world, table) for table in THINGS)
        #: Whether the world says what holds for its game.
        self.has_rules = world.game is not None
        self.move(0.0)

    @property
    def is_over(self) -> bool:
        """Whether it has been won or lost."""
        return self.scores.result is not None

    @property
    def is_decided(self) -> bool:
        """Whether its winning goals have ended it, so that no other goal counts any more."""
        return self._has_winning_goals and self.is_over

    @property
    def has_events(self) -> bool:
        """Whether there are events to take."""
        return self.scores.has_events

    def take_events(self) -> list[GameEvent]:
        """The events since the last call, oldest first."""
        return self.scores.take_events()

    @property
    def passed(self) -> Mapping[str, int]:
        """How many gates each robot has passed."""
        return self._gates.passed

    @property
    def state(self) -> tuple[object, ...]:
        """What counts now, and where everything is."""
        return (
            self.scores.state,
            tuple((thing.place, thing.is_there) for thing in self.lying),
            tuple(solid.pose for solid in self.solids),
            tuple(door.is_open for door in self.doors),
        )

    @property
    def is_live(self) -> bool:
        """Whether anything in it can happen by itself."""
        return self.has_things or self.scores.counts_down

    @property
    def left(self) -> Mapping[str, int]:
        """How many things of each kind are still to be collected."""
        return Counter(thing.described.kind for thing in self.lying if thing.is_there)

    def add(self, name: str, body: ContestantBody) -> None:
        """Add a robot of the world, whether or not a program will join with it."""
        self._robots.append(Contestant(name, body))

    def visible(self) -> Iterator[tuple[Box | Cylinder, Pose]]:
        """The solid things that cameras see now, and where they are."""
        for solid in self.solids:
            yield solid.seen, solid.pose
        for door in self.doors:
            if not door.is_open:
                yield door.seen, door.pose

    def join(self, player: str, time: float) -> None:
        """Add a robot with a program; the first one begins the game."""
        self.scores.join(player)
        if not self._has_begun:
            self._has_begun = True
            if self._rules.countdown is not None:
                self.scores.start_countdown(self._rules.countdown, time, thing="world")

    def move(self, time: float) -> None:
        """Let everything move on from a time in s to the next look."""
        for thing in self.lying:
            thing.move(time)
        for solid in self.solids:
            solid.move(time + self._period, self._period)

    def look(self, time: float) -> None:
        """Let things and robots meet at a time in s."""
        self._effects.time = time
        if self.has_things:
            self.move(time)
            self._work_doors()
        if not self._has_begun or self.is_over:
            return
        if self.scores.look(time):
            self._end_countdown(time)
        if self.has_things:
            self._meet([robot for robot in self._robots if self.scores.plays(robot.name)])

    def judge(self, goals: Sequence[GoalState], time: float) -> None:
        """End the game if its goals decide it.

        A winning goal ends it, or that all of these are missed. Where no goal wins and the world
        says so, all goals end it, or a missed one.

        Args:
            goals: the states of the goals.
            time: now, in seconds.
        """
        if not (self._has_begun and goals):
            return
        if self._has_winning_goals:
            self._judge_winning([goal for goal in goals if goal.wins], time)
        elif self._ends_with_goals:
            self._judge_all(goals, time)

    def _judge_winning(self, goals: Sequence[GoalState], time: float) -> None:
        """End the game with the first goal that is reached, or when none can be any more."""
        reached = next((goal for goal in goals if goal.reached_at is not None), None)
        if reached is not None:
            player = reached.robot
            team = reached.team or self.teams.robots.get(player, "")
            name = reached.name
            self.scores.end(
                GameResult.of(time, "winning-goal", won=True, player=player, thing=name, team=team)
            )
        elif not any(goal.is_open for goal in goals):
            self.scores.end(GameResult.of(time, "goal-failed", won=False, thing=goals[-1].name))

    def _judge_all(self, goals: Sequence[GoalState], time: float) -> None:
        missed = next((goal.name for goal in goals if goal.failed_at is not None), None)
        if missed is not None:
            self.scores.end(GameResult.of(time, "goal-failed", won=False, thing=missed))
        elif not any(goal.is_open for goal in goals):
            self.scores.end(GameResult.of(time, "goals", won=True, player=goals[-1].robot))

    def _end_countdown(self, time: float) -> None:
        """End the game with the world's countdown, if it says so; others are the program's."""
        if self._rules.countdown is not None and self._rules.time_up != "program":
            self.scores.end(GameResult.of(time, "time", won=self._rules.time_up == "win"))

    def _work_doors(self) -> None:
        for switch in self.switches:
            switch.look(self._robots, self._pushed, self._effects)
        for door in self.doors:
            name, time = door.described.name, self._effects.time
            is_open = any(
                switch.opens_until > time or switch.is_pressed
                for switch in self.switches
                if switch.described.door == name
            )
            if door.set(is_open=is_open):
                self.scores.note(GameEvent(time, "opened" if is_open else "closed", "", name))

    def _meet(self, players: Sequence[Contestant]) -> None:
        for thing in self.lying:
            thing.look(players, self._effects)
        for zone in self._zones:
            zone.look(players, self._effects)
        self._gates.look(players, self._effects)
        for solid in self.solids:
            solid.look(players, self._effects)
