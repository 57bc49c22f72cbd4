"""Goals as seen from above: their regions and their names."""

from collections.abc import Iterator, Mapping
from types import MappingProxyType

from learnblock.simulator.colours import RGB
from learnblock.simulator.geometry import Pose, forward
from learnblock.simulator.goal_description import Follow, Reach, Show, Stop, Tour, Visit
from learnblock.simulator.picture.marks import ObjectName
from learnblock.simulator.picture.palette import GREEN, ORANGE, RED
from learnblock.simulator.picture.svg import Circle, Paint, Point, Polygon, Polyline, Shape
from learnblock.simulator.picture.view import PictureView
from learnblock.simulator.world_description import Tag, WorldDescription

_COLOURS = MappingProxyType({"reached": GREEN, "failed": RED})
Outcomes = Mapping[str, str]
"""What became of goals, by name: "reached" or "failed"; the others are still open."""


def regions(world: WorldDescription, view: PictureView, outcomes: Outcomes) -> Iterator[Shape]:
    """What goals fill, drawn under the lines."""
    for name, place, radius in _discs(world):
        paint = Paint(_colour(name, outcomes), opacity=0.16)
        yield Circle(view.at(*place), radius * view.scale, paint)
    for follow in world.goal.follow:
        yield from _followed(follow, world, view, _colour(follow.name, outcomes))
    for visit in world.goal.visit:
        yield from _visited(visit, world, view, _colour(visit.name, outcomes))
    for tour in world.goal.tour:
        yield from _toured(tour, view, _colour(tour.name, outcomes))


def outlines(world: WorldDescription, view: PictureView, outcomes: Outcomes) -> Iterator[Shape]:
    """The edges of round regions, drawn over the lines, which may fill a region."""
    for name, place, radius in _discs(world):
        ring = Paint(stroke=_colour(name, outcomes), width=2.5, dash=(9.0, 6.0))
        yield Circle(view.at(*place), radius * view.scale, ring)


def names(world: WorldDescription, view: PictureView) -> Iterator[ObjectName]:
    """The names of the goals."""
    for reach in world.goal.reach:
        yield ObjectName(reach.name, view.at(reach.x, reach.y), is_goal=True)
    lines = {line.name: line for line in world.line}
    for follow in world.goal.follow:
        line = lines[follow.line]
        points = line.polyline().points
        x, y = points[len(points) // 2].tolist()
        clear = line.width * view.scale / 2 + 10
        yield ObjectName(follow.name, view.at(x, y), clear, is_goal=True)
    tags = {tag.id: tag for tag in world.tag}
    for visit in world.goal.visit:
        tag = tags[visit.id]
        before = Pose(tag.x, tag.y, tag.heading).ahead(0.55 * visit.distance)
        yield ObjectName(visit.name, view.at(before.x, before.y), is_goal=True)
    for tour in world.goal.tour:
        yield ObjectName(tour.name, view.at(*tour.points[-1]), is_goal=True)
    for stop in world.goal.stop:
        yield ObjectName(stop.name, view.at(stop.x, stop.y), is_goal=True)
    for show in world.goal.show:
        place = (show.x, show.y) if show.radius is not None else _entrance(world)
        yield ObjectName(show.name, view.at(*place), is_goal=True)
    for avoid in world.goal.avoid:
        yield ObjectName(avoid.name, view.at(*_entrance(world)), is_goal=True)


def _entrance(world: WorldDescription) -> Point:
    """The first start, for goals that have no place."""
    return next(((start.x, start.y) for start in world.start), (0.0, 0.0))


def _colour(goal: str, outcomes: Outcomes) -> RGB:
    return _COLOURS.get(outcomes.get(goal, ""), ORANGE)


def _discs(world: WorldDescription) -> Iterator[tuple[str, Point, float]]:
    """The goal's name, the middle and the radius of every round region."""
    regions: list[Reach | Stop | Show] = [*world.goal.reach, *world.goal.stop, *world.goal.show]
    for region in regions:
        if region.radius is not None:
            yield region.name, (region.x, region.y), region.radius
    for tour in world.goal.tour:
        for place in tour.points:
            yield tour.name, place, tour.radius


def _followed(
    goal: Follow, world: WorldDescription, view: PictureView, colour: RGB
) -> Iterator[Shape]:
    """A glow under the line."""
    for line in world.line:
        if line.name == goal.line:
            points = view.all([(float(x), float(y)) for x, y in line.polyline().points])
            yield Polyline(points, colour, line.width * view.scale + 18, 0.22)


def _visited(
    goal: Visit, world: WorldDescription, view: PictureView, colour: RGB
) -> Iterator[Shape]:
    """The half disc in front of the tag within which it is near enough."""
    for tag in world.tag:
        if tag.id == goal.id:
            region = view.all(_half_disc(tag, goal.distance))
            yield Polygon(region, Paint(colour, opacity=0.09))
            yield Polygon(region, Paint(stroke=colour, width=1.6, opacity=0.6, dash=(7, 6)))


def _half_disc(tag: Tag, radius: float) -> list[Point]:
    angles = [tag.heading + 7.5 * k for k in range(-12, 13)]
    units = [forward(angle) for angle in angles]
    return [(tag.x + radius * x, tag.y + radius * y) for x, y in units]


def _toured(goal: Tour, view: PictureView, colour: RGB) -> Iterator[Shape]:
    """A thin line from each place to the next."""
    yield Polyline(view.all(list(goal.points)), colour, 4.0, 0.3)
