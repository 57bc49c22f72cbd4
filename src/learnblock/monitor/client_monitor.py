"""The monitor of a real robot, which is known only through its client.

It shows the readings that the client polls anyway. A sensor that the program does not use is polled
in a separate thread, so that the program never waits for the page. Commands are recorded
on their way to the robot, as in the recorder of the trace.
"""

from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from functools import partial
from typing import Any

from learnblock.client import Client
from learnblock.devices import Base, Camera, Device, JointMotor, Pose, Sensor
from learnblock.errors import LearnBlockError
from learnblock.monitor import plain_stage
from learnblock.monitor.games import own_game
from learnblock.monitor.monitor import (
    Link,
    LinkState,
    Picture,
    Robot,
    Scene,
    Seen,
    Sound,
    State,
    Stroke,
    located,
)
from learnblock.monitor.sensors import SENSOR_TYPES, sensors_of
from learnblock.monitor.sensors import Sensor as SensorNow

#: Seconds without a message or a reading after which a link counts as weak.
WEAK_SILENCE = 0.5
#: Below this share of the usual messages, a link counts as weak.
WEAK_QUALITY = 0.7
_COMMANDS = frozenset({"move", "show_emotion", "show_text", "set", "set_color"})


class ClientMonitor:
    """The `Monitor` of a real robot.

    Args:
        robot: its class.
        client: the robot of a running program; None while none is connected.
    """

    #: A real robot starts where it is.
    start: Pose | None = None

    def __init__(self, robot: type[Client], client: Client | None = None) -> None:
        self._robot = robot
        self._client = client
        self._watching = False
        #: The latest command by type of device, key and function.
        self._commands: dict[tuple[str, str, str], tuple[Any, ...]] = {}
        self._sensors: dict[tuple[str, str], tuple[SensorNow, ...]] = {}
        self._state = State(0.0, (Robot("robot", *located(None)),))
        self._filmed: tuple[object, Picture] | None = None
        if client:
            self._note_commands(client)

    def scene(self) -> Scene:
        return plain_stage.scene(self._robot)

    def state(self) -> State:
        client = self._client
        if client and not client.stopped:
            self._watch(client)
            self._state = State(
                client.clock.time(),
                (self._robot_now(client),),
                sensors=self._readings(client),
                game=own_game(client.game),
            )
        return self._state

    def link(self) -> Link:
        client = self._client
        if client is None:
            return Link(LinkState.DISCONNECTED)
        if client.stopped or client.link_error:
            lost = client.link_error or self._all_readings_fail(client)
            return Link(LinkState.LOST if lost else LinkState.DISCONNECTED)
        status = client.status()
        silence = max(status.silence or 0.0, client.readings.age() or 0.0)
        quality = 1.0 if status.link_quality is None else status.link_quality
        weak = silence > WEAK_SILENCE or quality < WEAK_QUALITY
        return Link(
            LinkState.WEAK if weak else LinkState.CONNECTED, status.battery, status.link_quality
        )

    def camera(self) -> "Picture | None":
        client = self._client
        camera = next(_cameras(client), None) if client and not client.stopped else None
        if client is None or camera is None:
            return self._filmed[1] if self._filmed else None
        frame = None
        with suppress(LearnBlockError):
            # A failed camera ends a program that uses it; here it just shows nothing.
            frame = camera.functions["read"]()
        if frame is not None and not (self._filmed and self._filmed[0] is frame):
            from learnblock.monitor.pictures import develop  # noqa: PLC0415 - it loads perception

            self._filmed = frame, develop(frame, client.clock.time(), drawn=camera.drawn)
        return self._filmed[1] if self._filmed else None

    def found(self) -> tuple[Seen, ...] | None:
        client = self._client
        if client is None or not client.detected:
            return None
        from learnblock.monitor.pictures import found  # noqa: PLC0415 - it loads perception

        return found(client.detected)

    def sounds(self) -> Sequence[Sound]:
        """None: a real robot plays its sounds itself."""
        return ()

    def strokes(self) -> "Sequence[Stroke]":
        """None: a real robot has no pen."""
        return ()

    def place(self, x: float, y: float, heading: float) -> None:
        del x, y, heading
        raise LearnBlockError("monitor-place-real")

    def handle(self, how: str) -> None:
        del how
        raise LearnBlockError("monitor-handle-real")

    def drive(self, advance: float, rotation: float) -> None:
        del advance, rotation
        raise LearnBlockError("monitor-drive-real")

    def close(self) -> None:
        """Do nothing: the client ends its own threads."""

    # Commands on their way.

    def _note_commands(self, client: Client) -> None:
        for key, device in client.devices():
            for name in _COMMANDS & device.functions.keys():
                function = device.functions[name]
                noted = type(device).__name__, key, name
                device.functions[name] = partial(self._note, noted, function)

    def _note(self, noted: tuple[str, str, str], function: Callable[..., Any], *args: Any) -> Any:
        self._commands[noted] = args
        return function(*args)

    def _commanded(self, name: str, *kinds: str) -> Iterator[tuple[str, tuple[Any, ...]]]:
        """Key and arguments of the latest commands to devices of these types."""
        for (kind, key, function), args in tuple(self._commands.items()):
            if kind in kinds and function == name:
                yield key, args

    # Readings.

    def _watch(self, client: Client) -> None:
        """Poll every sensor, starting at the first query."""
        if self._watching:
            return
        self._watching = True
        for key, device in client.devices():
            if isinstance(device, Sensor) and type(device).__name__ in SENSOR_TYPES:
                client.readings.watch((type(device), key), device.read)
            elif isinstance(device, Base | JointMotor) and "read" in device.functions:
                client.readings.watch((type(device), key), device.functions["read"])

    def _readings(self, client: Client) -> tuple[SensorNow, ...]:
        for key, device in client.devices():
            kind = type(device).__name__
            if kind in SENSOR_TYPES:
                self._keep(client, device, key)
        kinds = sorted(self._sensors, key=lambda entry: SENSOR_TYPES.index(entry[0]))
        return tuple(sensor for kind in kinds for sensor in self._sensors[kind])

    def _keep(self, client: Client, device: Device, key: str) -> None:
        """Keep a device's readings; without new ones, its sensors remain, without values."""
        kind = type(device).__name__
        sensors = tuple(sensors_of(kind, _newest(client, device, key), key))
        earlier = self._sensors.get((kind, key), ())
        self._sensors[kind, key] = sensors or tuple(sensor.without_value() for sensor in earlier)

    def _all_readings_fail(self, client: Client) -> bool:
        """Whether no sensor at all can be read; a single one may just be unplugged."""
        # A pose that is reckoned from the commands needs no link.
        devices = [
            (key, device)
            for key, device in client.devices()
            if not isinstance(device, Base) or device.has_odometry
        ]
        errors = [client.readings.error((type(device), key)) for key, device in devices]
        values = [_newest(client, device, key) for key, device in devices]
        return any(errors) and all(value is None for value in values)

    def _robot_now(self, client: Client) -> Robot:
        joints: dict[str, float] = {}
        pose: Pose | None = None
        for key, device in client.devices():
            if isinstance(device, Base) and pose is None:
                pose = _newest(client, device, key)
            elif isinstance(device, JointMotor):
                angle = _newest(client, device, key)
                joints |= {} if angle is None else {key: float(angle)}
        commanded = {key: float(args[0]) for key, args in self._commanded("move", "JointMotor")}
        speeds = [args for _, args in self._commanded("move", "Base")]
        emotions = [str(args[0]) for _, args in self._commanded("show_emotion", "Display")]
        texts = [str(args[0]) for _, args in self._commanded("show_text", "Screen")]
        return Robot(
            "robot",
            *located(pose),
            joints=commanded | joints,
            leds=dict(self._leds()),
            emotion=emotions[-1] if emotions else "none",
            text=texts[-1] if texts else "",
            speed=(float(speeds[-1][0]), float(speeds[-1][1])) if speeds else None,
        )

    def _leds(self) -> Iterator[tuple[str, tuple[int, int, int]]]:
        for key, (on,) in self._commanded("set", "Led"):
            yield key, (255, 255, 255) if on else (0, 0, 0)
        for key, (red, green, blue) in self._commanded("set_color", "RGBLed"):
            yield key, (red, green, blue)


def _cameras(client: Client) -> Iterator[Camera]:
    return (device for _, device in client.devices() if isinstance(device, Camera))


def _newest(client: Client, device: Device, key: str) -> Any:
    return client.readings.newest((type(device), key))
