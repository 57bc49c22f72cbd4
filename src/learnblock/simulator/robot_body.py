"""A simulated robot: its motion, its sensors, its lights and its camera."""

import math
from collections import deque
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any, NamedTuple, Protocol, TypeVar

from learnblock.errors import UnknownNameError
from learnblock.simulator import robot_description
from learnblock.simulator.chassis import Chassis
from learnblock.simulator.colours import RGB
from learnblock.simulator.drawing import Drawing, DrawingPen
from learnblock.simulator.geometry import Pose
from learnblock.simulator.hand import Hand
from learnblock.simulator.joints import Joints
from learnblock.simulator.noise import Noise
from learnblock.simulator.physics import DT
from learnblock.simulator.range_sensors import RangeSensors, RangeSurroundings
from learnblock.simulator.robot_description import RobotDescription

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from learnblock.simulator.camera import CameraView, Surface

PartT = TypeVar("PartT")

BUMPER_PARTS = 5
"""Points along a bumper's bar that detect a touch."""
LOG_LENGTH = 10_000
POINT = 0.01
"""The diameter in mm of a point of the floor, which is on a line or beside it."""

EMOTION_COLOURS: Mapping[str, RGB] = {
    "fear": (124, 0, 255),
    "surprise": (255, 166, 0),
    "anger": (255, 0, 0),
    "sadness": (0, 0, 255),
    "disgust": (0, 162, 0),
    "joy": (0, 255, 0),
    "neutral": (0, 0, 0),
    "none": (0, 0, 0),
}
"""The LED colours of emotions on a robot without a screen; also the list of all emotions."""


class LogEntry(NamedTuple):
    """A device command with no other effect in the world.

    Args:
        time: the world's time in s.
        device: its type, such as ``Speaker``.
        action: the command's name, such as ``say``.
        values: the values of the command.
    """

    time: float
    device: str
    action: str
    values: tuple[object, ...]


class Surroundings(RangeSurroundings, Protocol):
    """The parts of the world that a robot needs."""

    seed: int
    sensor_noise: float
    drawing: Drawing

    @property
    def slip(self) -> float: ...

    @property
    def time(self) -> float: ...

    def light_at(self, x: float, y: float) -> float: ...

    def surfaces(self, without: str | None = None) -> "list[Surface]": ...


class RobotBody:
    """A robot in a world; made by `World.add_robot`.

    Speeds are mm/s forward and degrees/s clockwise; headings are degrees clockwise, 0 faces east.
    Sensors are computed when they are read, and give the same value throughout a step.

    Args:
        description: the kind of robot.
        name: unique in the world.
        world: the world that contains it.
        group: its number in the physics.
        pose: its start pose.
    """

    def __init__(
        self,
        description: RobotDescription,
        name: str,
        world: Surroundings,
        group: int,
        pose: Pose,
    ) -> None:
        self.description = description
        self.name = name
        self.emotion = "none"
        #: The text on its screen, or beside a robot without one; empty if there is none.
        self.text = ""
        self.leds: dict[str, RGB] = {led.slot: (0, 0, 0) for led in description.led}
        self._coloured = [led.slot for led in description.led if led.kind == "rgb"]
        self._world = world
        self._group = group
        #: The hand that holds the robot.
        self.hand = Hand(world)
        self._noise = Noise(world.seed, name, world.sensor_noise)
        error = description.wheels.error
        errors = self._wheel_error("left", error), self._wheel_error("right", error)
        slip = self._slip if world.slip else None
        self.chassis = Chassis(world.physics, description, name, group, errors, slip=slip)
        self.chassis.place(pose)
        # A method, not a lambda: a copy of the world has to draw where its own robot is.
        self.pen = DrawingPen(world.drawing, name, self._where)
        self._log: deque[LogEntry] = deque(maxlen=LOG_LENGTH)
        #: The number of all commands so far, including those no longer in the log.
        self.noted = 0
        self._gyroscope_zero = (self.chassis.turned, world.steps)
        self._range_sensors = RangeSensors(description, self.chassis, world, self._noise)
        self._joints = Joints(description.joint, world)
        self._frames: dict[str, tuple[int, CameraView, NDArray[np.uint8]]] = {}

    def __repr__(self) -> str:
        x, y, heading = self.pose
        kind = self.description.name
        return f"<RobotBody {self.name!r} ({kind}) at {x:.0f}, {y:.0f} mm, {heading:.0f}°>"

    @property
    def pose(self) -> tuple[float, float, float]:
        """(x, y, heading): mm east and north, and degrees clockwise from -180 to 180."""
        pose = self.chassis.pose
        return pose.x, pose.y, pose.heading

    @property
    def distance_driven(self) -> float:
        """The distance driven since it was created, in mm; `place` does not count."""
        return self.chassis.distance_driven

    @property
    def wheels_rolled(self) -> tuple[float, float]:
        """The distance the left and the right wheel have rolled, in mm, as counted by encoders.

        Encoders know neither the true size of a wheel nor its slip: the true motion is `pose`.
        """
        return self.chassis.rolled

    @property
    def odometry(self) -> tuple[float, float, float]:
        """The pose by its wheels' encoders: (x mm, y mm, degrees clockwise), from its start."""
        return self.chassis.odometry

    @property
    def log(self) -> list[LogEntry]:
        """The last commands to devices that have no other effect, oldest first."""
        return list(self._log)

    def drive(self, adv: float, rot: float) -> None:
        """Drive at a speed forward (mm/s) and a rotation (degrees/s, clockwise positive).

        Both are reduced by the same factor if a wheel would exceed its maximum speed.

        Raises:
            ValueError: one of them is not a finite number.
        """
        if not (math.isfinite(adv) and math.isfinite(rot)):
            _require_finite("speed", adv, rot)
        self.chassis.drive(adv, rot)

    def place(self, x: float, y: float, heading: float) -> None:
        """Move the robot to a place (mm, mm, degrees), where it stops.

        Raises:
            ValueError: one of them is not a finite number.
        """
        _require_finite("place", x, y, heading)
        self.chassis.place(Pose(x, y, heading))
        self.pen.jump()

    def distances(self) -> dict[str, list[float]]:
        """The readings of the distance sensors, in mm, from left to right on each side.

        Returns:
            ``front``, ``left``, ``right`` and ``back``; 2000 means that nothing is seen.
        """
        return self._range_sensors.distances()

    def looked_at(self, side: str) -> str | None:
        """The name of what is nearest to the distance sensors of a side; None for nothing."""
        return self._range_sensors.looked_at(side)

    def ground(self) -> dict[str, float | None]:
        """The readings of the ground sensors ``left``, ``central`` and ``right``.

        From 0 (dark, or a cliff) to 100; None where there is no sensor.
        """
        return self._range_sensors.ground()

    def brightness_at(self, x: float, y: float) -> float:
        """The brightness of the floor at a point of the robot, 0 to 100; 0 outside the floor.

        Args:
            x: mm forward of the middle between the wheels.
            y: mm to the left of it.
        """
        return self._world.floor.reflectance(*self.chassis.to_world(x, y), POINT)

    def gyroscope(self) -> float:
        """Degrees turned since the last reset, clockwise, including full turns.

        Raises:
            UnknownNameError: the robot has no gyroscope.
        """
        sensor = self._require(self.description.gyroscope, "Gyroscope")
        turned, since = self._gyroscope_zero
        seconds = (self._world.steps - since) * DT
        drift = sensor.drift * self._noise.normal("gyroscope drift") * seconds
        noise = sensor.noise * self._noise.normal("gyroscope", self._world.steps)
        return self.chassis.turned - turned + drift + noise

    def reset_gyroscope(self) -> None:
        """Set the current heading to 0.

        Raises:
            UnknownNameError: the robot has no gyroscope.
        """
        self._require(self.description.gyroscope, "Gyroscope")
        self._gyroscope_zero = (self.chassis.turned, self._world.steps)

    def acceleration(self) -> tuple[float, float, float]:
        """Forward, left and up in m/s²; at rest (0, 0, 9.8).

        Raises:
            UnknownNameError: the robot has no accelerometer.
        """
        sensor = self._require(self.description.accelerometer, "Accelerometer")
        along, across = self.chassis.acceleration
        x, y, z = (
            sensor.noise * self._noise.normal(f"accelerometer {axis}", self._world.steps)
            for axis in "xyz"
        )
        forward, left, up = self.hand.acceleration()
        return along + forward + x, across + left + y, up + z

    def bumper(self) -> bool:
        """Whether the bumper is pressed.

        Raises:
            UnknownNameError: the robot has no bumper.
        """
        bar = self._require(self.description.bumper, "Bumper")
        parts = [bar.width * (i / (BUMPER_PARTS - 1) - 0.5) for i in range(BUMPER_PARTS)]
        places = [self.chassis.to_world(bar.x, part) for part in parts]
        touches = self._world.physics.touches
        return any(touches(place, bar.travel, self._group) for place in places)

    def light(self) -> float:
        """The reading of the light sensor, 0 to 1023.

        Raises:
            UnknownNameError: the robot has no light sensor.
        """
        sensor = self._require(self.description.light, "LightSensor")
        level = self._world.light_at(*self.chassis.to_world(sensor.x, sensor.y))
        noise = sensor.noise * self._noise.normal("light", self._world.steps)
        return min(1023.0, max(0.0, level + noise))

    def set_joint(self, key: str, degrees: float) -> None:
        """Turn a joint to an angle, as far and as fast as it can.

        Raises:
            UnknownNameError: the robot has no such joint.
            ValueError: the angle is not a finite number.
        """
        _require_finite("angle", degrees)
        self._joints.turn(key, degrees)

    def joint(self, key: str) -> float:
        """The current angle of a joint in degrees.

        Raises:
            UnknownNameError: the robot has no such joint.
        """
        return self._joints.angle(key)

    def focal(self, key: str = "ROBOT") -> float:
        """The focal length of a camera's lens in pixels.

        Raises:
            UnknownNameError: the robot has no such camera.
        """
        return self._camera(key).focal

    def frame(self, key: str = "ROBOT") -> "NDArray[np.uint8]":
        """A camera's newest frame: RGB, uint8, shape (height, width, 3); do not modify it.

        It is taken when it is requested, and stays the newest until the camera's rate allows
        another.

        Raises:
            UnknownNameError: the robot has no such camera.
        """
        taken, seen, picture = self._frames.get(key, (0, None, None))
        if picture is None or self._world.steps - taken >= self._camera(key).period:
            view = self.view(key)
            # A noisy view is never the same: it has a generator of its own.
            if picture is None or view != seen:
                picture = view.picture()
                picture.flags.writeable = False
            self._frames[key] = (self._world.steps, view, picture)
        return picture

    def view(self, key: str = "ROBOT") -> "CameraView":
        """The current view of a camera, to be drawn later, for observers of the robot.

        No frame is taken: the robot's newest frame stays the same.

        Raises:
            UnknownNameError: the robot has no such camera.
        """
        # Imported here because a world without a camera does not need OpenCV.
        from learnblock.simulator.camera import (  # noqa: PLC0415 - see above
            CameraModel,
            CameraPose,
            CameraView,
        )

        camera = self._camera(key)
        tilt = self.joint(camera.joint) if camera.joint is not None else 0.0
        heading = self.chassis.pose.heading
        pose = CameraPose(
            *self.chassis.to_world(camera.x, 0.0), camera.z, heading, camera.pitch + tilt
        )
        model = CameraModel(camera.width, camera.height, camera.focal)
        surfaces = tuple(self._world.surfaces(without=self.name))
        return CameraView(surfaces, model, pose, self._camera_noise(camera))

    def show_emotion(self, name: str) -> None:
        """Show an emotion on the screen, or as the colour of the LEDs.

        Raises:
            UnknownNameError: there is no such emotion, or the robot has no display.
        """
        display = self._require(self.description.display, "Display")
        if name not in EMOTION_COLOURS:
            raise UnknownNameError("emotion", name, EMOTION_COLOURS)
        self.emotion = name
        if display.kind == "screen":
            self.text = ""
        if display.kind == "leds":
            self.leds.update(dict.fromkeys(self._coloured, EMOTION_COLOURS[name]))

    def show_text(self, text: str) -> None:
        """Show a text on the screen, instead of the face; without a screen, beside the robot.

        Args:
            text: an empty one clears the screen.
        """
        self.text = text

    def set_led(self, slot: str, colour: RGB) -> None:
        """Light an LED: red, green and blue, 0 to 255.

        Raises:
            UnknownNameError: the robot has no such LED.
        """
        if slot not in self.leds:
            raise UnknownNameError("led", slot, self.leds)
        red, green, blue = (min(max(round(level), 0), 255) for level in colour)
        self.leds[slot] = (red, green, blue)

    def note(self, device: str, action: str, *values: object) -> None:
        """Log a command to a device that has no other effect.

        Args:
            device: such as ``Speaker``.
            action: such as ``say``.
            values: the arguments of the command.
        """
        self._log.append(LogEntry(self._world.time, device, action, values))
        self.noted += 1

    def _where(self) -> Pose:
        return self.chassis.pose

    def _wheel_error(self, wheel: str, deviation: float) -> float:
        # The size of a wheel isn't a reading, so the factor of the sensors' noise is left out.
        error = deviation * Noise(self._world.seed, self.name).normal(f"{wheel} wheel")
        return min(max(error, -3 * deviation), 3 * deviation)

    def _slip(self, period: int) -> tuple[float, float]:
        """The part of its rotation that each wheel loses: on average the slip of the floor."""
        return self._lost("left", period), self._lost("right", period)

    def _lost(self, wheel: str, period: int) -> float:
        evenly = self._noise.bits(f"{wheel} slip", period) / 2**63
        return self._world.slip * evenly

    def _require(self, part: PartT | None, device: str) -> PartT:
        if part is None:
            devices = sorted({key.partition(":")[0] for key in self.description.devices()})
            raise UnknownNameError("device", device, devices)
        return part

    def _camera(self, key: str) -> robot_description.Camera:
        cameras = {camera.key: camera for camera in self.description.camera}
        if key not in cameras:
            raise UnknownNameError("camera", key, cameras)
        return cameras[key]

    def _camera_noise(
        self, camera: robot_description.Camera
    ) -> "tuple[np.random.Generator, float] | None":
        if not camera.noise:
            return None
        import numpy as np  # noqa: PLC0415 - a world without a camera does not need it

        bits = self._noise.bits(f"camera {camera.key}", self._world.steps)
        return np.random.Generator(np.random.PCG64(bits)), camera.noise * self._noise.factor


#: How each type of sensor is read, apart from cameras.
READINGS: Mapping[str, Callable[[RobotBody], Any]] = {
    "DistanceSensors": RobotBody.distances,
    "GroundSensors": RobotBody.ground,
    "Gyroscope": RobotBody.gyroscope,
    "Accelerometer": RobotBody.acceleration,
    "Bumper": RobotBody.bumper,
    "LightSensor": RobotBody.light,
}


def _require_finite(what: str, *values: float) -> None:
    for value in values:
        if not math.isfinite(value):
            raise ValueError(f"the {what} is {value}; expected a finite number")
