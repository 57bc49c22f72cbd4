"""The settings of CoppeliaSim and the robot in its scene."""

from typing import Annotated, Literal

from msgspec import Meta

from learnblock.robots.settings import Address, Patience, Port, RobotSettings

ObjectPath = Annotated[str, Meta(max_length=200, description="robot-setting-object")]
Sensors = Annotated[
    tuple[ObjectPath, ...], Meta(max_length=16, description="robot-setting-sensors")
]


class Settings(RobotSettings, frozen=True):
    """CoppeliaSim's address, and the robot in its scene."""

    address: Address = "127.0.0.1"
    port: Port = 23000
    patience: Patience = 3.0
    scene: Annotated[
        Literal["script", "paper", "names"],
        Meta(description="robot-setting-scene"),
    ] = "script"
    #: Empty means `/LearnBlock` with our script, or `/Funciones` with the paper's.
    script: Annotated[str, Meta(max_length=200, description="robot-setting-script")] = ""
    left_wheel: ObjectPath = "/leftMotor"
    right_wheel: ObjectPath = "/rightMotor"
    wheel_radius: Annotated[float, Meta(ge=1, le=1000, description="robot-setting-length")] = 40.0
    front: Sensors = ()
    left: Sensors = ()
    right: Sensors = ()
    back: Sensors = ()
    ground_left: ObjectPath = ""
    ground_central: ObjectPath = ""
    ground_right: ObjectPath = ""
    camera: ObjectPath = ""
