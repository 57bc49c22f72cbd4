"""The solid things of a game: moving ones, and doors with their switches."""

import math
from collections.abc import Sequence

import pymunk
from msgspec import structs

from learnblock.simulator.game.description import Door, Mover, Switch
from learnblock.simulator.game.movement import Movement
from learnblock.simulator.game.things import CLOSE, Contestant, GameEffects
from learnblock.simulator.geometry import Pose
from learnblock.simulator.physics import Physics, Pushed
from learnblock.simulator.world_description import Box, Cylinder

_CLOSED, _OPEN = pymunk.ShapeFilter(), pymunk.ShapeFilter(mask=0)


class MovingSolid:
    """A solid thing that moves by itself: it pushes robots, and nothing pushes it.

    Args:
        described: the thing in the world's file.
        physics: the plane that it is in.
        key: see `Movement`.
    """

    def __init__(self, described: Mover, physics: Physics, key: str) -> None:
        self.described = described
        self._movement = Movement(described, key)
        self._body = pymunk.Body(body_type=pymunk.Body.KINEMATIC)
        self._body.position = described.x, described.y
        physics.space.add(self._body)
        physics.add(pymunk.Circle(self._body, described.radius), described.name)
        self._touching: set[str] = set()

    @property
    def pose(self) -> Pose:
        """Where it is now."""
        x, y = self._body.position
        return Pose(x, y, 0.0)

    @property
    def seen(self) -> Cylinder:
        """What cameras see of it."""
        look = self.described
        return Cylinder(
            x=look.x,
            y=look.y,
            radius=look.radius,
            height=look.height,
            colour=look.colour,
            name=look.name,
        )

    def move(self, time: float, seconds: float) -> None:
        """Set out for where it is at a time in s, which is so many seconds from now."""
        if self._movement.moves:
            (x, y), (to_x, to_y) = self._body.position, self._movement.at(time)
            self._body.velocity = (to_x - x) / seconds, (to_y - y) / seconds

    def look(self, players: Sequence[Contestant], effects: GameEffects) -> None:
        """Count who has begun to touch it."""
        x, y = self._body.position
        for player in players:
            if not player.body.touches((x, y), self.described.radius + CLOSE):
                self._touching.discard(player.name)
            elif player.name not in self._touching:
                self._touching.add(player.name)
                effects.touched(player.name, self.described)


class DoorNow:
    """A door, which is a wall while it is closed.

    Args:
        described: the door in the world's file.
        physics: the plane that it is in.
    """

    def __init__(self, described: Door, physics: Physics) -> None:
        self.described = described
        self._space = physics.space
        body = pymunk.Body(body_type=pymunk.Body.STATIC)
        body.position = described.x, described.y
        body.angle = -math.radians(described.heading)
        self._shape = pymunk.Poly.create_box(body, (described.length, described.width))
        physics.space.add(body)
        physics.add(self._shape, described.name)
        self.is_open = False

    @property
    def pose(self) -> Pose:
        """Where it is while it is closed."""
        return Pose(self.described.x, self.described.y, self.described.heading)

    @property
    def seen(self) -> Box:
        """What cameras see of it while it is closed."""
        return Box(**structs.asdict(self.described))

    def set(self, *, is_open: bool) -> bool:
        """Open or close it, unless something is in the way; return whether that has changed it."""
        if is_open == self.is_open or (not is_open and self._is_blocked):
            return False
        self.is_open = is_open
        self._shape.filter = _OPEN if is_open else _CLOSED
        return True

    @property
    def _is_blocked(self) -> bool:
        self._shape.filter = _CLOSED
        hits = self._space.shape_query(self._shape)
        self._shape.filter = _OPEN
        return any(
            hit.shape and hit.shape.body and hit.shape.body.body_type == pymunk.Body.DYNAMIC
            for hit in hits
        )


class SwitchNow:
    """A switch, and whether something is on it.

    Args:
        described: the switch in the world's file.
    """

    def __init__(self, described: Switch) -> None:
        self.described = described
        self.is_pressed = False
        #: Until when its doors are open, in seconds.
        self.opens_until = 0.0

    def look(
        self, players: Sequence[Contestant], pushed: Sequence[Pushed], effects: GameEffects
    ) -> None:
        """Note what is on it now."""
        poses = [player.pose for player in players] + [thing.pose for thing in pushed]
        on = [self._is_on(pose) for pose in poses]
        if any(on):
            seconds = self.described.seconds
            self.opens_until = math.inf if seconds is None else effects.time + seconds
            pressing = on.index(True)
            if not self.is_pressed and pressing < len(players):
                effects.pressed(players[pressing].name, self.described)
        self.is_pressed = any(on)

    def _is_on(self, pose: Pose) -> bool:
        switch = self.described
        return math.hypot(pose.x - switch.x, pose.y - switch.y) <= switch.radius
