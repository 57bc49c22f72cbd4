"""Looks for robots over Bluetooth Low Energy, and says why it can't."""

from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from typing import TYPE_CHECKING, Any

from learnblock.errors import RobotConnectionError, RobotNotFoundError
from learnblock.robots.bluetooth import loopback
from learnblock.robots.event_loop import EventLoop
from learnblock.robots.real import require

if TYPE_CHECKING:
    from bleak.backends.device import BLEDevice
    from bleak.backends.scanner import AdvertisementData

#: Seconds for which to look for a robot that one connects to; most advertise once a second.
LOOKING = 8.0
#: Seconds for Bluetooth to begin and to end a look, of those that it may take.
_MARGIN = 1.0

#: How Linux's paths of robots begin.
_BLUEZ = "/org/bluez/"

#: Whether a robot is of the right kind, by the data of its manufacturer in what it advertises.
Fits = Callable[[Mapping[int, bytes]], bool]


def fits_all(_: Mapping[int, bytes]) -> bool:
    """Whether it is of the right kind: every robot with the service is."""
    return True


def scan(
    robot: str, address: str, service: str, seconds: float, fits: Fits = fits_all
) -> Iterator[dict[str, str]]:
    """Yield the settings that reach each robot with a service, emulated ones first.

    Without Bluetooth, nothing is found; the error of connecting says why.

    Args:
        robot: the robot's id, such as ``spike``.
        address: the one in its settings, where another robot may be emulated.
        service: the UUID that such robots advertise.
        seconds: the time limit.
        fits: leaves out robots of another kind with the same service.
    """
    for place in sorted({loopback.HOME, address}):
        greeting = loopback.greeting(place) if loopback.is_address(place) else {}
        advertised = loopback.advertised(greeting, service)
        if advertised is not None and fits(advertised):
            yield {"address": place}
    require("bleak", robot)
    with EventLoop("Bluetooth") as loop, suppress(RobotConnectionError):
        devices = loop.run(_all(service, seconds, fits), seconds)
        yield from ({"address": device.address} for device in devices)


async def find(
    robot: str, address: str, service: str, fits: Fits = fits_all
) -> tuple["BLEDevice", int | None]:
    """The robot with an address or a name, or the first one that fits, and its signal.

    The signal is in dBm; a system tells it only until the robot is connected.

    Raises:
        RobotNotFoundError: there is none.
        RobotConnectionError: this computer's Bluetooth can't be used.
    """
    bleak = require("bleak", robot)
    signals: dict[str, int] = {}

    def is_it(device: "BLEDevice", seen: "AdvertisementData") -> bool:
        signals[device.address] = seen.rssi
        if address:
            return address.casefold() in {
                device.address.casefold(),
                (seen.local_name or "").casefold(),
            }
        return service in seen.service_uuids and fits(seen.manufacturer_data)

    device: BLEDevice | None = await reachable(
        bleak.BleakScanner.find_device_by_filter(is_it, timeout=LOOKING)
    )
    if device is None:
        code = "bluetooth-other-not-found" if address else "bluetooth-not-found"
        raise RobotNotFoundError(code, robot=robot, address=address, seconds=LOOKING)
    return device, signals.get(device.address)


def place(device: "BLEDevice") -> str:
    """Where `known` finds a robot again, even while this computer is connected to it.

    A connected robot does not advertise; on Linux, Bluetooth's service has a path for it.
    """
    details = device.details
    return str(details["path"]) if isinstance(details, dict) else device.address


def known(place: str) -> "BLEDevice | None":
    """The robot at a path of Linux's Bluetooth service; None if it is none."""
    if not place.startswith(_BLUEZ):
        return None
    from bleak.backends.device import BLEDevice  # noqa: PLC0415 - an add-on

    return BLEDevice(place, None, {"path": place, "props": {}})


async def reachable(awaitable: Any) -> Any:
    """The result of what uses this computer's Bluetooth.

    Raises:
        RobotConnectionError: it can't be used; the error says why.
    """
    from bleak.exc import BleakBluetoothNotAvailableError  # noqa: PLC0415 - an add-on
    from bleak.exc import BleakBluetoothNotAvailableReason as Reason  # noqa: PLC0415 - as above

    denied = {Reason.DENIED_BY_USER, Reason.DENIED_BY_SYSTEM, Reason.DENIED_BY_UNKNOWN}
    try:
        return await awaitable
    except BleakBluetoothNotAvailableError as error:
        if error.reason in denied:
            raise RobotConnectionError("bluetooth-denied") from error
        code = "bluetooth-off" if error.reason is Reason.POWERED_OFF else "bluetooth-none"
        raise RobotConnectionError(code) from error
    except FileNotFoundError as error:
        # On Linux, the service that bleak speaks with is missing.
        raise RobotConnectionError("bluetooth-none") from error


async def _all(service: str, seconds: float, fits: Fits) -> list["BLEDevice"]:
    from bleak import BleakScanner  # noqa: PLC0415 - an add-on

    looking = BleakScanner.discover(
        timeout=max(seconds - _MARGIN, seconds / 2), return_adv=True, service_uuids=[service]
    )
    devices: dict[str, tuple[BLEDevice, AdvertisementData]] = await reachable(looking)
    return [device for device, seen in devices.values() if fits(seen.manufacturer_data)]
