"""Layer 1 of the robot side: the generic client, base class of every robot."""

import atexit
import signal
import threading
from collections.abc import Callable, Collection, Iterator, Mapping
from contextlib import AbstractContextManager, ExitStack
from dataclasses import dataclass
from enum import Enum, auto
from types import FrameType, TracebackType
from typing import Any, ClassVar, NoReturn, Protocol, Self, TypeVar

from learnblock import skills as skill_registry
from learnblock.clock import Clock, WallClock
from learnblock.devices import DEFAULT_KEY, Base, Camera, Device, Pose, Reading, Sensor
from learnblock.errors import (
    KeyTakenError,
    RobotAttributeError,
    RobotStoppedError,
    SettingsError,
    did_you_mean,
)
from learnblock.events import Events
from learnblock.readings import SENSORS, Glance, PolledReadings, Readings

D = TypeVar("D", bound=Device)


class State(Enum):
    """The life of a client."""

    CONNECTING = auto()
    CONNECTED = auto()
    STOPPED = auto()


class Observer(Protocol):
    """Someone who is told what a program does with its robot, such as a recorder of traces."""

    def called(self, skill: str, args: tuple[Any, ...], kwargs: dict[str, Any]) -> None:
        """The program called a skill."""

    def missing(self, skill: str, device: str) -> None:
        """A skill had no effect, since the robot lacks the device (``Type:KEY``)."""


class Witness(Protocol):
    """Someone who is told what befalls a robot."""

    def pose(self, time: float, pose: Pose) -> None:
        """Where the robot is at that time; told every 0.1 s."""

    def placed(self, time: float, pose: Pose) -> None:
        """Somebody lifted the robot at that time and set it down there."""

    def goal(self, time: float, name: str, state: str) -> None:
        """A goal of the world was ``reached`` or ``failed``."""


@dataclass(frozen=True, slots=True)
class Goal:
    """One of a world's goals.

    Args:
        name: as the world calls it.
        kind: region, line, tag.
        state: ``open``, ``reached`` or ``failed``.
        time: seconds at which it was decided; None while open.
    """

    name: str
    kind: str
    state: str
    time: float | None


@dataclass(frozen=True, slots=True)
class Outcome:
    """What a run has come to: pose and mm driven where they are known, and the world's goals."""

    pose: Pose | None = None
    distance: float | None = None
    goals: tuple[Goal, ...] = ()


class Client(Events):
    """A robot as programs see it: skills as methods, whatever the hardware beneath.

    A robot of one's own is a subclass that says how to connect, to disconnect and to reach each
    device:

        class Robot(Client):
            def connect(self):
                self.port = open_port("/dev/ttyUSB0")
                self.add(Base(move=self.port.drive))

            def disconnect(self):
                self.port.close()

    It is connected by its constructor and disconnected exactly once, motors stopped first: by
    `stop`, at the end of a ``with``, or when the program ends, also by an error, Ctrl-C or SIGTERM.

    Args:
        skills: the names of the skills the program uses; all there are when it is None.
        clock: the robot's time; the wall clock by default.
        observer: is told of calls and of skills without effect.

    Raises:
        RobotConnectionError: the robot cannot be reached.
    """

    #: Whether its world waits for its program, as only a simulated one does.
    lockstep: ClassVar[bool] = False
    #: Seconds between two readings of a sensor in use; None reads when the program asks.
    sensing_period: ClassVar[float | None] = 0.02
    #: Whether it gets the camera that the user's settings add to every robot.
    has_extra_camera: ClassVar[bool] = True

    def __init__(
        self,
        *,
        skills: Collection[str] | None = None,
        clock: Clock | None = None,
        observer: Observer | None = None,
    ) -> None:
        super().__init__()
        self.clock: Clock = clock or WallClock()
        self.observer = observer
        self._devices: dict[type[Device], dict[str, Device]] = {}
        self._skill: str | None = None
        #: The skill in use with what it was given.
        self._question: tuple[object, ...] | None = None
        self._noted: set[str] = set()
        self._state = State.CONNECTING
        self._stopping = threading.Lock()
        self._readings = self._make_readings()
        self._glance = Glance(self.clock)
        self._attach(skills)
        self._connect()

    # What a specific robot writes.

    def connect(self) -> None:
        """Reach the robot and `add` its devices."""

    def disconnect(self) -> None:
        """Let go of the robot; its motors are already stopped."""

    @classmethod
    def device_names(cls) -> frozenset[str] | None:
        """The devices of every such robot as ``Type:KEY``, where that is known beforehand."""
        return None

    @classmethod
    def known_devices(cls) -> frozenset[str] | None:
        """`device_names`, and the camera that the user's settings add."""
        names = cls.device_names()
        if names is None or not cls.has_extra_camera:
            return names
        from learnblock.vision.extra import extra_devices  # noqa: PLC0415 - it loads what few need

        try:
            return names | extra_devices(names)
        except SettingsError:
            # Told when the robot is connected.
            return names

    @classmethod
    def check_wishes(cls, wishes: Mapping[str, Any]) -> None:
        """Refuse what `hosted` could not fulfil, before a program is started.

        Raises:
            LearnBlockError: the sentence says what is wrong with which wish.
        """

    @classmethod
    def hosted(cls, arguments: Mapping[str, Any], wishes: Mapping[str, Any]) -> Self:
        """Make the robot for a host that runs its program elsewhere.

        Args:
            arguments: what the program gave to ``Robot(...)``.
            wishes: world, seed and pace as chosen outside the program, which only a simulated robot
                has a use for.
        """
        del wishes
        return cls(**arguments)

    def conditions(self) -> dict[str, object]:
        """What a run depends on besides its program: the first line of a trace names it."""
        from learnblock.vision import TABLE  # noqa: PLC0415 - it loads what few need

        # By name alone: addresses and paths are nobody's business.
        chosen = [one.name for one in TABLE.describe() if one.value != one.default]
        robot = type(self).__module__.rpartition(".")[2].replace("_", "-")
        return {"robot": robot, **({"perception": chosen} if chosen else {})}

    def where(self) -> Pose | None:
        """The robot's true pose (x mm, y mm, heading in degrees), which only a simulator knows."""
        return None

    def observe(self, witness: Witness) -> None:
        """Have the witness told what befalls the robot, as far as anybody can see it."""

    def check_link(self) -> None:
        """Say so if the robot can no longer be reached; it is asked some times a second.

        Raises:
            RobotConnectionError: the link to the robot broke.
        """

    def outcome(self) -> Outcome:
        """What a run has come to so far."""
        return Outcome()

    # Devices.

    def add(self, device: Device, key: str = DEFAULT_KEY) -> None:
        """Give the robot a device.

        Raises:
            KeyTakenError: there is one of the same type with the same key already.
        """
        same = self._devices.setdefault(type(device), {})
        if key in same:
            raise KeyTakenError(
                f"this robot already has a {type(device).__name__} with the key {key!r};"
                " give the second one a key of its own"
            )
        same[key] = device

    def devices(self) -> Iterator[tuple[str, Device]]:
        """Every device with its key."""
        for same in self._devices.values():
            yield from same.items()

    def device(self, kind: type[D], key: str = DEFAULT_KEY) -> D | None:
        """The device of that type and key, or None: the observer is told, once a call of a skill.

        Raises:
            RobotStoppedError: the robot is disconnected.
        """
        if self._state is State.STOPPED:
            raise RobotStoppedError(
                "the robot has been stopped: nothing can be asked of it any more"
            )
        if not self._readings.frozen:
            self.clock.charge()
        try:
            return self._devices[kind][key]  # type: ignore[return-value] # filed under its type
        except KeyError:
            self._note_missing(f"{kind.__name__}:{key}")
            return None

    def read(self, kind: "type[Sensor[Reading]]", key: str = DEFAULT_KEY) -> Reading | None:
        """The latest reading of a sensor, or None on a robot without it."""
        sensor = self.device(kind, key)
        if sensor is None:
            return None
        reading: Reading = self._readings.latest((kind, key), sensor.read, _pace(kind, key))
        return reading

    def detect(self, name: str, key: str = DEFAULT_KEY) -> Any:
        """What the detector `name` finds in the camera's latest frame.

        None without a camera, without a frame yet, or where there is no such detector.
        """
        camera = self.device(Camera, key)
        if camera is None:
            return None
        found = self._seen((Camera, key, name), lambda: camera.detect(name))
        if found is None:
            self._note_missing(f"Detector:{name}")
        return found

    def forget_readings(self) -> None:
        """Read sensors anew at the next question, as after a gyroscope was reset."""
        self._readings.forget()

    # Skills.

    def learn(self, function: Callable[..., Any]) -> None:
        """Take a function of the program's, which gets the robot first, as a skill of this robot.

            def waltz(robot, times=3): ...

            robot.learn(waltz)
            robot.waltz(2)

        Raises:
            KeyTakenError: every robot has something of this name already.
        """
        name = function.__name__
        if hasattr(Client, name):
            raise KeyTakenError(f"a skill cannot be called `{name}`: every robot has that already")
        setattr(self, name, self._method(name, function))

    # Time.

    def time(self) -> float:
        """Seconds since the robot was connected, in the robot's time."""
        self.clock.charge()
        return self.clock.time()

    # The end.

    @property
    def stopped(self) -> bool:
        return self._state is State.STOPPED

    def stop(self) -> None:
        """Stop the motors and disconnect; the second time it does nothing."""
        # Everything on the stack happens, the last first, whatever fails or is interrupted.
        with ExitStack() as ending, self._stopping:
            if self._state is State.STOPPED:
                return
            ending.callback(self._close_cameras)
            ending.callback(self.disconnect)
            ending.callback(self._readings.close)
            ending.callback(self._forget_endings)
            if self._state is State.CONNECTED:
                ending.callback(self._stop_motors)
            self._state = State.STOPPED

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        self.stop()

    def __repr__(self) -> str:
        names = ", ".join(f"{type(device).__name__}:{key}" for key, device in self.devices())
        return (
            f"<{type(self).__module__}.{type(self).__name__} {self._state.name.lower()}: {names}>"
        )

    def __getattr__(self, name: str) -> Any:
        # Only reached for what is neither a method nor a skill in use: a skill calls another one
        # that its program does not mention.
        if name.startswith("_"):
            raise AttributeError(name)
        self._attach({name})
        if name in vars(self):
            return vars(self)[name]
        hint = did_you_mean(name, [known for known in dir(self) if not known.startswith("_")])
        raise RobotAttributeError(f"a robot has no skill `{name}`" + (f"; {hint}" if hint else ""))

    # Parts of the above.

    def _make_readings(self) -> Readings:
        if self.sensing_period is None or self.clock.instant is not None:
            return Readings(self.clock)
        return PolledReadings(self.clock, self.sensing_period)

    def _connect(self) -> None:
        self._watch_endings()
        try:
            self.connect()
            if self.has_extra_camera:
                self._add_extra_camera()
        except BaseException as error:
            self._give_up(error)
            raise
        self._state = State.CONNECTED

    def _give_up(self, error: BaseException) -> None:
        """Disconnect a robot that is half connected; why it is only half is what matters."""
        try:
            self.stop()
        except Exception as another:  # noqa: BLE001 - a `disconnect` may miss what was never there
            error.add_note(f"disconnecting failed as well: {type(another).__name__}: {another}")

    def _stop_motors(self) -> None:
        """Stop every base, also those after one that fails."""
        with ExitStack() as stack:
            for _, device in self.devices():
                if isinstance(device, Base):
                    stack.callback(device.stop)

    def _add_extra_camera(self) -> None:
        from learnblock.vision.extra import WEBCAM, extra_source  # noqa: PLC0415 - it loads what few need

        source = extra_source(self.clock.time)
        if source is not None:
            camera = Camera(read=source.read, close=source.close)
            self.add(camera, WEBCAM)
            # A robot without a camera of its own looks through it.
            self._devices[Camera].setdefault(DEFAULT_KEY, camera)

    def _close_cameras(self) -> None:
        for _, device in self.devices():
            if isinstance(device, Camera):
                device.close()

    def _attach(self, names: Collection[str] | None) -> None:
        for name, function in skill_registry.find(names).items():
            # A skill of somebody else's does not hide what every robot has; who writes one is told.
            if not hasattr(Client, name) and name not in vars(self):
                setattr(self, name, self._method(name, function))

    def _method(self, name: str, function: Callable[..., Any]) -> Callable[..., Any]:
        def skill(*args: Any, **kwargs: Any) -> Any:
            if self._skill is not None:
                return function(self, *args, **kwargs)
            self._skill, self._question = name, (name, args, kwargs)
            self._noted.clear()
            try:
                if self.observer:
                    self.observer.called(name, args, kwargs)
                return function(self, *args, **kwargs)
            finally:
                self._skill = self._question = None

        skill.__name__ = skill.__qualname__ = name
        skill.__doc__ = function.__doc__
        return skill

    def _seen(self, key: tuple[object, ...], detect: Callable[[], Any]) -> Any:
        """What a detector finds, by the newest picture or that of the question before."""

        def look() -> Any:
            return self._readings.latest(key, detect, _pace(Camera, key[1]))

        if self.clock.instant is not None or self._readings.frozen:
            return look()
        # As text: what a skill is given need not know how to be compared.
        return self._glance.see(repr(self._question or key), key, look)

    def _note_missing(self, device: str) -> None:
        if self.observer and self._skill and device not in self._noted:
            self._noted.add(device)
            self.observer.missing(self._skill, device)

    def _snapshot(self) -> AbstractContextManager[None]:
        return self._readings.snapshot()

    # Endings: atexit answers the program's end, errors and Ctrl-C; SIGTERM alone would skip it.

    def _watch_endings(self) -> None:
        atexit.register(self.stop)
        if _may_handle_sigterm():
            signal.signal(signal.SIGTERM, _exit_on_sigterm)

    def _forget_endings(self) -> None:
        atexit.unregister(self.stop)


def _pace(kind: type[Device], key: object) -> str:
    """Pictures take long to look at: no other sensor waits for a camera."""
    return f"camera {key}" if kind is Camera else SENSORS


def _may_handle_sigterm() -> bool:
    return (
        threading.current_thread() is threading.main_thread()
        and signal.getsignal(signal.SIGTERM) is signal.SIG_DFL
    )


def _exit_on_sigterm(number: int, frame: FrameType | None) -> NoReturn:  # noqa: ARG001
    """End as Python does on an error: `finally` and atexit run, and the robot is stopped."""
    raise SystemExit(128 + number)
