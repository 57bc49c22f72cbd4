"""The robots that a project can use."""

from learnblock import robots
from learnblock.errors import LearnBlockError
from learnblock.server.messages import RobotChoice


def robot_choices() -> tuple[RobotChoice, ...]:
    """The available robots."""
    return tuple(map(_robot_choice, robots.entries().values()))


def _robot_choice(entry: robots.RobotEntry) -> RobotChoice:
    if entry.simulated is False:
        # The drivers of real robots are slow to load too.
        return RobotChoice(entry.name, entry.name, simulated=False)
    # The simulator is slow to import, and the server has to respond before that.
    from learnblock.robots.simulated import SimulatedRobot  # noqa: PLC0415

    try:
        robot = entry.load()
        simulated = issubclass(robot, SimulatedRobot)
        title = robot.description().title if issubclass(robot, SimulatedRobot) else entry.name
    except LearnBlockError:
        # It is listed anyway; choosing it reports its error.
        return RobotChoice(entry.name, entry.name, simulated=False)
    return RobotChoice(entry.name, title or entry.name, simulated)
