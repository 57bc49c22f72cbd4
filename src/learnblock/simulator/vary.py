"""Variants of a world: the same task with other starts, places, light and noise.

Variant 0 is the world as it is drawn. Each other number is a world of its own, which depends only
on the world's file, its name and the number, and is the same on every computer.
"""

import hashlib
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace

import pymunk
from msgspec import structs

from learnblock.errors import Diagnostic, WorldError
from learnblock.i18n import Phrase
from learnblock.simulator.geometry import wrapped
from learnblock.simulator.physics import Physics, footprint
from learnblock.simulator.world_description import (
    Box,
    Cylinder,
    Face,
    Start,
    Tag,
    WorldDescription,
    thing_name,
)

MOST_PLACES = 20
"""How many places are drawn for an object until one is free."""
MOST_TRIES = 50
"""How many times all objects are placed again because one of them did not fit."""
ROOM = 140.0
"""The radius in mm of the free floor around a start; our largest robot needs 127."""
LISTS = ("start", "box", "cylinder", "tag", "face")
"""The lists of a world's file whose objects can move; those that need most room come first."""

Movable = Box | Cylinder | Tag | Face | Start
Key = tuple[str, int]


def make_variant(world: WorldDescription, number: int) -> WorldDescription:
    """Make a variant of a world.

    Args:
        world: the world as it is drawn.
        number: 0 for that, or a positive number.

    Raises:
        WorldError: its file has no variants, or too little room for this one.
    """
    if number == 0:
        return world
    if world.vary is None:
        raise _error(world, "no-variants", Phrase("world-no-variants", world=world.name))
    draw = Draw(world.name, number)
    bounds = world.vary
    light = world.ambient_light + draw.within(bounds.light, "light")
    noise = world.sensor_noise + draw.within(bounds.noise, "noise", digits=3)
    slip = world.floor.slip + draw.within(bounds.slip, "slip", digits=4)
    return structs.replace(
        world,
        variant=number,
        floor=structs.replace(world.floor, slip=min(max(slip, 0.0), 0.3)),
        ambient_light=min(max(light, 0.0), 1023.0),
        sensor_noise=min(max(noise, 0.0), 10.0),
        **_moved(world, draw),
    )


@dataclass(frozen=True, slots=True)
class Draw:
    """The random numbers of one variant.

    No library's generator is used, because their streams differ between versions.

    Args:
        world: the world's name.
        variant: the variant's number.
        attempt: how often this variant was drawn before.
    """

    world: str
    variant: int
    attempt: int = 0

    def within(self, bound: float, *what: object, digits: int = 1) -> float:
        """A number from -bound to bound, rounded, that depends only on what it is for."""
        key = "\0".join(map(str, (self.world, self.variant, self.attempt, *what)))
        bits = hashlib.blake2b(key.encode(), digest_size=8).digest()
        share = (int.from_bytes(bits, "big") >> 11) / 2**53
        return round((2 * share - 1) * bound, digits)


@dataclass(frozen=True, slots=True)
class _Floor:
    """The objects that are in place already.

    Args:
        physics: holds their shapes.
        keys: the object of each shape; those of walls and the border have none.
    """

    physics: Physics
    keys: dict[pymunk.Shape, Key] = field(default_factory=dict)

    def add(self, key: Key, thing: Movable) -> None:
        shape = _footprint(thing)
        self.keys[shape] = key
        assert shape.body is not None  # noqa: S101 - a footprint has one
        self.physics.space.add(shape.body, shape)

    def touched(self, thing: Movable) -> set[object]:
        """The objects, walls and borders that an object overlaps."""
        hits = self.physics.space.shape_query(_footprint(thing))
        # Walls and borders are always the same shapes in the same order.
        fixed = list(self.physics.names)
        return {
            self.keys[hit.shape] if hit.shape in self.keys else fixed.index(hit.shape)
            for hit in hits
            if hit.shape is not None
        }


def _moved(world: WorldDescription, draw: Draw) -> dict[str, tuple[Movable, ...]]:
    """The lists of movable objects, at their places in the variant."""
    objects = dict(_objects(world))
    allowed = _overlaps(world, objects)
    stuck: Key | None = None
    for attempt in range(MOST_TRIES):
        placed, stuck = _arranged(world, objects, allowed, replace(draw, attempt=attempt))
        if stuck is None:
            return {kind: tuple(placed[key] for key in objects if key[0] == kind) for kind in LISTS}
    assert stuck is not None  # noqa: S101 - there was at least one attempt
    raise _no_room(world, draw, objects[stuck])


def _arranged(
    world: WorldDescription,
    objects: Mapping[Key, Movable],
    allowed: Mapping[Key, set[object]],
    draw: Draw,
) -> tuple[dict[Key, Movable], Key | None]:
    """The objects at new places, and the first that found none."""
    floor, placed = _emptied(world), dict[Key, Movable]()
    bounds = {key: _bounds(world, thing) for key, thing in objects.items()}
    # What does not move is put in place first.
    for key in sorted(objects, key=lambda key: any(bounds[key])):
        fits = _fits(world, floor, allowed[key])
        place = next(filter(fits, _places(objects[key], bounds[key], draw, key)), None)
        if place is None:
            return placed, key
        placed[key] = place
        floor.add(key, place)
    return placed, None


def _objects(world: WorldDescription) -> Iterator[tuple[Key, Movable]]:
    for kind in LISTS:
        for index, thing in enumerate(getattr(world, kind)):
            yield (kind, index), thing


def _bounds(world: WorldDescription, thing: Movable) -> tuple[float, float]:
    """How far an object may move (mm) and turn (degrees)."""
    assert world.vary is not None  # noqa: S101 - checked by `make_variant`
    if isinstance(thing, Start):
        return world.vary.start, world.vary.heading
    distances = {moved.name: moved.distance for moved in world.vary.thing}
    return distances.get(thing_name(thing), 0.0), 0.0


def _places(thing: Movable, bounds: tuple[float, float], draw: Draw, key: Key) -> Iterator[Movable]:
    """The places that are tried for an object, in order."""
    if not any(bounds):
        yield thing
        return
    distance, angle = bounds
    for attempt in range(MOST_PLACES):
        x, y = (draw.within(distance, *key, axis, attempt) for axis in "xy")
        moved = structs.replace(thing, x=round(thing.x + x, 1), y=round(thing.y + y, 1))
        if isinstance(moved, Start):
            turn = draw.within(angle, *key, "heading", attempt)
            moved = structs.replace(moved, heading=round(wrapped(moved.heading + turn), 1))
        yield moved


def _fits(
    world: WorldDescription, floor: _Floor, allowed: set[object]
) -> Callable[[Movable], bool]:
    east, north = world.floor.size[0] / 2, world.floor.size[1] / 2

    def fits(thing: Movable) -> bool:
        is_inside = abs(thing.x) <= east and abs(thing.y) <= north
        return is_inside and floor.touched(thing) <= allowed

    return fits


def _footprint(thing: Movable) -> pymunk.Shape:
    if not isinstance(thing, Start):
        return footprint(thing)
    body = pymunk.Body(body_type=pymunk.Body.STATIC)
    body.position = (thing.x, thing.y)
    return pymunk.Circle(body, ROOM)


def _overlaps(world: WorldDescription, objects: Mapping[Key, Movable]) -> dict[Key, set[object]]:
    """What each object overlaps in the drawn world, which it may overlap in a variant too."""
    floor = _emptied(world)
    for key, thing in objects.items():
        floor.add(key, thing)
    return {key: floor.touched(thing) for key, thing in objects.items()}


def _emptied(world: WorldDescription) -> _Floor:
    """The floor with its border and its walls only."""
    return _Floor(Physics(structs.replace(world, **dict.fromkeys(LISTS, ()))))


def _no_room(world: WorldDescription, draw: Draw, thing: Movable) -> WorldError:
    message = Phrase(
        "world-no-room-to-vary", world=world.name, variant=draw.variant, name=thing_name(thing)
    )
    return _error(world, "no-room", message)


def _error(world: WorldDescription, code: str, message: Phrase) -> WorldError:
    return WorldError(world.name, [Diagnostic(code, message)])
