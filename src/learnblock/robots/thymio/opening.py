"""Opens the connection chosen in the settings; its library is imported only then."""

from learnblock.errors import RobotConnectionError
from learnblock.robots.real import require
from learnblock.robots.thymio import finding
from learnblock.robots.thymio.link import ThymioLink
from learnblock.robots.thymio.settings import ThymioSettings
from learnblock.robots.thymio.wires import SerialWire, TcpWire, Wire
from learnblock.timing import MONOTONIC, SteadyClock


def open_link(settings: ThymioSettings, clock: SteadyClock = MONOTONIC) -> ThymioLink:
    """Connect to the robot.

    Raises:
        MissingPackageError: a library is not installed.
        RobotConnectionError: the robot cannot be reached.
    """
    connection = finding.choose(settings)
    # The library first: if it is missing, nothing has been opened yet.
    kind = _suite_link() if connection == "suite" else _direct_link()
    return kind(_wire(connection, settings, clock), settings.patience, clock)


def _wire(connection: str, settings: ThymioSettings, clock: SteadyClock) -> Wire:
    if connection == "suite":
        return TcpWire(
            "127.0.0.1", settings.suite_port, settings.patience, "thymio-no-suite", clock
        )
    if connection == "serial":
        return SerialWire(settings.device or _first_device())
    missing = "thymio-not-found" if settings.connection == "auto" else "thymio-no-listener"
    return TcpWire(settings.address, settings.port, settings.patience, missing, clock)


def _first_device() -> str:
    devices = finding.serial_devices()
    if not devices:
        raise RobotConnectionError("thymio-not-plugged-in")
    return devices[0]


def _direct_link() -> type[ThymioLink]:
    require("thymiodirect", "thymio")
    from learnblock.robots.thymio.aseba import AsebaLink  # noqa: PLC0415 - it imports the library

    return AsebaLink


def _suite_link() -> type[ThymioLink]:
    require("tdmclient", "thymio")
    from learnblock.robots.thymio.suite import SuiteLink  # noqa: PLC0415 - as above

    return SuiteLink
