"""Checks of a client whose link to the robot fails."""

from time import monotonic

from learnblock.client import Client
from learnblock.devices import Base, Sensor
from learnblock.errors import RobotConnectionError
from learnblock.testing.bench import Bench, BrokenClaimError
from learnblock.testing.device_claims import connects
from learnblock.testing.relay import Fault


def reports_silence(bench: Bench) -> str:
    """Check that a silent link is reported within the timeout."""
    return _reports_loss(bench, Fault.SILENT)


def reports_cut(bench: Bench) -> str:
    """Check that a cut link is reported within the timeout."""
    return _reports_loss(bench, Fault.CUT)


def reports_garbage(bench: Bench) -> str:
    """Check that a link that damages data is reported within the timeout."""
    return _reports_loss(bench, Fault.GARBAGE)


def _reports_loss(bench: Bench, fault: Fault) -> str:
    robot = bench.make()
    try:
        with bench.fault(fault):
            message, took = _wait_for_loss(bench, robot)
            with bench.in_time("stopping"):
                _stop(robot)
    finally:
        _stop(robot)
    connects(bench)
    return f"after {took:.1f} s: {message}"


def _wait_for_loss(bench: Bench, robot: Client) -> tuple[str, float]:
    began = monotonic()
    while monotonic() - began < bench.patience:
        try:
            _use(robot)
        except RobotConnectionError as error:
            return str(error), monotonic() - began
        robot.clock.sleep(0.02)
    raise BrokenClaimError(f"no error was raised for {bench.patience:g} s")


def _use(robot: Client) -> None:
    for _, device in robot.devices():
        if isinstance(device, Sensor):
            device.read()
        elif isinstance(device, Base):
            device.move(10, 0)
    robot.check_link()


def _stop(robot: Client) -> None:
    try:
        robot.stop()
    except RobotConnectionError:
        # Without a link it cannot stop the motors, and reports that.
        return


def handles_slowness(bench: Bench) -> str:
    """Check that a slow link works or is reported."""
    with bench.fault(Fault.SLOW), bench.in_time("connecting", 2 * bench.patience):
        try:
            with bench.robot() as robot:
                _use(robot)
        except RobotConnectionError as error:
            return f"reported: {error}"
    return "works"


def reports_missing_robot(bench: Bench) -> str:
    """Check that a client does not connect to a robot that does not answer."""
    messages = []
    for fault in (Fault.CUT, Fault.SILENT):
        with bench.fault(fault), bench.in_time("reporting the missing robot"):
            try:
                bench.make().stop()
            except RobotConnectionError as error:
                messages.append(str(error))
            else:
                raise BrokenClaimError(f"it connects although the link is {fault.name.lower()}")
    return messages[0]
