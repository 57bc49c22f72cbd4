"""The monitor that fits a robot."""

from learnblock.client import Client
from learnblock.devices import Pose
from learnblock.monitor.client_monitor import ClientMonitor
from learnblock.monitor.monitor import Monitor
from learnblock.robots import RobotEntry


def make_monitor(entry: RobotEntry, world: str | None = None, start: Pose | None = None) -> Monitor:
    """The monitor of a robot while no program runs on it.

    Args:
        entry: the robot.
        world: for a simulated robot, the name of a world or the path of its file; or None.
        start: (x mm, y mm, heading in degrees) for a simulated robot.

    Raises:
        LearnBlockError: the robot cannot be loaded, there is no such world, or it has no room.
    """
    robot = entry.load()
    if not robot.lockstep:
        return ClientMonitor(robot)
    # The simulator is slow to load.
    from learnblock.monitor.world_monitor import make_world_monitor  # noqa: PLC0415
    from learnblock.robots.simulated import SimulatedRobot  # noqa: PLC0415

    assert issubclass(robot, SimulatedRobot)  # noqa: S101 - only these run in lock-step
    return make_world_monitor(robot, world, start)


def monitor_of(client: Client) -> Monitor:
    """The monitor of a program's robot; created before the recorder of its trace."""
    if not client.lockstep:
        return ClientMonitor(type(client), client)
    from learnblock.monitor.world_monitor import WorldMonitor  # noqa: PLC0415 - as above
    from learnblock.robots.simulated import SimulatedRobot  # noqa: PLC0415

    assert isinstance(client, SimulatedRobot)  # noqa: S101 - only these run in lock-step
    return WorldMonitor.of(client)
