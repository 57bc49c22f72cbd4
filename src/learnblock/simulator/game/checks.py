"""The check of the things of games in a world's file."""

from collections.abc import Iterator

from learnblock.errors import UnknownNameError
from learnblock.i18n import Phrase
from learnblock.scores import ANYTHING
from learnblock.simulator.world_description import Box, Cylinder, WorldFile
from learnblock.storage.toml_source import FileMistake

#: The tables of a world's file with things of games.
THINGS = ("collectable", "zone", "gate", "mover", "door", "switch")


def check_game(world: WorldFile) -> Iterator[FileMistake]:
    """Report doors and objects that do not exist, and goals without what they need."""
    doors = list(dict.fromkeys(door.name for door in world.door))
    for index, switch in enumerate(world.switch):
        if switch.door not in doors:
            message = UnknownNameError("door", switch.door, doors).phrase
            yield FileMistake(("switch", index, "door"), "unknown-door", message)
    things: tuple[Box | Cylinder, ...] = (*world.box, *world.cylinder)
    light = [thing.name for thing in things if thing.mass is not None]
    for index, zone in enumerate(world.zone):
        if zone.object is not None and zone.object not in light:
            message = UnknownNameError("light-object", zone.object, light).phrase
            yield FileMistake(("zone", index, "object"), "unknown-object", message)
    yield from _check_goals(world)


def _check_goals(world: WorldFile) -> Iterator[FileMistake]:
    kinds = {thing.kind for thing in world.collectable}
    for index, collect in enumerate(world.goal.collect):
        if not kinds if collect.kind == ANYTHING else collect.kind not in kinds:
            message = Phrase("world-nothing-to-collect", name=collect.name, kind=collect.kind)
            yield FileMistake(("goal", "collect", index, "kind"), "nothing-to-collect", message)
    for index, gates in enumerate(world.goal.gates):
        if not world.gate:
            message = Phrase("world-no-gates", name=gates.name)
            yield FileMistake(("goal", "gates", index), "no-gates", message)
