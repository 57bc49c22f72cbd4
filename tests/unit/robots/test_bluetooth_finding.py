"""Looking for a robot over Bluetooth, with a scanner that sees what a test says."""

import asyncio
from types import SimpleNamespace

import bleak
import pytest

from learnblock.errors import RobotNotFoundError
from learnblock.robots.bluetooth import finding

SERVICE = "c5f50001-8280-46da-89f4-6d8051e4aeef"
#: Two hubs and a headset, and how strong each is.
NEARBY = {
    address: SimpleNamespace(
        local_name=name, service_uuids=services, rssi=signal, manufacturer_data={}
    )
    for address, name, services, signal in [
        ("AA", "Hub 1", [SERVICE], -71),
        ("BB", "Hub 2", [SERVICE], -48),
        ("CC", "Headset", [], -30),
    ]
}


@pytest.fixture(autouse=True)
def scanner(monkeypatch):
    async def find(is_it, timeout):
        assert timeout == finding.LOOKING
        devices = (
            (SimpleNamespace(address=address, details=None), seen)
            for address, seen in NEARBY.items()
        )
        return next((device for device, seen in devices if is_it(device, seen)), None)

    monkeypatch.setattr(bleak.BleakScanner, "find_device_by_filter", find)


@pytest.mark.parametrize(
    ("asked", "address", "signal"),
    [("", "AA", -71), ("hub 2", "BB", -48), ("bb", "BB", -48), ("CC", "CC", -30)],
)
def test_a_robot_comes_with_the_strength_of_its_signal(asked, address, signal):
    device, strength = asyncio.run(finding.find("spike", asked, SERVICE))
    assert (device.address, strength) == (address, signal)


def test_a_robot_that_is_not_there_is_named():
    with pytest.raises(RobotNotFoundError) as refusal:
        asyncio.run(finding.find("spike", "Hub 9", SERVICE))
    assert refusal.value.phrase.values["address"] == "Hub 9"
