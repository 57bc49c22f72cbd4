"""The settings of a Thymio."""

from typing import Annotated, Literal

from msgspec import Meta

from learnblock.robots.settings import Address, Patience, Port, RobotSettings

#: The default port of Aseba's switch and playground.
ASEBA_PORT = 33333
#: The port of Thymio Suite's device manager.
SUITE_PORT = 8596


class ThymioSettings(RobotSettings, frozen=True, kw_only=True):
    """The connection to a Thymio, and the size and speed of its wheels."""

    connection: Annotated[
        Literal["auto", "serial", "tcp", "suite"],
        Meta(description="robot-setting-thymio-connection"),
    ] = "auto"
    device: Annotated[str, Meta(max_length=200, description="robot-setting-thymio-device")] = ""
    address: Address = "127.0.0.1"
    port: Port = ASEBA_PORT
    suite_port: Port = SUITE_PORT
    track: Annotated[float, Meta(ge=50, le=150, description="robot-setting-track")] = 94.0
    speed_unit: Annotated[float, Meta(ge=0.1, le=1, description="robot-setting-speed-unit")] = 0.332
    patience: Patience = 5.0
