"""The settings of LEGO Education's devices."""

from typing import Annotated, Literal

from msgspec import Meta

from learnblock.robots.settings import Length, Patience, RobotSettings

#: The colours of connection cards, by LEGO's numbers.
CARDS = {
    1: "magenta",
    2: "purple",
    3: "blue",
    4: "azure",
    6: "green",
    7: "yellow",
    8: "orange",
    9: "red",
}
#: A connection card, such as "azure 3683"; "" for any.
Card = Annotated[
    str,
    Meta(
        pattern=rf"^(({'|'.join(CARDS.values())}) [0-9]{{4}})?$",
        max_length=40,
        description="robot-setting-legoed-card",
    ),
]
#: A device's Bluetooth address; "" for the one with the same connection card.
DeviceAddress = Annotated[str, Meta(max_length=100, description="robot-setting-legoed-device")]
#: The setting for a device that does not belong to the robot.
ABSENT = "none"


class Settings(RobotSettings, frozen=True, kw_only=True):
    """Which devices, and the robot's size."""

    card: Card = ""
    address: Annotated[str, Meta(max_length=100, description="robot-setting-legoed-address")] = ""
    colour: DeviceAddress = ""
    controller: DeviceAddress = ""
    motor: DeviceAddress = ""
    front: Annotated[
        Literal["forward", "backward"], Meta(description="robot-setting-legoed-front")
    ] = "forward"
    # Of a car that a reader of the maker's pages has measured.
    wheel_radius: Length = 31.0
    track: Length = 80.0
    full_speed: Annotated[float, Meta(ge=100, le=2000, description="robot-setting-full-speed")] = (
        660.0
    )
    patience: Patience = 10.0
