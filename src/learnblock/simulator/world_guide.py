"""What the gallery says about a world: what one does there, for how many robots, what they need.

All of it follows from what the world contains. Its file may choose another group, which has to fit.
"""

from learnblock.simulator.colours import ColourName, rgb
from learnblock.simulator.description_types import Group
from learnblock.simulator.goal_description import AnyGoal
from learnblock.simulator.world_description import WorldFile

#: The groups that follow from a world's content; the first that fits is the world's.
_ORDER: tuple[Group, ...] = ("several", "faces", "tags", "lines", "obstacles", "drive", "empty")
#: The lines that robots have skills for.
_LINES: tuple[ColourName, ...] = ("black", "red", "blue")


def robots_for(world: WorldFile) -> int:
    """How many robots a world is for."""
    needs_others = any(goal.together or goal.alone or goal.robot for goal in world.goal.reach)
    # Some worlds for one robot have a place for a second one.
    return len(world.start) if needs_others or world.team or len(world.start) > 2 else 1


def group_of(world: WorldFile) -> Group:
    """What one does in a world."""
    if world.group is not None:
        return world.group
    if world.game is not None:
        return "games"
    return next(group for group in _ORDER if offers(world, group))


def offers(world: WorldFile, group: Group) -> bool:
    """Whether a world has what a group is about.

    >>> offers(WorldFile(), "empty"), offers(WorldFile(), "lines")
    (True, False)
    """
    goals, things = world.goal, (*world.wall, *world.box, *world.cylinder)
    has = {
        "several": robots_for(world) > 1,
        "faces": bool(world.face) or (not world.tag and _all_show(world)),
        "tags": bool(world.tag),
        "lines": bool(goals.follow),
        "obstacles": bool(things or goals.avoid),
        "drive": any(goals.all()),
        "games": any(goals.all()),
    }
    return has.get(group, True)


def needs_of(world: WorldFile) -> tuple[str, ...]:
    """What a robot needs to reach the goals, in the words of `learnblock.senses`."""
    needs = set()
    if world.tag or world.face:
        needs.add("Camera")
    if world.face:
        needs.add("Camera:emotions")
    if world.goal.show:
        needs.add("Display")
    for goal in world.goal.follow:
        needs.update(f"{colour}-line" for colour in _LINES if _is(world, goal.line, colour))
    return tuple(sorted(needs))


def _all_show(world: WorldFile) -> bool:
    goals: list[AnyGoal] = [goal for _, _, goal in world.goal.all()]
    return bool(goals) and len(goals) == len(world.goal.show)


def _is(world: WorldFile, name: str, colour: ColourName) -> bool:
    """Whether the line with a name has a colour."""
    return any(line.name == name and rgb(line.colour) == rgb(colour) for line in world.line)
