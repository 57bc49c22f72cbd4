"""The settings of a SPIKE hub."""

from typing import Annotated, Literal

from msgspec import Meta

from learnblock.robots.settings import Length, Patience, RobotSettings

#: "" means any port with such a device.
HubPort = Literal["", "A", "B", "C", "D", "E", "F"]


class Settings(RobotSettings, frozen=True, kw_only=True):
    """Which hub, the ports of motors and sensors, and the robot's size."""

    address: Annotated[str, Meta(max_length=100, description="robot-setting-spike-address")] = ""
    left: HubPort = ""
    right: HubPort = ""
    distance: HubPort = ""
    colour: HubPort = ""
    force: HubPort = ""
    # The driving base of LEGO's own building instructions: wheels of 56 mm.
    wheel_radius: Length = 28.0
    track: Length = 112.0
    full_speed: Annotated[float, Meta(ge=100, le=2000, description="robot-setting-full-speed")] = (
        1000.0
    )
    patience: Patience = 10.0

    @property
    def ports(self) -> dict[str, str]:
        """The port of each motor and sensor."""
        names = ("left", "right", "distance", "colour", "force")
        return {name: getattr(self, name) for name in names}
