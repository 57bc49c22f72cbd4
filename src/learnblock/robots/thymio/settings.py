"""What a Thymio has to be told about itself."""

from typing import Annotated, Literal

from msgspec import Meta

from learnblock.robots.settings import Address, Patience, Port, RobotSettings

#: Where Aseba's switch and playground listen unless told otherwise.
ASEBA_PORT = 33333
#: Where Thymio Suite's device manager listens.
SUITE_PORT = 8596


class ThymioSettings(RobotSettings, frozen=True, kw_only=True):
    """How a Thymio is reached, and how its wheels run."""

    connection: Annotated[
        Literal["auto", "serial", "tcp", "suite"],
        Meta(description="auto takes Thymio Suite where it runs, else a cable, else tcp"),
    ] = "auto"
    device: Annotated[
        str, Meta(max_length=200, description="the serial port; empty for the first Thymio found")
    ] = ""
    address: Address = "127.0.0.1"
    port: Port = ASEBA_PORT
    suite_port: Port = SUITE_PORT
    track: Annotated[float, Meta(ge=50, le=150, description="between its wheels, mm")] = 94.0
    speed_unit: Annotated[
        float, Meta(ge=0.1, le=1, description="mm/s of a wheel at motor speed 1")
    ] = 0.332
    patience: Patience = 5.0
