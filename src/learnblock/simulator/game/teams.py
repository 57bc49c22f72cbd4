"""The teams of a world: which robot plays for which, and the check of their file."""

from collections.abc import Iterable, Iterator, Mapping

from learnblock.errors import UnknownNameError
from learnblock.i18n import Phrase
from learnblock.simulator.world_description import WorldFile
from learnblock.storage.toml_source import FileMistake


class Teams:
    """The teams of a world; a robot plays for the team of the start that it takes.

    Args:
        world: the content of its file.
    """

    def __init__(self, world: WorldFile) -> None:
        self._starts = tuple(start.name for start in world.start)
        self._teams = {start: team.name for team in world.team for start in team.robots}
        self._robots: dict[str, str] = {}

    def __bool__(self) -> bool:
        return bool(self._teams)

    def add(self, robot: str, start: str | None) -> None:
        """Add the next robot of the world, which takes a start; None for the next start."""
        number = len(self._robots)
        if start is None and number < len(self._starts):
            start = self._starts[number]
        self._robots[robot] = self._teams.get(start or "", "")

    @property
    def robots(self) -> Mapping[str, str]:
        """The team of each robot; "" for a robot without one."""
        return self._robots


def teams_of(world: WorldFile, robots: Iterable[str]) -> Mapping[str, str]:
    """The team of each robot, if they take the starts in their order; "" for none."""
    teams = Teams(world)
    for robot in robots:
        teams.add(robot, None)
    return teams.robots


def check_teams(world: WorldFile) -> Iterator[FileMistake]:
    """Report robots and teams that do not exist, and robots in two teams."""
    starts = [start.name for start in world.start]
    teams: dict[str, str] = {}
    for index, team in enumerate(world.team):
        for place, robot in enumerate(team.robots):
            path = ("team", index, "robots", place)
            if robot not in starts:
                message = UnknownNameError("start-pose", robot, starts).phrase
                yield FileMistake(path, "unknown-start", message)
            elif robot in teams:
                yield FileMistake(path, "robot-taken", _taken(robot, team.name, teams[robot]))
            teams.setdefault(robot, team.name)
    names = [team.name for team in world.team]
    for kind, index, goal in world.goal.all():
        if goal.team is not None and goal.team not in names:
            message = UnknownNameError("team", goal.team, names).phrase
            yield FileMistake(("goal", kind, index, "team"), "unknown-team", message)


def _taken(robot: str, team: str, other: str) -> Phrase:
    """What to say about a robot that is in a team, and in another one or twice in the same."""
    if team == other:
        return Phrase("world-robot-twice", robot=robot, team=team)
    return Phrase("world-robot-in-two-teams", robot=robot, team=team, other=other)
