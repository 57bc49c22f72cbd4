"""The content of a simulated robot's file, and the robots that come with LearnBlock.

Places on a robot are mm from the middle between its wheels, x forward and y to the left;
directions are degrees clockwise, 0 is straight ahead.
"""

import math
from collections import Counter
from collections.abc import Iterator, Sequence
from functools import cache
from pathlib import Path
from typing import Annotated, Literal

from msgspec import Meta, Struct

from learnblock.errors import RobotDescriptionError, UnknownNameError
from learnblock.i18n import Phrase
from learnblock.senses import ABILITIES
from learnblock.simulator.colours import Colour
from learnblock.storage import toml_source
from learnblock.storage.toml_source import FileMistake
from learnblock.wheels import Drivetrain

SHIPPED_ROBOTS = Path(__file__).parent / "robots"
NOTHING_SEEN = 2000.0
"""The reading of a distance sensor, in mm, when nothing is within its range."""

Side = Literal["front", "left", "right", "back"]
GroundSide = Literal["left", "central", "right"]
Key = Annotated[str, Meta(min_length=1, max_length=40)]
Offset = Annotated[float, Meta(ge=-1000, le=1000)]
Length = Annotated[float, Meta(ge=1, le=1000)]

_FORWARD = Meta(description="position forward of the middle between the wheels, mm")
_LEFTWARD = Meta(description="position to the left of it, mm")


class Body(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """The hull: a disc around the middle between the wheels, or a box."""

    shape: Annotated[Literal["disc", "box"], Meta(description="as seen from above")]
    height: Annotated[Length, Meta(description="mm")]
    mass: Annotated[float, Meta(ge=0.01, le=50, description="kg")]
    radius: Annotated[Length, Meta(description="of a disc, mm")] | None = None
    length: Annotated[Length, Meta(description="of a box, from back to front, mm")] | None = None
    width: Annotated[Length, Meta(description="of a box, mm")] | None = None
    offset: Annotated[
        Offset, Meta(description="distance of a box's middle in front of the wheels, mm")
    ] = 0.0
    colour: Annotated[Colour, Meta(description="as other robots see it")] = "grey"

    def __post_init__(self) -> None:
        if self.shape == "disc" and self.radius is None:
            raise ValueError("world-disc-without-radius")
        if self.shape == "box" and (self.length is None or self.width is None):
            raise ValueError("world-box-without-size")

    @property
    def outline(self) -> tuple[tuple[float, float], ...]:
        """Corners (forward, left) in mm, anticlockwise: of the box, or of eight on the disc."""
        if self.shape == "disc":
            angles = [math.radians(22.5 + 45 * i) for i in range(8)]
            radius = self.radius or 0.0
            return tuple((radius * math.cos(a), radius * math.sin(a)) for a in angles)
        front, back = (self.offset + sign * (self.length or 0.0) / 2 for sign in (1, -1))
        side = (self.width or 0.0) / 2
        return ((front, -side), (front, side), (back, side), (back, -side))

    @property
    def reach(self) -> float:
        """From the middle between the wheels to the farthest point of the hull, mm."""
        return max(math.hypot(x, y) for x, y in self.outline)


class Wheels(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """The drive: two wheels on one axle."""

    radius: Annotated[Length, Meta(description="of a wheel, mm")]
    track: Annotated[Length, Meta(description="between the wheels, mm")]
    maximum_speed: Annotated[float, Meta(ge=1, le=5000, description="of a wheel's rim, mm/s")]
    acceleration: Annotated[
        float, Meta(ge=1, le=50000, description="largest acceleration of a wheel's rim, mm/s²")
    ] = 1000.0
    error: Annotated[
        float, Meta(ge=0, le=0.02, description="difference between its wheels, standard deviation")
    ] = 0.001
    encoders: Annotated[bool, Meta(description="whether it counts its wheels' turns")] = True

    @property
    def drivetrain(self) -> Drivetrain:
        """What its motors can do."""
        return Drivetrain(self.track, self.maximum_speed, self.acceleration)


class DistanceSensor(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """One distance sensor; list them from left to right."""

    direction: Annotated[float, Meta(ge=-180, le=180, description="degrees, right positive")]
    sides: Annotated[
        tuple[Side, ...],
        Meta(min_length=1, max_length=4, description="the sides that list its reading"),
    ]
    x: Annotated[Offset, _FORWARD] = 0.0
    y: Annotated[Offset, _LEFTWARD] = 0.0
    minimum: Annotated[float, Meta(ge=0, le=1000, description="smallest reading, mm")] = 0.0
    maximum: Annotated[float, Meta(ge=10, le=10000, description="range, mm")] = 1000.0
    beam: Annotated[float, Meta(ge=0, le=90, description="full opening angle, degrees")] = 0.0
    noise: Annotated[
        float, Meta(ge=0, le=0.5, description="standard deviation, of the distance")
    ] = 0.0


class GroundSensor(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """One sensor facing the floor."""

    side: Annotated[GroundSide, Meta(description="the name of its reading")]
    x: Annotated[Offset, _FORWARD] = 0.0
    y: Annotated[Offset, _LEFTWARD] = 0.0
    kind: Annotated[
        Literal["reflected", "cliff"],
        Meta(description="reflected light, 0 to 100; or 0 beyond the edge of the floor, else 100"),
    ] = "reflected"
    spot: Annotated[
        float, Meta(ge=0.5, le=100, description="diameter of the measured spot, mm")
    ] = 6.0
    noise: Annotated[float, Meta(ge=0, le=50, description="standard deviation, of 100")] = 0.0


class Gyroscope(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """Measures the angle by which the robot has turned."""

    key: Annotated[Key, Meta(description="of the device")] = "Z_AXIS"
    drift: Annotated[float, Meta(ge=0, le=10, description="standard deviation, degrees/s")] = 0.0
    noise: Annotated[float, Meta(ge=0, le=10, description="standard deviation, degrees")] = 0.0


class Accelerometer(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """Measures acceleration and gravity: x forward, y left, z up."""

    noise: Annotated[float, Meta(ge=0, le=10, description="standard deviation, m/s²")] = 0.0


class Bumper(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """A bar across the front that detects touches."""

    x: Annotated[Offset, Meta(description="of the bar, forward of the wheels, mm")]
    width: Annotated[Length, Meta(description="of the bar, mm")]
    travel: Annotated[
        float, Meta(ge=0.5, le=50, description="distance at which it is pressed, mm")
    ] = 3.0


class LightSensor(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """Measures the light that falls on it."""

    x: Annotated[Offset, _FORWARD] = 0.0
    y: Annotated[Offset, _LEFTWARD] = 0.0
    noise: Annotated[float, Meta(ge=0, le=500, description="standard deviation, of 1023")] = 0.0


class Joint(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """A motor that turns a part of the robot to an angle."""

    key: Annotated[Key, Meta(description="of the device, such as CAMERA or ARM")]
    minimum: Annotated[float, Meta(ge=-180, le=180, description="degrees")]
    maximum: Annotated[float, Meta(ge=-180, le=180, description="degrees, up positive")]
    speed: Annotated[float, Meta(ge=1, le=10000, description="degrees/s")] = 120.0


class Camera(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """A camera that looks ahead."""

    z: Annotated[Length, Meta(description="height of the lens above the floor, mm")]
    focal: Annotated[float, Meta(ge=20, le=5000, description="focal length, pixels")]
    key: Annotated[Key, Meta(description="of the device")] = "ROBOT"
    x: Annotated[Offset, _FORWARD] = 0.0
    pitch: Annotated[float, Meta(ge=-90, le=90, description="degrees, up positive")] = 0.0
    joint: Annotated[Key, Meta(description="key of the joint that tilts it")] | None = None
    width: Annotated[int, Meta(ge=16, le=1920, description="of its frames, pixels")] = 320
    height: Annotated[int, Meta(ge=16, le=1080, description="of its frames, pixels")] = 240
    noise: Annotated[
        float, Meta(ge=0, le=50, description="standard deviation, grey levels of 255")
    ] = 0.0
    rate: Annotated[
        float, Meta(ge=0.1, le=100, description="largest number of frames per second")
    ] = 30.0

    @property
    def period(self) -> int:
        """Steps of 10 ms for which a frame stays the newest."""
        return max(1, round(100 / self.rate))


class Display(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """Shows emotions."""

    kind: Annotated[
        Literal["screen", "leds"],
        Meta(description="a face on a screen, or the colour of its RGB LEDs"),
    ] = "screen"


class Led(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """A light on the robot."""

    slot: Annotated[Key, Meta(description="key of the device")]
    kind: Annotated[
        Literal["rgb", "single"], Meta(description="any colour, or only on and off")
    ] = "rgb"


Output = Literal[
    "Speaker",
    "Speaker:say",
    "Speaker:play",
    "Speaker:tone",
    "Matrix",
    "MP3",
    "Infrared",
    "Animator",
]


class RobotFile(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """Everything a simulated robot's file may hold."""

    body: Annotated[Body, Meta(description="the hull")]
    wheels: Annotated[Wheels, Meta(description="the drive")]
    title: Annotated[str, Meta(max_length=200, description="shown on the page")] = ""
    world: Annotated[
        str, Meta(min_length=1, max_length=200, description="where it is when none is named")
    ] = "empty"
    distance: Annotated[tuple[DistanceSensor, ...], Meta(max_length=50)] = ()
    ground: Annotated[tuple[GroundSensor, ...], Meta(max_length=3)] = ()
    gyroscope: Annotated[Gyroscope, Meta(description="measures turns")] | None = None
    accelerometer: Annotated[Accelerometer, Meta(description="measures acceleration")] | None = None
    bumper: Annotated[Bumper, Meta(description="feels what it touches")] | None = None
    light: Annotated[LightSensor, Meta(description="measures light")] | None = None
    camera: Annotated[tuple[Camera, ...], Meta(max_length=4)] = ()
    joint: Annotated[tuple[Joint, ...], Meta(max_length=20)] = ()
    display: Annotated[Display, Meta(description="shows emotions")] | None = None
    led: Annotated[tuple[Led, ...], Meta(max_length=50)] = ()
    outputs: Annotated[
        tuple[Output, ...], Meta(max_length=5, description="devices whose commands are only logged")
    ] = ()

    def devices(self) -> tuple[str, ...]:
        """Its devices as ``Type:KEY`` strings such as ``JointMotor:CAMERA``.

        Devices of one type are in the order of the file.
        """
        outputs = dict.fromkeys(output.partition(":")[0] for output in self.outputs)
        devices = ["Base:ROBOT", *(f"{output}:ROBOT" for output in outputs)]
        devices += [f"Camera:{camera.key}" for camera in self.camera]
        devices += [f"JointMotor:{joint.key}" for joint in self.joint]
        devices += [f"{'RGBLed' if led.kind == 'rgb' else 'Led'}:{led.slot}" for led in self.led]
        if self.gyroscope:
            devices.append(f"Gyroscope:{self.gyroscope.key}")
        single = {
            "DistanceSensors": self.distance,
            "GroundSensors": self.ground,
            "Accelerometer": self.accelerometer,
            "Bumper": self.bumper,
            "LightSensor": self.light,
            "Display": self.display,
        }
        return (*devices, *(f"{device}:ROBOT" for device, part in single.items() if part))

    def abilities(self) -> frozenset[str]:
        """What its devices can do, such as ``DistanceSensors:front``; see `learnblock.senses`."""
        sides = {side for sensor in self.distance for side in sensor.sides}
        spoken = ABILITIES["Speaker"] if "Speaker" in self.outputs else ()
        reflected = any(sensor.kind == "reflected" for sensor in self.ground)
        return frozenset(
            [
                *(f"DistanceSensors:{side}" for side in sides),
                *(["GroundSensors:line"] if reflected else []),
                *(f"Speaker:{way}" for way in spoken),
                *(output for output in self.outputs if ":" in output),
            ]
        )


class RobotDescription(RobotFile, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """A robot's file together with its name.

    Args:
        name: the file's name without its suffix.
    """

    name: str = "robot"


def load_robot(name_or_path: str | Path, folders: Sequence[Path] = ()) -> RobotDescription:
    """Load the description of a simulated robot.

    Args:
        name_or_path: the name of a robot in `folders` or a built-in one, or a path ending in .toml.
        folders: the folders to search before ours, in this order.

    Raises:
        UnknownNameError: there is no such robot.
        RobotDescriptionError: the file is invalid.
    """
    file = toml_source.locate("simulated-robot", name_or_path, [*folders, SHIPPED_ROBOTS])
    return _shipped(file) if file.parent == SHIPPED_ROBOTS else _read(file)


def _read(file: Path) -> RobotDescription:
    robot = toml_source.read(file, RobotFile, RobotDescriptionError, check)
    values = {field: getattr(robot, field) for field in RobotFile.__struct_fields__}
    return RobotDescription(name=file.stem, **values)


#: A robot's class is asked for its description again and again.
_shipped = cache(_read)


def robot_names(folders: Sequence[Path] = ()) -> tuple[str, ...]:
    """The simulated robots of `folders` and ours, in alphabetical order."""
    return tuple(toml_source.names([*folders, SHIPPED_ROBOTS]))


def check(robot: RobotFile) -> Iterator[FileMistake]:
    """Find mistakes in a robot's file that its types accept."""
    yield from _check_keys(robot)
    yield from _check_ranges(robot)
    joints = [joint.key for joint in robot.joint]
    for index, camera in enumerate(robot.camera):
        if camera.joint is not None and camera.joint not in joints:
            message = UnknownNameError("joint", camera.joint, joints).phrase
            yield FileMistake(("camera", index, "joint"), "unknown-joint", message)


def _check_ranges(robot: RobotFile) -> Iterator[FileMistake]:
    """Check that a minimum is less than its maximum."""
    for group, code in (("distance", "wrong-range"), ("joint", "wrong-value")):
        for index, part in enumerate(getattr(robot, group)):
            if part.minimum >= part.maximum:
                message = Phrase(
                    "world-range-reversed",
                    place=f"{group}[{index + 1}]",
                    minimum=part.minimum,
                    maximum=part.maximum,
                )
                yield FileMistake((group, index), code, message)


def _check_keys(robot: RobotFile) -> Iterator[FileMistake]:
    """Check that devices of the same type have different keys."""
    groups = (
        ("camera", "key", [camera.key for camera in robot.camera]),
        ("joint", "key", [joint.key for joint in robot.joint]),
        ("led", "slot", [led.slot for led in robot.led]),
        ("ground", "side", [sensor.side for sensor in robot.ground]),
    )
    for group, field, keys in groups:
        seen: Counter[str] = Counter()
        for index, key in enumerate(keys):
            seen[key] += 1
            if seen[key] == 2:
                message = Phrase("world-key-taken", group=group, key=key)
                yield FileMistake((group, index, field), "key-taken", message)
