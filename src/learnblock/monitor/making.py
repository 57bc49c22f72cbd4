"""The monitor that fits a robot."""

from collections.abc import Mapping, Sequence

from learnblock.client import Client
from learnblock.devices import Pose
from learnblock.monitor.client_monitor import ClientMonitor
from learnblock.monitor.monitor import Monitor
from learnblock.robots import RobotEntry


def make_monitor(
    entry: RobotEntry, world: str | None = None, start: Pose | None = None, *, variant: int = 0
) -> Monitor:
    """The monitor of a robot while no program runs on it.

    Args:
        entry: the robot.
        world: for a simulated robot, the name of a world or the path of its file; or None.
        start: (x mm, y mm, heading in degrees) for a simulated robot.
        variant: the number of the world's variant; 0 is the world as it is drawn.

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
    return make_world_monitor(robot, world, start, variant)


def make_monitors(
    entries: Mapping[str, RobotEntry], world: str, variant: int = 0
) -> Sequence[Monitor]:
    """The monitors of several robots while no program runs; simulated ones share a world.

    Args:
        entries: the kinds of robots, by name.
        world: the name of a world or the path of its file.
        variant: the number of the world's variant.

    Raises:
        LearnBlockError: a robot cannot be loaded, there is no such world, or it has no room.
    """
    # As above.
    from learnblock.monitor.world_monitor import WorldMonitor  # noqa: PLC0415
    from learnblock.robots.simulated import SimulatedRobot, Simulation  # noqa: PLC0415

    shared: Simulation | None = None
    monitors: list[Monitor] = []
    for name, entry in entries.items():
        robot = entry.load()
        if not issubclass(robot, SimulatedRobot):
            monitors.append(ClientMonitor(robot))
            continue
        shared = shared or robot.make_simulation(world=world, variant=variant)
        shared.world.add_robot(robot.description(), name)
        monitors.append(WorldMonitor(shared, name=name))
    return monitors


def monitor_of(client: Client) -> Monitor:
    """The monitor of a program's robot; created before the recorder of its trace."""
    if not client.lockstep:
        return ClientMonitor(type(client), client)
    from learnblock.monitor.world_monitor import WorldMonitor  # noqa: PLC0415 - as above
    from learnblock.robots.simulated import SimulatedRobot  # noqa: PLC0415

    assert isinstance(client, SimulatedRobot)  # noqa: S101 - only these run in lock-step
    return WorldMonitor.of(client)
