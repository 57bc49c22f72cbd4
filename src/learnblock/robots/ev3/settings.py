"""What an EV3 has to be told about itself."""

from typing import Annotated, Literal

from msgspec import Meta

from learnblock.robots.settings import Address, Length, Patience, Port, RobotSettings

MotorPort = Literal["A", "B", "C", "D"]
#: "" is whichever port has such a sensor.
SensorPort = Literal["", "1", "2", "3", "4"]


class Settings(RobotSettings, frozen=True):
    """How the brick is reached, what is plugged in where, and the size of the robot."""

    connection: Annotated[
        Literal["auto", "agent", "rpyc", "direct"],
        Meta(
            description="our agent on ev3dev, rpyc on ev3dev, LEGO's own firmware, or what is there"
        ),
    ] = "auto"
    address: Address = "ev3dev.local"
    agent_port: Port = 18813
    rpyc_port: Port = 18812
    direct_port: Port = 5555
    device: Annotated[
        str,
        Meta(
            max_length=200,
            description="LEGO's firmware on a cable or by Bluetooth: a file such as /dev/hidraw0",
        ),
    ] = ""
    token: Annotated[
        str, Meta(max_length=200, description="the secret shared with the agent; setup makes it")
    ] = ""
    ssh_port: Port = 22
    user: Annotated[str, Meta(min_length=1, max_length=100, description="on ev3dev")] = "robot"
    # Every brick is delivered with it.
    password: Annotated[str, Meta(max_length=100, description="of that user")] = "maker"  # noqa: S105
    left: MotorPort = "B"
    right: MotorPort = "D"
    ultrasonic: SensorPort = ""
    colour: SensorPort = ""
    gyroscope: SensorPort = ""
    touch: SensorPort = ""
    wheel_radius: Length = 30.0
    track: Length = 120.0
    full_speed: Annotated[
        float, Meta(ge=100, le=2000, description="of a wheel's motor at 100 %, degrees/s")
    ] = 1050.0
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
