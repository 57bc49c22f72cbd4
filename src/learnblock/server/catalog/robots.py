"""The robots that a project can use."""

from learnblock import robots
from learnblock.errors import LearnBlockError
from learnblock.server.messages import RobotChoice


def robot_choices() -> tuple[RobotChoice, ...]:
    """The robots there are."""
    return tuple(map(_robot_choice, robots.entries().values()))


def _robot_choice(entry: robots.RobotEntry) -> RobotChoice:
    if entry.simulated is False:
        # The drivers of real robots take their time to be loaded as well.
        return RobotChoice(entry.name, entry.name, simulated=False)
    # The simulator takes its time to be imported, and the server answers before it is.
    from learnblock.robots.simulated import SimulatedRobot  # noqa: PLC0415

    try:
        robot = entry.load()
        simulated = issubclass(robot, SimulatedRobot)
        title = robot.description().title if issubclass(robot, SimulatedRobot) else entry.name
    except LearnBlockError:
        # It is in the list all the same: choosing it says what is wrong with it.
        return RobotChoice(entry.name, entry.name, simulated=False)
    return RobotChoice(entry.name, title or entry.name, simulated)
