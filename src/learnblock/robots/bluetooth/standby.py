"""Stops a robot for a guardian, by the connection that this computer already has to it."""

from collections.abc import Callable
from contextlib import suppress

from learnblock.errors import LearnBlockError
from learnblock.robots.bluetooth.radio import Radio


# Why: docs/decisions.md, "A guardian shares the Bluetooth connection of the program that it guards"
def standby(
    robot: str, place: str, characteristic: str, value: bytes, seconds: float
) -> Callable[[], None]:
    """What writes a value at once, even if the program that is connected is gone or frozen.

    To load bleak and to connect takes longer than a robot may drive on, so both are done before, as
    far as the system allows; if not, they are tried when the value is to be written.

    Args:
        robot: the robot's id.
        place: the `Radio.address` of the program that is connected.
        characteristic: where to write.
        value: what to write.
        seconds: the time limit of each step.
    """

    def connected() -> Radio:
        return Radio(robot, place, "", seconds=seconds, shares=True)

    radio: Radio | None = None
    with suppress(LearnBlockError):
        radio = connected()

    def write() -> None:
        nonlocal radio
        try:
            radio = radio or connected()
            radio.write(characteristic, value, seconds)
        except LearnBlockError:
            radio = None
            raise

    return write
