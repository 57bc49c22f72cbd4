import copy
import math

import pymunk
import pytest

from learnblock.simulator import chipmunk


@pytest.fixture
def space() -> pymunk.Space:
    """A disc before a wall, which turns and drives towards it."""
    space = pymunk.Space()
    body = pymunk.Body(1.0, 100.0)
    body.velocity, body.angular_velocity = (300.0, 20.0), 0.7
    disc = pymunk.Circle(body, 20.0)
    disc.filter = pymunk.ShapeFilter(group=1)
    space.add(body, disc, pymunk.Segment(space.static_body, (100, -80), (90, 80), 2.0))
    return space


def test_steps_give_the_same_motion_to_the_last_bit(space: pymunk.Space) -> None:
    usual_space = copy.deepcopy(space)
    (body,), (usual,) = space.bodies, usual_space.bodies
    for _ in range(100):
        chipmunk.advance(space, 0.01)
        usual_space.step(0.01)
        assert chipmunk.position_of(body) == usual.position
        assert chipmunk.angle_of(body) == usual.angle


def test_a_velocity_is_set_as_by_pymunk(space: pymunk.Space) -> None:
    (body,) = space.bodies
    chipmunk.set_velocity(body, (1.5, -2.5))
    chipmunk.set_rotation(body, 0.25)
    assert (body.velocity, body.angular_velocity) == ((1.5, -2.5), 0.25)


def test_a_ray_ends_where_pymunk_says(space: pymunk.Space) -> None:
    looker = pymunk.ShapeFilter(group=1)
    ends = [(200 * math.cos(angle), 200 * math.sin(angle)) for angle in range(60)]
    hits = [space.segment_query_first((0, 0), end, 0.0, looker) for end in ends]
    free = [chipmunk.free_part(space, (0, 0), end, looker) for end in ends]
    assert free == [hit and hit.alpha for hit in hits]
    assert {part is None for part in free} == {True, False}
