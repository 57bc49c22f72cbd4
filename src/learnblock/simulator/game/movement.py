"""How things of games move: along a path, or at random as the seed says.

Only sums, products and square roots are used, which are the same on every computer.
"""

from collections.abc import Sequence
from hashlib import blake2b
from math import sqrt

from learnblock.simulator.game.description import Moving
from learnblock.simulator.geometry import Point

#: The shortest time in s from one corner to the next, even to the same place.
SHORTEST_LEG = 0.05


class Movement:
    """Where a thing is, at times that only grow.

    Args:
        moving: its place, and how it moves.
        key: what sets its random ways apart from those of others, the world's seed included.
    """

    def __init__(self, moving: Moving, key: str) -> None:
        self._home = (moving.x, moving.y)
        self._wander, self._speed = moving.wander, moving.speed
        self._key = key
        self._stops = _stops(moving)
        #: Whether it moves at all.
        self.moves = bool(moving.wander) or len(self._stops) > 1
        self._leg = 0
        self._from, self._to = self._home, self._home
        self._begins = self._ends = 0.0

    def at(self, time: float) -> Point:
        """Where it is at a time in s."""
        if not self.moves:
            return self._home
        while time >= self._ends:
            self._turn()
        share = (time - self._begins) / (self._ends - self._begins)
        (x, y), (to_x, to_y) = self._from, self._to
        return x + share * (to_x - x), y + share * (to_y - y)

    def _turn(self) -> None:
        """Begin the next leg of the way."""
        self._leg += 1
        self._from, self._to = self._to, self._corner(self._leg)
        x, y = self._to[0] - self._from[0], self._to[1] - self._from[1]
        self._begins = self._ends
        self._ends += max(SHORTEST_LEG, sqrt(x * x + y * y) / self._speed)

    def _corner(self, leg: int) -> Point:
        if not self._wander:
            return self._stops[leg % len(self._stops)]
        bits = blake2b(f"{self._key}\0{leg}".encode(), digest_size=16).digest()
        east, north = (int.from_bytes(half, "big") / 2**63 - 1 for half in (bits[:8], bits[8:]))
        return self._home[0] + east * self._wander, self._home[1] + north * self._wander


def _stops(moving: Moving) -> Sequence[Point]:
    """The corners of its way, until it begins again; without a path its place."""
    there = [(moving.x, moving.y), *moving.path]
    return there if moving.closed else [*there, *there[-2:0:-1]]
