"""What has to be known about CoppeliaSim and the robot in its scene."""

from typing import Annotated, Literal

from msgspec import Meta

from learnblock.robots.settings import Address, Patience, Port, RobotSettings

ObjectPath = Annotated[
    str, Meta(max_length=200, description="an object's path in the scene, such as /Robot/sonar")
]
Sensors = Annotated[
    tuple[ObjectPath, ...], Meta(max_length=16, description="proximity sensors, from left to right")
]


class Settings(RobotSettings, frozen=True):
    """Where CoppeliaSim listens, and which robot of its scene is driven."""

    address: Address = "127.0.0.1"
    port: Port = 23000
    patience: Patience = 3.0
    scene: Annotated[
        Literal["script", "paper", "names"],
        Meta(description="our scene script, the paper's scene, or a robot by the names below"),
    ] = "script"
    #: Empty: `/LearnBlock` for our script, `/Funciones` for the paper's.
    script: Annotated[
        str, Meta(max_length=200, description="the object with the script; empty: the usual one")
    ] = ""
    left_wheel: ObjectPath = "/leftMotor"
    right_wheel: ObjectPath = "/rightMotor"
    wheel_radius: Annotated[float, Meta(ge=1, le=1000, description="mm")] = 40.0
    front: Sensors = ()
    left: Sensors = ()
    right: Sensors = ()
    back: Sensors = ()
    ground_left: ObjectPath = ""
    ground_central: ObjectPath = ""
    ground_right: ObjectPath = ""
    camera: ObjectPath = ""
