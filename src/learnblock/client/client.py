"""The generic client: base class of every robot."""

import threading
from collections.abc import Callable, Collection, Hashable, Iterable, Iterator
from contextlib import ExitStack, contextmanager
from enum import Enum, auto
from types import MethodType, TracebackType
from typing import TYPE_CHECKING, Any, ClassVar, Self, TypeVar

from learnblock import senses
from learnblock.client import endings
from learnblock.client import skills as skill_registry
from learnblock.client.announced import Announced
from learnblock.client.clock import Clock, WallClock
from learnblock.client.driver import Driver
from learnblock.client.events import Events
from learnblock.client.game import Game, OwnPlay
from learnblock.client.keyboard import Keyboard
from learnblock.client.mailbox import Mailbox
from learnblock.client.notebooks import InNotebook
from learnblock.client.observers import Observer, Witness
from learnblock.client.operations import Operations
from learnblock.client.readings import (
    READING,
    SENSORS,
    Glance,
    PolledReadings,
    Readings,
    SteppedReadings,
)
from learnblock.client.reckoning import Reckoning
from learnblock.client.senses import Senses
from learnblock.client.unseen import UnseenTexts
from learnblock.devices import (
    DEFAULT_KEY,
    FIRST_KEY,
    Base,
    Camera,
    Device,
    Reading,
    Sensor,
)
from learnblock.errors import (
    KeyTakenError,
    RobotAttributeError,
    RobotConnectionError,
    RobotStoppedError,
    nearest,
)

D = TypeVar("D", bound=Device)


class ClientState(Enum):
    """The state of a client."""

    CONNECTING = auto()
    CONNECTED = auto()
    STOPPED = auto()


class Client(Announced, Driver, Events, InNotebook):
    """A robot as programs see it: its skills are methods, and its hardware is hidden.

    A new robot is a subclass that connects, disconnects and adds its devices:

        class Robot(Client):
            def connect(self):
                self.port = open_port("/dev/ttyUSB0")
                self.add(Base(move=self.port.drive))

            def disconnect(self):
                self.port.close()

    The constructor connects the robot. It is disconnected exactly once, after its motors have
    stopped: by `stop`, at the end of a ``with``, or when the program ends, even after an error,
    Ctrl-C or SIGTERM.

    Args:
        skills: the names of the skills that the program uses; None means all skills.
        clock: the robot's time; the wall clock by default.
        observer: records calls, and skills without effect.

    Raises:
        RobotConnectionError: the robot cannot be reached.
    """

    #: Whether the robot's world waits for the program; True for simulated robots only.
    lockstep: ClassVar[bool] = False
    #: Seconds between readings of a sensor in use; if None, it is read whenever the program asks.
    sensing_period: ClassVar[float | None] = READING
    #: The simulated robot whose picture is used for it, such as ``ebo``; "" for a plain body.
    model: ClassVar[str] = ""

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
        #: The skill in use with its arguments.
        self._question: tuple[object, ...] | None = None
        self._noted: set[str] = set()
        self._state = ClientState.CONNECTING
        # Asked for at each use of a device, which comparing states would slow down.
        self._is_stopped = False
        self._stopping = threading.Lock()
        #: Why the robot can no longer be reached; None while it can.
        self.link_error: RobotConnectionError | None = None
        self._readings = self._make_readings()
        self._glance = Glance(self.clock)
        #: The texts that it has no screen for.
        self.unseen = UnseenTexts()
        #: Messages from and to the other robots of the run.
        self.mailbox = Mailbox()
        #: The keyboard of the computer that runs the program.
        self.keyboard = Keyboard()
        #: The game that it plays; without a world, it keeps its own.
        self._own_play = OwnPlay(self.clock.time)
        self.game = Game(self._own_play)
        self.senses = Senses(self)
        #: What its driver calls by name.
        self.operations = Operations()
        #: What the program's questions have found in the camera's picture, by detector.
        self.detected: dict[str, Any] = {}
        #: When the program's timer was last at 0, in seconds of the robot's time.
        self.timer_start = 0.0
        #: Beats per minute of the notes that the program plays.
        self.tempo = 120.0
        self._equipment: frozenset[str] | None = None
        self._attach(skills)
        self._connect()
        self._join_notebook(is_hosted=skills is not None)

    def require_link(self) -> None:
        """Call `check_link`, and keep its error for observers of the robot.

        Raises:
            RobotConnectionError: the link to the robot broke.
        """
        try:
            self.check_link()
        except RobotConnectionError as error:
            self.link_error = error
            raise

    @property
    def readings(self) -> Readings:
        """The latest readings of its sensors."""
        return self._readings

    # Devices.

    def add(self, device: Device, key: str = DEFAULT_KEY) -> None:
        """Add a device to the robot.

        Raises:
            KeyTakenError: there is already one of the same type with the same key.
        """
        same = self._devices.setdefault(type(device), {})
        if key in same:
            raise KeyTakenError("robot-key-taken", device=type(device).__name__, key=key)
        same[key] = device
        self._equipment = None
        if isinstance(device, Base) and not device.has_odometry:
            reckoning = Reckoning(device.functions["move"], self.clock, device.drivetrain)
            device.functions |= {"move": reckoning.move, "read": reckoning.pose}

    def devices(self) -> Iterator[tuple[str, Device]]:
        """Every device with its key."""
        for same in self._devices.values():
            yield from same.items()

    @property
    def equipment(self) -> frozenset[str]:
        """The names of its devices (``Type:KEY``), their types, and their abilities."""
        if self._equipment is None:
            names = (f"{type(device).__name__}:{key}" for key, device in self.devices())
            self._equipment = senses.equipment(names, self.abilities())
        return self._equipment

    def has(self, kind: type[Device], key: str = DEFAULT_KEY) -> bool:
        """Whether the robot has this device; a missing one is not reported."""
        return key in self._devices.get(kind, ())

    def device(self, kind: type[D], key: str = DEFAULT_KEY) -> D | None:
        """The device of this type and key, or None if the robot does not have it.

        The key ``first`` asks for the one that the driver added first.

        A missing device is reported to the observer once for each call of a skill.

        Raises:
            RobotStoppedError: the robot is disconnected.
        """
        if self._is_stopped:
            raise RobotStoppedError("robot-stopped")
        if not self._readings.frozen:
            self.clock.charge()
        try:
            return self._devices[kind][key]  # type: ignore[return-value] # filed under its type
        except KeyError:
            same = self._devices.get(kind)
            if same and key == FIRST_KEY:
                return next(iter(same.values()))  # type: ignore[return-value] # as above
            self.note_missing(f"{kind.__name__}:{key}")
            return None

    def read(self, kind: "type[Sensor[Reading]]", key: str = DEFAULT_KEY) -> Reading | None:
        """The latest reading of a sensor, or None on a robot without it."""
        sensor = self.device(kind, key)
        if sensor is None:
            return None
        pace = _pace(kind, key)
        self.await_reading((kind, key), pace)
        reading: Reading = self._readings.latest((kind, key), sensor.read, pace)
        return reading

    def detect(self, name: str, key: str = DEFAULT_KEY) -> Any:
        """The result of the detector `name` for the camera's latest frame.

        None without a camera, before the first frame, or if there is no such detector.
        """
        camera = self.device(Camera, key)
        if camera is None:
            return None
        detection = self._seen((Camera, key, name), lambda: camera.detect(name))
        if detection is None:
            self.note_missing(f"Detector:{name}")
        else:
            self.detected[name] = detection
        return detection

    def await_reading(self, subject: Hashable, pace: str = SENSORS) -> None:
        """Wait for a new reading if the present one has already answered this question.

        The question is the skill in use with its arguments; only a simulated robot waits.

        Args:
            subject: what is asked about, for a program that asks without a skill.
            pace: the pace of the sensor, see `Readings.latest`.
        """
        self._readings.ask(self._question or (subject,), pace)

    def forget_readings(self) -> None:
        """Read the sensors again at the next query, for example after a gyroscope reset."""
        self._readings.forget()

    # Skills.

    def learn(self, function: Callable[..., Any]) -> None:
        """Add a function of the program as a skill; its first argument is the robot.

            def waltz(robot, times=3): ...

            robot.learn(waltz)
            robot.waltz(2)

        Raises:
            KeyTakenError: every robot already has an attribute with this name.
        """
        name = function.__name__
        if hasattr(Client, name):
            raise KeyTakenError("robot-skill-name-taken", name=name)
        setattr(self, name, self._method(name, function))

    # Time.

    def time(self) -> float:
        """Seconds since the robot was connected, in the robot's time."""
        self.clock.charge()
        return self.clock.time()

    # The end.

    @property
    def stopped(self) -> bool:
        return self._is_stopped

    def stop(self) -> None:
        """Stop the motors and disconnect; calling it twice is harmless."""
        # Everything on the stack runs, the last entry first, even if one fails or is interrupted.
        with ExitStack() as ending, self._stopping:
            if self._state is ClientState.STOPPED:
                return
            ending.callback(self._close_cameras)
            ending.callback(self.disconnect)
            ending.callback(self._readings.close)
            ending.callback(endings.forget, self.stop)
            if self._state is ClientState.CONNECTED:
                ending.callback(self._stop_motors)
            self._state = ClientState.STOPPED
            self._is_stopped = True

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
        kind, state = type(self), self._state.name.lower()
        return f"<{kind.__module__}.{kind.__name__} {state}: {names}>"

    def __dir__(self) -> Iterable[str]:
        # A program's process attaches only the skills that the program mentions.
        return {*super().__dir__(), *skill_registry.find()}

    # Type checkers know the skills of each robot: see `learnblock.client.skill_sets`.
    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> Any:
            # Reached only for names that are neither methods nor skills in use: a skill may call
            # another skill that its program does not mention.
            if name.startswith("_"):
                raise AttributeError(name)
            self._attach({name})
            if name in vars(self):
                return vars(self)[name]
            known = [known for known in super().__dir__() if not known.startswith("_")]
            suggestion = nearest(name, known)
            if suggestion is None:
                raise RobotAttributeError("robot-unknown-skill", name=name)
            raise RobotAttributeError("robot-unknown-skill-like", name=name, suggestion=suggestion)

    def observe(self, witness: Witness) -> None:
        self._own_play.witness = witness

    # Helpers of the methods above.

    def _make_readings(self) -> Readings:
        if self.clock.instant is not None:
            return SteppedReadings(self.clock)
        if self.sensing_period is None:
            return Readings(self.clock)
        return PolledReadings(self.clock, self.sensing_period)

    def _connect(self) -> None:
        endings.call_at_end(self.stop)
        try:
            self.connect()
            if self.has_extra_camera:
                self._add_extra_camera()
        except BaseException as error:
            self._give_up(error)
            raise
        self._state = ClientState.CONNECTED

    def _give_up(self, error: BaseException) -> None:
        """Disconnect a half-connected robot without hiding the error that interrupted `connect`."""
        try:
            self.stop()
        except Exception as another:  # noqa: BLE001 - `disconnect` may need missing parts
            error.add_note(f"Disconnecting failed too: {type(another).__name__}: {another}")

    def _stop_motors(self) -> None:
        """Stop every base, even after one of them fails."""
        with ExitStack() as stack:
            for _, device in self.devices():
                if isinstance(device, Base):
                    stack.callback(device.stop)

    def _add_extra_camera(self) -> None:
        from learnblock.client.extra_camera import WEBCAM, extra_source  # noqa: PLC0415 - slow

        source = extra_source(self.clock.time)
        if source is not None:
            camera = Camera(read=source.read, close=source.close)
            self.add(camera, WEBCAM)
            # On a robot without a built-in camera it is also the default camera.
            self._devices[Camera].setdefault(DEFAULT_KEY, camera)

    def _close_cameras(self) -> None:
        for _, device in self.devices():
            if isinstance(device, Camera):
                device.close()

    def _attach(self, names: Collection[str] | None) -> None:
        for name, function in skill_registry.find(names).items():
            # Skills of users and plugins do not hide the methods of every robot; the check warns
            # their authors.
            if not hasattr(Client, name) and name not in vars(self):
                setattr(self, name, self._method(name, function))

    def _method(self, name: str, function: Callable[..., Any]) -> Callable[..., Any]:
        def skill(robot: Client, /, *args: Any, **kwargs: Any) -> Any:
            if robot._skill is not None:
                return function(robot, *args, **kwargs)
            robot._skill, robot._question = name, (name, args, kwargs)
            robot._noted.clear()
            try:
                if robot.observer:
                    robot.observer.called(name, args, kwargs)
                return function(robot, *args, **kwargs)
            finally:
                robot._skill = robot._question = None

        skill.__name__ = skill.__qualname__ = name
        skill.__doc__, skill.__module__ = function.__doc__, function.__module__
        # Editors, `help` and `inspect` show the signature of the function, without the robot.
        skill.__wrapped__ = function  # type: ignore[attr-defined]
        return MethodType(skill, self)

    def _seen(self, key: tuple[object, ...], detect: Callable[[], Any]) -> Any:
        """The detector's result for the newest picture, or that of the previous query."""
        pace = _pace(Camera, key[1])

        def look() -> Any:
            self.await_reading(key, pace)
            return self._readings.latest(key, detect, pace)

        if self.clock.instant is not None or self._readings.frozen:
            return look()
        # As text, since a skill's arguments may not be comparable.
        return self._glance.see(repr(self._question or key), key, look)

    def note_missing(self, device: str) -> None:
        """Report to the observer that the skill in use has no effect without a device.

        Args:
            device: such as ``Camera:ROBOT`` or ``DistanceSensors:left``.
        """
        if self.observer and self._skill and device not in self._noted:
            self._noted.add(device)
            self.observer.missing(self._skill, device)

    @contextmanager
    def _snapshot(self) -> Iterator[None]:
        with self._readings.snapshot(), self.mailbox.snapshot(), self.game.snapshot():
            yield

    def _begin_pass(self) -> None:
        self._readings.forget_questions()


def _pace(kind: type[Device], key: object) -> str:
    """The pace of a sensor: cameras have their own, because detection is slow."""
    return f"camera {key}" if kind is Camera else SENSORS
