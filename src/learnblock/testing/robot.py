"""A robot without hardware."""

from collections.abc import Callable, Collection
from typing import Any

from learnblock.client import AnyRobot, Observer
from learnblock.devices import (
    DEFAULT_KEY,
    DEVICE_TYPES,
    MP3,
    Animator,
    Base,
    Camera,
    Device,
    Display,
    Gyroscope,
    Infrared,
    JointMotor,
    Led,
    Matrix,
    Pen,
    RGBLed,
    Screen,
    Sensor,
    Speaker,
)
from learnblock.perception import Lines, LineView
from learnblock.testing.clock import VirtualClock
from learnblock.testing.forms import quiet_readings
from learnblock.testing.wheels import Wheels


class FakeRobot(AnyRobot):
    """A robot with every type of device, which records commands and reads values set by a test.

    Its wheels react at once, and its gyroscope and pose follow them, all in virtual time:

        >>> from learnblock.devices import DistanceSensors
        >>> robot = FakeRobot()
        >>> robot.set_reading(DistanceSensors, {"front": [120.0]})
        >>> robot.is_front_obstacle()
        True
        >>> robot.turn(90)
        >>> round(robot.wheels.pose[2])
        90
        >>> robot.commands[-1]
        ('Base.move', 0.0, 0.0)
        >>> robot.stop()

    Args:
        only: the types of its devices; every type by default.
        skills: as for `Client`.
        observer: as for `Client`.

    Attributes:
        commands: the commands of its devices as ("Type.function", argument, ...); the type has
            its key unless that is the default one: "JointMotor:CAMERA.move".
        wheels: the wheels of its base, whose pose can be set, and which can get stuck.
    """

    clock: VirtualClock
    has_extra_camera = False

    def __init__(
        self,
        *,
        only: Collection[type[Device]] = tuple(DEVICE_TYPES.values()),
        skills: Collection[str] | None = None,
        observer: Observer | None = None,
    ) -> None:
        clock = VirtualClock()
        self.commands: list[tuple[Any, ...]] = []
        self.wheels = Wheels(clock)
        self._only = frozenset(only)
        self._zero = 0.0
        quiet = {**quiet_readings(), Camera: None, Infrared: None}
        self._values: dict[tuple[type[Device], str], Any] = {
            (kind, DEFAULT_KEY): value for kind, value in quiet.items()
        }
        self._detections: dict[str, Any] = _nothing_seen()
        super().__init__(skills=skills, clock=clock, observer=observer)

    def set_reading(self, kind: type[Sensor[Any]], value: Any, key: str = DEFAULT_KEY) -> None:
        """Set the reading of a sensor; only the gyroscope always reads the wheels' heading."""
        self._values[kind, key] = value
        self.forget_readings()

    def set_detections(self, name: str, found: Any) -> None:
        """Set the results of a detector (``tags``, ``lines``, ...); None if it is not installed."""
        self._detections[name] = found
        self.forget_readings()

    def connect(self) -> None:
        devices: list[Device] = [
            Base(self._move, lambda: self.wheels.pose),
            Camera(self._reader(Camera), self._detections.get),
            Infrared(self._reader(Infrared), self._note("Infrared.send")),
            Animator(self._note("Animator.play")),
            Display(self._note("Display.show_emotion"), self._note("Display.show_image")),
            Speaker(**self._notes("Speaker", "say", "play", "tone")),
            Matrix(**self._notes("Matrix", "icon", "number", "text")),
            Pen(**self._notes("Pen", "set", "set_color", "set_width", "clear")),
            Screen(self._note("Screen.show_text")),
            MP3(**self._notes("MP3", "select", "action", "volume", "equalizer", "loop")),
        ]
        devices += [kind(self._reader(kind)) for kind in quiet_readings()]
        for device in devices:
            self._give(device)
        self._give(Gyroscope(self._heading, self._reset_gyroscope), "Z_AXIS")
        self._give(Led(self._note("Led:Up.set")), "Up")
        self._give(RGBLed(self._note("RGBLed:Up.set_color")), "Up")
        for key in ("CAMERA", "ARM"):
            self._give(JointMotor(self._note(f"JointMotor:{key}.move")), key)

    def _give(self, device: Device, key: str = DEFAULT_KEY) -> None:
        if type(device) in self._only:
            self.add(device, key)

    def _note(self, name: str) -> Callable[..., None]:
        return lambda *args: self.commands.append((name, *args))

    def _notes(self, device: str, *functions: str) -> dict[str, Callable[..., None]]:
        return {function: self._note(f"{device}.{function}") for function in functions}

    def _reader(self, kind: type[Device]) -> Callable[[], Any]:
        return lambda: self._values[kind, DEFAULT_KEY]

    def _move(self, adv: float, rot: float) -> None:
        self.commands.append(("Base.move", adv, rot))
        self.wheels.move(adv, rot)

    def _heading(self) -> float:
        return self.wheels.pose[2] - self._zero

    def _reset_gyroscope(self) -> None:
        self.commands.append(("Gyroscope:Z_AXIS.reset",))
        self._zero = self.wheels.pose[2]


def _nothing_seen() -> dict[str, Any]:
    """The results of each detector in an empty picture."""
    black, red, blue = (LineView(colour, 0, 0, 0) for colour in ("black", "red", "blue"))
    lines = Lines(black, red, blue)
    return {"lines": lines, "tags": (), "objects": (), "faces": (), "emotions": ()}
