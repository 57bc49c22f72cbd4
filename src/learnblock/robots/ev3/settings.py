"""The settings of an EV3."""

from typing import Annotated, Literal

from msgspec import Meta

from learnblock.robots.settings import Address, Length, Patience, Port, RobotSettings

MotorPort = Literal["A", "B", "C", "D"]
#: "" means any port with such a sensor.
SensorPort = Literal["", "1", "2", "3", "4"]


class Settings(RobotSettings, frozen=True):
    """The connection to the brick, the ports of motors and sensors, and the robot's size."""

    connection: Annotated[
        Literal["auto", "agent", "rpyc", "direct"], Meta(description="robot-setting-connection")
    ] = "auto"
    address: Address = "ev3dev.local"
    agent_port: Port = 18813
    rpyc_port: Port = 18812
    direct_port: Port = 5555
    device: Annotated[str, Meta(max_length=200, description="robot-setting-device")] = ""
    token: Annotated[str, Meta(max_length=200, description="robot-setting-token")] = ""
    ssh_port: Port = 22
    user: Annotated[str, Meta(min_length=1, max_length=100, description="robot-setting-user")] = (
        "robot"
    )
    # The default of every ev3dev image.
    password: Annotated[str, Meta(max_length=100, description="robot-setting-password")] = "maker"  # noqa: S105
    left: MotorPort = "B"
    right: MotorPort = "D"
    ultrasonic: SensorPort = ""
    colour: SensorPort = ""
    gyroscope: SensorPort = ""
    touch: SensorPort = ""
    wheel_radius: Length = 30.0
    track: Length = 120.0
    full_speed: Annotated[float, Meta(ge=100, le=2000, description="robot-setting-full-speed")] = (
        1050.0
    )
    patience: Patience = 3.0

    @property
    def sensors(self) -> dict[str, SensorPort]:
        """The port of each kind of sensor."""
        return {
            "ultrasonic": self.ultrasonic,
            "colour": self.colour,
            "gyroscope": self.gyroscope,
            "touch": self.touch,
        }
