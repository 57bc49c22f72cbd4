"""The devices of LEGO Education nearby, and which of them are one robot.

A device advertises its kind and the connection card that was held to it: a colour and four digits.
All devices with the card of the Double Motor are one robot.
"""

from collections.abc import Iterable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass

from learnblock.errors import RobotConnectionError, RobotNotFoundError
from learnblock.robots.bluetooth import loopback
from learnblock.robots.bluetooth.finding import reachable
from learnblock.robots.event_loop import EventLoop
from learnblock.robots.legoed.messages import COMPANY, SERVICE, Product
from learnblock.robots.legoed.settings import ABSENT, CARDS, Settings
from learnblock.robots.real import require

#: Seconds for which to look for devices that one connects to.
LOOKING = 4.0
#: Seconds for Bluetooth to begin and to end a look, of those that it may take.
_MARGIN = 1.0
#: The names under which the devices advertise themselves.
NAMES = {
    Product.DOUBLE_MOTOR: "Double Motor",
    Product.COLOUR_SENSOR: "Color Sensor",
    Product.CONTROLLER: "Controller",
    Product.SINGLE_MOTOR: "Single Motor",
}
#: The setting with the address of each other device.
OTHERS = {
    Product.COLOUR_SENSOR: "colour",
    Product.CONTROLLER: "controller",
    Product.SINGLE_MOTOR: "motor",
}


@dataclass(frozen=True, slots=True)
class NearbyDevice:
    """A device that advertises itself.

    Args:
        address: its Bluetooth address.
        product: its kind.
        card: its connection card, such as ``azure 3683``; empty for none.
        strength: how strong its signal is, dBm.
    """

    address: str
    product: int
    card: str
    strength: int


def advertised(
    address: str, manufacturer: Mapping[int, bytes], strength: int = -127
) -> NearbyDevice | None:
    """A device by what it advertises; None if that is not LEGO Education's."""
    data = manufacturer.get(COMPANY, b"")
    if len(data) < 5:
        return None
    colour = CARDS.get(data[2])
    card = f"{colour} {int.from_bytes(data[3:5], 'little'):04}" if colour else ""
    return NearbyDevice(address, int.from_bytes(data[:2], "big"), card, strength)


def scan(settings: Settings, seconds: float) -> Iterator[dict[str, str]]:
    """Yield the settings that reach each robot, emulated ones first."""
    for place in sorted({loopback.HOME, settings.address}):
        if loopback.is_address(place) and _is(place, Product.DOUBLE_MOTOR):
            yield {"address": place}
    with suppress(RobotConnectionError):
        for device in look(seconds):
            if device.product == Product.DOUBLE_MOTOR:
                yield {"card": device.card} if device.card else {"address": device.address}


def look(seconds: float) -> list[NearbyDevice]:
    """The devices that advertise themselves, the strongest signal first.

    Raises:
        RobotConnectionError: this computer's Bluetooth can't be used.
    """
    require("bleak", "legoed")
    with EventLoop("Bluetooth") as loop:
        devices = loop.run(_all(seconds), seconds + _MARGIN)
    return sorted(devices, key=lambda device: -device.strength)


def addresses(settings: Settings) -> dict[Product, str]:
    """The address of each device of a robot.

    Raises:
        RobotNotFoundError: there is no such Double Motor.
        RobotConnectionError: there are several, and the settings choose none; or this computer's
            Bluetooth can't be used.
    """
    if loopback.is_address(settings.address):
        return {Product.DOUBLE_MOTOR: settings.address, **_emulated(settings)}
    devices = look(LOOKING)
    base = _base(settings, devices)
    return {Product.DOUBLE_MOTOR: base.address, **_beside(settings, base, devices)}


def _base(settings: Settings, devices: Iterable[NearbyDevice]) -> NearbyDevice:
    bases = [device for device in devices if device.product == Product.DOUBLE_MOTOR]
    if settings.address:
        wanted = settings.address.casefold()
        bases = [device for device in bases if device.address.casefold() == wanted]
    if settings.card:
        bases = [device for device in bases if device.card == settings.card]
    if not bases:
        choice = settings.address or settings.card
        code = "legoed-other-not-found" if choice else "legoed-not-found"
        raise RobotNotFoundError(code, choice=choice, seconds=LOOKING)
    if len(bases) > 1 and not (settings.address or settings.card):
        raise RobotConnectionError("legoed-several", number=len(bases))
    return bases[0]


def _beside(
    settings: Settings, base: NearbyDevice, devices: Iterable[NearbyDevice]
) -> dict[Product, str]:
    """The other devices: those that the settings name, or else with the same card."""
    places = {}
    # The strongest signal is the last that is noted.
    for device in reversed(list(devices)):
        if device.card == base.card and device.product in OTHERS:
            places[Product(device.product)] = device.address
    return _chosen(settings, places)


def _emulated(settings: Settings) -> dict[Product, str]:
    """The other devices of an emulated robot: at the next ports, if the settings don't say."""
    host, port = loopback.place(settings.address)
    wanted = [product for product, name in OTHERS.items() if not getattr(settings, name)]
    places = {}
    for product in wanted:
        for number in range(port + 1, port + 1 + len(OTHERS)):
            if _is(f"{host}:{number}", product):
                places[product] = f"{host}:{number}"
                break
    return _chosen(settings, places)


def _chosen(settings: Settings, places: Mapping[Product, str]) -> dict[Product, str]:
    chosen = {
        product: getattr(settings, name) or places.get(product, ABSENT)
        for product, name in OTHERS.items()
    }
    return {product: place for product, place in chosen.items() if place != ABSENT}


def _is(place: str, product: Product) -> bool:
    """Whether an emulated device of a kind is somewhere, and free."""
    greeting = loopback.greeting(place)
    return SERVICE in greeting.get("services", {}) and greeting.get("name") == NAMES[product]


async def _all(seconds: float) -> list[NearbyDevice]:
    from bleak import BleakScanner  # noqa: PLC0415 - an add-on

    discovered = await reachable(
        BleakScanner.discover(
            timeout=max(seconds - _MARGIN, seconds / 2), service_uuids=[SERVICE], return_adv=True
        )
    )
    devices = (
        advertised(device.address, seen.manufacturer_data, seen.rssi)
        for device, seen in discovered.values()
    )
    return [device for device in devices if device]
