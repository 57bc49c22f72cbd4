"""The check of a world's file for mistakes that the types of its values accept."""

import math
from collections import Counter
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from learnblock.errors import UnknownNameError
from learnblock.i18n import Phrase
from learnblock.simulator.game.checks import THINGS, check_game
from learnblock.simulator.game.teams import check_teams
from learnblock.simulator.world_description import Box, Cylinder, Face, Tag, WorldFile, thing_name
from learnblock.simulator.world_guide import offers
from learnblock.storage.struct_types import KeyPath
from learnblock.storage.toml_source import FileMistake

if TYPE_CHECKING:
    from learnblock.simulator.polyline import Polyline

CLOSING_GAP = 5.0
"""The gap in mm between the end and the start of a closed line that is a rounding error."""
MAXIMUM_PICTURE_MEGABYTES = 10
MAXIMUM_PICTURE_SIDE = 4096
"""The limit in pixels."""


def check_world(world: WorldFile, folder: Path) -> Iterator[FileMistake]:
    """Find the mistakes in a world whose floor picture is in `folder`."""
    yield from _check_lines(world)
    yield from _check_places(world)
    yield from _check_names(world)
    yield from _check_goals(world)
    yield from _check_vary(world)
    yield from check_game(world)
    yield from check_teams(world)
    yield from _check_group(world)
    if world.floor.picture is not None:
        yield from _check_picture(folder, world.floor.picture)


def _check_lines(world: WorldFile) -> Iterator[FileMistake]:
    for index, line in enumerate(world.line):
        middle = line.polyline()
        if line.path and line.closed and not _is_closed(middle):
            (x, y), (start_x, start_y) = middle.points[-1], middle.points[0]
            message = Phrase(
                "world-line-open",
                name=line.name,
                start_x=f"{start_x:g}",
                start_y=f"{start_y:g}",
                x=f"{x:.0f}",
                y=f"{y:.0f}",
            )
            yield FileMistake(("line", index), "wrong-value", message)


def _is_closed(line: "Polyline") -> bool:
    (start_x, start_y), (end_x, end_y) = line.points[0], line.points[-1]
    return math.hypot(end_x - start_x, end_y - start_y) <= CLOSING_GAP


def _check_places(world: WorldFile) -> Iterator[FileMistake]:
    """Report objects outside the floor."""
    east, north = world.floor.size[0] / 2, world.floor.size[1] / 2
    for key in ("box", "cylinder", "tag", "face", "light", "start", *THINGS):
        for index, thing in enumerate(getattr(world, key)):
            if abs(thing.x) > east or abs(thing.y) > north:
                message = Phrase(
                    "world-off-floor",
                    place=f"{key}[{index + 1}]",
                    x=f"{thing.x:g}",
                    y=f"{thing.y:g}",
                    west=f"{-east:g}",
                    east=f"{east:g}",
                    south=f"{-north:g}",
                    north=f"{north:g}",
                )
                yield FileMistake((key, index), "off-the-floor", message)


def _check_names(world: WorldFile) -> Iterator[FileMistake]:
    """Report duplicate names: lines, starts, teams and goals are identified by name."""
    groups: tuple[list[KeyPath], ...] = (
        [("line", i) for i in range(len(world.line))],
        [("start", i) for i in range(len(world.start))],
        [("team", i) for i in range(len(world.team))],
        [("goal", kind, i) for kind, i, _ in world.goal.all()],
    )
    names = (
        [line.name for line in world.line],
        [start.name for start in world.start],
        [team.name for team in world.team],
        [goal.name for _, _, goal in world.goal.all()],
    )
    for paths, path_names in zip(groups, names, strict=True):
        seen: Counter[str] = Counter()
        for path, name in zip(paths, path_names, strict=True):
            seen[name] += 1
            if seen[name] == 2:
                message = Phrase("world-name-taken", group=str(path[0]), name=name)
                yield FileMistake((*path, "name"), "name-taken", message)


def _check_group(world: WorldFile) -> Iterator[FileMistake]:
    """Report a group that promises what is not in the world."""
    if world.group is not None and not offers(world, world.group):
        message = Phrase("world-group-missing", group=world.group)
        yield FileMistake(("group",), "wrong-value", message)


def _check_vary(world: WorldFile) -> Iterator[FileMistake]:
    """Report names of objects that do not exist."""
    things: list[Box | Cylinder | Tag | Face] = [
        *world.box,
        *world.cylinder,
        *world.tag,
        *world.face,
    ]
    names = list(dict.fromkeys(map(thing_name, things)))
    for index, moved in enumerate(world.vary.thing if world.vary else ()):
        if moved.name not in names:
            message = UnknownNameError("thing", moved.name, names).phrase
            yield FileMistake(("vary", "thing", index, "name"), "unknown-thing", message)


def _check_goals(world: WorldFile) -> Iterator[FileMistake]:
    lines = [line.name for line in world.line]
    for index, follow in enumerate(world.goal.follow):
        if follow.line not in lines:
            message = UnknownNameError("line", follow.line, lines).phrase
            yield FileMistake(("goal", "follow", index, "line"), "unknown-line", message)
    things: tuple[Box | Cylinder, ...] = (*world.box, *world.cylinder)
    light = [thing.name for thing in things if thing.mass is not None]
    for index, reach in enumerate(world.goal.reach):
        if reach.object is not None and reach.object not in light:
            message = UnknownNameError("light-object", reach.object, light).phrase
            yield FileMistake(("goal", "reach", index, "object"), "unknown-object", message)
    tags = [tag.id for tag in world.tag]
    for index, visit in enumerate(world.goal.visit):
        if visit.id not in tags:
            message = UnknownNameError("tag", str(visit.id), map(str, tags)).phrase
            yield FileMistake(("goal", "visit", index, "id"), "unknown-tag", message)
    yield from _check_order(world)


def _check_order(world: WorldFile) -> Iterator[FileMistake]:
    """Report goals after goals that do not exist, and those that wait for each other."""
    after = {goal.name: goal.after for _, _, goal in world.goal.all()}
    for kind, index, goal in world.goal.all():
        path = ("goal", kind, index, "after")
        if goal.after is not None and goal.after not in after:
            others = [name for name in after if name != goal.name]
            message = UnknownNameError("goal", goal.after, others).phrase
            yield FileMistake(path, "unknown-goal", message)
        elif goal.name in _before(goal.after, after):
            message = Phrase("world-goal-circle", name=goal.name, after=str(goal.after))
            yield FileMistake(path, "goal-circle", message)


def _before(name: str | None, after: Mapping[str, str | None]) -> set[str]:
    """A goal and all goals that have to be reached before it."""
    names: set[str] = set()
    while name is not None and name not in names:
        names.add(name)
        name = after.get(name)
    return names


def _check_picture(folder: Path, picture: str) -> Iterator[FileMistake]:
    problem = _picture_problem(folder, picture)
    if problem:
        yield FileMistake(("floor", "picture"), "wrong-picture", problem)


def _picture_problem(folder: Path, picture: str) -> Phrase | None:
    # No file name contains a NUL, and even checking for such a file is an error.
    file = (folder / picture.partition("\0")[0]).resolve()
    if "\0" in picture or not file.is_relative_to(folder.resolve()):
        return Phrase("world-picture-outside", picture=picture)
    if not file.is_file():
        return Phrase("world-picture-missing", picture=picture)
    limit = MAXIMUM_PICTURE_MEGABYTES
    if file.stat().st_size > limit * 1_000_000:
        return Phrase("world-picture-too-large", picture=picture, limit=limit)
    width, height = _png_size(file)
    if min(width, height) == 0:
        return Phrase("world-picture-not-png", picture=picture)
    limit = MAXIMUM_PICTURE_SIDE
    if max(width, height) > limit:
        return Phrase(
            "world-picture-too-many-pixels",
            picture=picture,
            width=width,
            height=height,
            limit=limit,
        )
    return None


def _png_size(file: Path) -> tuple[int, int]:
    """Width and height from the header (PNG specification, 11.2.2); (0, 0) if it is not PNG.

    The header is parsed by hand, so that a picture is never unpacked before its size is known.
    """
    with file.open("rb") as stream:
        header = stream.read(24)
    if len(header) < 24 or header[:8] != b"\x89PNG\r\n\x1a\n" or header[12:16] != b"IHDR":
        return 0, 0
    return int.from_bytes(header[16:20], "big"), int.from_bytes(header[20:24], "big")
