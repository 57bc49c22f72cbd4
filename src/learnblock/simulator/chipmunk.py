"""The calls that a world makes at each step, straight to Chipmunk, the library under pymunk.

Chipmunk's own body or space is looked up each time, because that of a copied world is another one.
"""

from collections.abc import Callable
from typing import Any

import pymunk
from pymunk._chipmunk_cffi import ffi, lib

from learnblock.simulator.geometry import Point

# Why: docs/decisions.md, "Steps and rays call pymunk's library directly"
_step: Callable[[Any, float], None] = lib.cpSpaceStep
_angle: Callable[[Any], float] = lib.cpBodyGetAngle
_position: Callable[[Any], Any] = lib.cpBodyGetPosition
_set_velocity: Callable[[Any, Point], None] = lib.cpBodySetVelocity
_set_rotation: Callable[[Any, float], None] = lib.cpBodySetAngularVelocity
_first_hit: Callable[..., Any] = lib.cpSpaceSegmentQueryFirst
_new: Callable[[str], Any] = ffi.new


def advance(space: pymunk.Space, seconds: float) -> None:
    """As `space.step`, where no callback adds or removes anything."""
    _step(space._space, seconds)  # noqa: SLF001 - see above


def angle_of(body: pymunk.Body) -> float:
    """As `body.angle`."""
    return _angle(body._body)  # noqa: SLF001 - see above


def position_of(body: pymunk.Body) -> Point:
    """As `body.position`."""
    place = _position(body._body)  # noqa: SLF001 - see above
    return place.x, place.y


def set_velocity(body: pymunk.Body, velocity: Point) -> None:
    """As `body.velocity = velocity`."""
    _set_velocity(body._body, velocity)  # noqa: SLF001 - see above


def set_rotation(body: pymunk.Body, speed: float) -> None:
    """As `body.angular_velocity = speed`."""
    _set_rotation(body._body, speed)  # noqa: SLF001 - see above


def free_part(
    space: pymunk.Space, start: Point, end: Point, looker: pymunk.ShapeFilter
) -> float | None:
    """The `alpha` of `space.segment_query_first` for a thin ray; None if it hits nothing."""
    # Not kept: two threads may look at the same time.
    hit = _new("cpSegmentQueryInfo *")
    if _first_hit(space._space, start, end, 0.0, looker, hit):  # noqa: SLF001 - see above
        alpha: float = hit.alpha
        return alpha
    return None
