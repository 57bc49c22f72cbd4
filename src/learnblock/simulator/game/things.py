"""The things of a game that robots collect, enter, pass and touch, and what they do to them."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Protocol

from learnblock.scores import GameResult, Scores
from learnblock.simulator.game.description import Collectable, Mover, RaceGate, Switch, Zone
from learnblock.simulator.game.movement import Movement
from learnblock.simulator.geometry import Point, Pose, forward
from learnblock.simulator.physics import Pushed

#: Seconds after a thing has taken a life in which no other one does.
RECOVERY = 2.0
#: The distance in mm within which a robot counts as touching a solid thing.
CLOSE = 3.0


class ContestantBody(Protocol):
    """The body of a robot, as things of a game notice it."""

    @property
    def pose(self) -> Pose:
        """Where it is."""

    def touches(self, place: Point, radius: float) -> bool:
        """Whether it is within so many mm of a place."""


@dataclass(frozen=True, slots=True)
class Contestant:
    """A robot in a game, with its name in the world."""

    name: str
    body: ContestantBody

    @property
    def pose(self) -> Pose:
        """Where it is."""
        return self.body.pose


@dataclass(slots=True)
class GameEffects:
    """What things do to players.

    Args:
        scores: what counts.
        time: now, in seconds.
    """

    scores: Scores
    time: float = 0.0
    _recovered: dict[str, float] = field(default_factory=dict)

    def collected(self, player: str, thing: Collectable, name: str) -> None:
        """Count a thing that a player has collected, and tell its program."""
        lives = self._lives(player, thing.lives)
        self.scores.affect(
            "collected", player, self.time, thing=name, points=thing.score, lives=lives
        )
        self.scores.keep(player, thing.kind)

    def crossed(self, player: str, zone: Zone) -> None:
        """Count a zone that a player has entered or left; it may end the game."""
        lives = self._lives(player, zone.lives)
        self.scores.affect(
            zone.when, player, self.time, thing=zone.name, points=zone.score, lives=lives
        )
        if zone.ends != "no":
            self.scores.end(
                GameResult.of(
                    self.time, "zone", won=zone.ends == "win", player=player, thing=zone.name
                )
            )

    def passed(self, player: str, gate: RaceGate) -> None:
        """Count a gate that a player has passed."""
        self.scores.affect("passed", player, self.time, thing=gate.name, points=gate.score)

    def touched(self, player: str, mover: Mover) -> None:
        """Count a moving thing that a player has touched."""
        lives = self._lives(player, mover.lives)
        if lives or mover.score:
            self.scores.affect(
                "touched", player, self.time, thing=mover.name, points=mover.score, lives=lives
            )

    def pressed(self, player: str, switch: Switch) -> None:
        """Note that a player has pressed a switch."""
        self.scores.affect("pressed", player, self.time, thing=switch.name)

    def _lives(self, player: str, lives: int) -> int:
        """The lives that count now: none is lost just after another one."""
        if lives < 0:
            if self.time < self._recovered.get(player, 0.0):
                return 0
            self._recovered[player] = self.time + RECOVERY
        return lives


class LyingThing:
    """A thing that can be collected, and where it is now.

    Args:
        described: the thing in the world's file.
        name: its name in events.
        key: see `Movement`.
    """

    def __init__(self, described: Collectable, name: str, key: str) -> None:
        self.described = described
        self._name = name
        self._movement = Movement(described, key)
        self.place: Point = (described.x, described.y)
        #: When it is there again, in seconds.
        self._returns_at = 0.0
        self.is_there = True

    @property
    def moves(self) -> bool:
        """Whether it moves by itself."""
        return self._movement.moves

    def move(self, time: float) -> None:
        """Be where it is at a time in s."""
        self.place = self._movement.at(time)
        self.is_there = time >= self._returns_at

    def look(self, players: Sequence[Contestant], effects: GameEffects) -> None:
        """Be collected by the first player that touches it."""
        for player in players if self.is_there else ():
            if player.body.touches(self.place, self.described.radius):
                after = self.described.returns_after
                self._returns_at = math.inf if after is None else effects.time + after
                self.is_there = False
                effects.collected(player.name, self.described, self._name)
                return


class ZoneNow:
    """A zone, and who is in it now.

    Args:
        described: the zone in the world's file.
        thing: the object that has to enter, and where it was at first; None for robots.
    """

    def __init__(self, described: Zone, thing: Pushed | None = None) -> None:
        self.described = described
        self._thing = thing
        self._home = thing.body.position if thing else (0.0, 0.0)
        self._inside: set[str] = set()
        self._done: set[str] = set()

    def look(self, players: Sequence[Contestant], effects: GameEffects) -> None:
        """Count who has entered or left."""
        if self._thing is None:
            wanted = self.described.robot
            for player in players:
                if wanted in (None, player.name):
                    self._cross(player.name, player.name, player.pose, effects)
        elif players:
            pose = self._thing.pose
            counted = self.described.robot or _nearest(players, pose).name
            if self._cross("", counted, pose, effects) and self.described.returns:
                self._put_back(self._thing)

    def _cross(self, who: str, player: str, pose: Pose, effects: GameEffects) -> bool:
        """Note where a robot or the object is; return whether that counts."""
        zone, was_inside = self.described, who in self._inside
        is_inside = math.hypot(pose.x - zone.x, pose.y - zone.y) <= zone.radius
        (self._inside.add if is_inside else self._inside.discard)(who)
        counts = is_inside if zone.when == "entered" else not is_inside
        if is_inside == was_inside or not counts or who in self._done:
            return False
        if not zone.again:
            self._done.add(who)
        effects.crossed(player, zone)
        return True

    def _put_back(self, thing: Pushed) -> None:
        thing.body.position = self._home
        thing.body.velocity, thing.body.angular_velocity = (0.0, 0.0), 0.0
        self._inside.clear()


class GateOrder:
    """The gates of a world, which players pass in their order, round after round.

    Args:
        described: the gates in the world's file.
    """

    def __init__(self, described: Sequence[RaceGate]) -> None:
        self._gates = described
        #: How many gates each player has passed so far.
        self.passed: dict[str, int] = {}
        self._before: dict[str, Pose] = {}

    def look(self, players: Sequence[Contestant], effects: GameEffects) -> None:
        """Count who has passed the gate that is next for it."""
        for player in players if self._gates else ():
            now, before = player.pose, self._before.get(player.name)
            self._before[player.name] = now
            count = self.passed.get(player.name, 0)
            gate = self._gates[count % len(self._gates)]
            if before and _crosses(gate, before, now):
                self.passed[player.name] = count + 1
                effects.passed(player.name, gate)


def _nearest(players: Sequence[Contestant], pose: Pose) -> Contestant:
    return min(players, key=lambda one: math.hypot(one.pose.x - pose.x, one.pose.y - pose.y))


def _crosses(gate: RaceGate, before: Pose, now: Pose) -> bool:
    """Whether a way leads through a gate in its direction."""
    along = forward(gate.heading)
    start, end = (_seen_from(gate, along, pose) for pose in (before, now))
    if not start[0] < 0 <= end[0]:
        return False
    share = start[0] / (start[0] - end[0])
    return abs(start[1] + share * (end[1] - start[1])) <= gate.width / 2


def _seen_from(gate: RaceGate, along: Point, pose: Pose) -> Point:
    """A place as seen from a gate: mm behind it, and to its left."""
    x, y = pose.x - gate.x, pose.y - gate.y
    return x * along[0] + y * along[1], y * along[0] - x * along[1]
