"""The robots that a project can use, and those that can run its program."""

from functools import cache
from typing import TYPE_CHECKING

from msgspec import structs

from learnblock import robots, running
from learnblock.blocks import builtin
from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase
from learnblock.language.check.robots import Verdict as Found
from learnblock.project.document.document import Document
from learnblock.robots.settings import given_names
from learnblock.senses import SENSES, served_by
from learnblock.server.messages import RobotChoice, RunsOn, Verdict

if TYPE_CHECKING:
    from learnblock.client import Client


def robot_choices() -> tuple[RobotChoice, ...]:
    """The available robots."""
    names = given_names()
    choices = map(_robot_choice, robots.entries().values())
    return tuple(
        structs.replace(
            choice, given=names.get(choice.name, ""), ours=robots.is_built_in(choice.name)
        )
        for choice in choices
    )


def _robot_choice(entry: robots.RobotEntry) -> RobotChoice:
    if entry.simulated is False:
        # The drivers of real robots are slow to load too.
        # What the twin has; only robots in a world have a pen.
        twin = _twin(entry)
        lacks = tuple(sorted({*_lacks(twin), "Pen"})) if twin else ()
        serves = _serves(twin) if twin else {}
        return RobotChoice(entry.name, entry.name, simulated=False, lacks=lacks, serves=serves)
    # The simulator is slow to import, and the server has to respond before that.
    from learnblock.robots.simulated import SimulatedRobot  # noqa: PLC0415

    try:
        robot = entry.load()
        simulated = issubclass(robot, SimulatedRobot)
        title = _title(robot if simulated else _twin_class(entry))
    except LearnBlockError:
        # It is listed anyway; choosing it reports its error.
        return RobotChoice(entry.name, entry.name, simulated=False)
    return RobotChoice(entry.name, title or entry.name, simulated, _lacks(entry), _serves(entry))


def _twin(entry: robots.RobotEntry) -> robots.RobotEntry | None:
    return robots.entries().get(f"sim-{entry.name}")


def _twin_class(entry: robots.RobotEntry) -> "type[Client] | None":
    twin = _twin(entry)
    return twin.load() if twin else None


def _title(robot: "type[Client] | None") -> str:
    """A twin's title, which is also that of its robot; empty if there is none."""
    from learnblock.robots.simulated import SimulatedRobot  # noqa: PLC0415

    if robot is None or not issubclass(robot, SimulatedRobot):
        return ""
    return robot.description().title


def _lacks(entry: robots.RobotEntry) -> tuple[str, ...]:
    """What blocks need and the robot can't serve; nothing if its devices are unknown."""
    equipment = _equipment(entry)
    if equipment is None:
        return ()
    return tuple(need for need in _needs() if served_by(need, equipment) is None)


def _serves(entry: robots.RobotEntry) -> dict[str, str]:
    """What serves each sense that the robot has; nothing if its devices are unknown."""
    equipment = _equipment(entry)
    if equipment is None:
        return {}
    ways = ((sense, served_by(sense, equipment)) for sense in SENSES)
    return {sense: way for sense, way in ways if way}


def _equipment(entry: robots.RobotEntry) -> frozenset[str] | None:
    try:
        return entry.load().known_equipment()
    except LearnBlockError:
        return None


@cache
def _needs() -> tuple[str, ...]:
    """Every need of the built-in blocks."""
    needs = (need for block in builtin().values() for need in block.needed())
    return tuple(sorted(set(needs)))


def runs_on(document: Document) -> RunsOn:
    """For each robot, whether it can run the program, and what it lacks."""
    verdicts = running.verdicts(document.block_tree, document.target.configurations)
    return RunsOn(tuple(_verdict(robot, verdict) for robot, verdict in verdicts.items()))


def _verdict(robot: str, verdict: Found | Phrase) -> Verdict:
    if isinstance(verdict, Phrase):
        return Verdict(robot, "unknown", verdict)
    if verdict.refused:
        return Verdict(robot, "refused", verdict.phrase)
    return Verdict(robot, "without" if verdict.missed else "runs", verdict.phrase)
