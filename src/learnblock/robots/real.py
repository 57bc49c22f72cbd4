"""The base class of all real robots."""

import importlib
import inspect
import re
from collections.abc import Callable, Collection, Iterator, Mapping
from contextlib import ExitStack, suppress
from functools import partial
from importlib.util import find_spec
from types import ModuleType
from typing import Any, ClassVar, Generic

from learnblock.client import Client, Observer, Outcome, Rights
from learnblock.client.clock import Clock
from learnblock.client.notebooks import current_notebook
from learnblock.devices import Base, Pose
from learnblock.errors import LearnBlockError, MissingPackageError, NotWrittenError, SettingsError
from learnblock.i18n import Phrase
from learnblock.installation import add_on, requirements
from learnblock.robots import settings as user_settings
from learnblock.robots.calibration import Calibration
from learnblock.robots.settings import SettingsT
from learnblock.timing import MONOTONIC, SteadyClock
from learnblock.wheels import Drivetrain


class RealRobot(Client, Generic[SettingsT]):
    """A robot that is connected by a cable, by radio or over a network.

        class Robot(RealRobot[MySettings]):
            settings_type = MySettings

            def connect(self):
                self.link = Link(self.settings.address, self.settings.port)
                self.add(Base(move=self.link.drive))

            def disconnect(self):
                self.link.close()

    Args:
        skills: as for `Client`.
        clock: as for `Client`.
        observer: as for `Client`.
        steady_clock: the clock of the driver's threads; another one in tests.
        settings: by name; they override those in the user's file.

    Raises:
        SettingsError: a setting is invalid.
        RobotConnectionError: the robot cannot be reached.
    """

    #: The settings of such a robot.
    settings_type: ClassVar[type[Any]]
    #: The settings that correct how far it drives and turns; None for a robot that needs none.
    calibration: ClassVar[Calibration | None] = None
    #: The modules that it needs and that only its add-on installs.
    add_on: ClassVar[tuple[str, ...]] = ()
    #: The voltages of its empty and its full battery; None if it does not report the voltage.
    battery_range: ClassVar[tuple[float, float] | None] = None

    #: How long `scan` may take on the page, in seconds; at most 5 for slow ones, as by Bluetooth.
    scan_seconds: ClassVar[float] = 2.0

    #: Where it was when its motors were stopped; None if it does not know.
    _end: Pose | None = None

    def __init__(
        self,
        *,
        skills: Collection[str] | None = None,
        clock: Clock | None = None,
        observer: Observer | None = None,
        steady_clock: SteadyClock = MONOTONIC,
        **settings: Any,
    ) -> None:
        self.steady_clock = steady_clock
        self.settings: SettingsT = user_settings.load(self.name(), self.settings_type, settings)
        if skills is None and (notebook := current_notebook()):
            notebook.make_room(self)
        super().__init__(skills=skills, clock=clock, observer=observer)

    @classmethod
    def name(cls) -> str:
        """The robot's id, such as ``cozmo``."""
        return cls.__module__.rpartition(".")[2].replace("_", "-")

    @classmethod
    def missing_add_on(cls) -> str:
        """The command that installs the packages that it needs; empty if they are installed."""
        is_complete = all(find_spec(module) for module in cls.add_on)
        return "" if is_complete else add_on(cls.name())

    @classmethod
    def drivetrain(cls) -> Drivetrain | None:
        """What its wheels can do by the saved settings."""
        try:
            return cls.drivetrain_for(user_settings.load(cls.name(), cls.settings_type))
        except SettingsError:
            # It is raised when the robot is created.
            return None

    @classmethod
    def drivetrain_for(cls, settings: SettingsT) -> Drivetrain | None:
        """What its wheels can do with these settings; None if that is unknown."""
        del settings
        return None

    @classmethod
    def known_rights(cls) -> Rights:
        return super().known_rights() | Rights(devices=cls._chosen_devices())

    @classmethod
    def _chosen_devices(cls) -> tuple[str, ...]:
        """The device files in the user's settings, which a program cannot change."""
        try:
            saved = user_settings.load(cls.name(), cls.settings_type)
        except SettingsError:
            # It is raised when the robot is created.
            return ()
        values = (getattr(saved, name) for name in saved.__struct_fields__)
        return tuple(value for value in values if isinstance(value, str) and value.startswith("/"))

    @classmethod
    def scan(cls, seconds: float) -> Iterator[Mapping[str, Any]]:  # noqa: ARG003 - for subclasses
        """Look for such robots, and yield the settings for reaching each of them.

        The page repeats this every few seconds, so it must not move a robot.

        Args:
            seconds: the time limit.
        """
        yield from ()

    @classmethod
    def is_in_use(cls) -> bool:
        """Whether `scan` leaves the robot out, because looking for it would disturb its user."""
        return False

    def outcome(self) -> Outcome:
        """The final pose as `get_pose` knows it; the way to it is not measured."""
        return Outcome(pose=self._end)

    def _stop_motors(self) -> None:
        with ExitStack() as stack:
            # Asked while the link is still there.
            stack.callback(self._note_end)
            super()._stop_motors()

    def _note_end(self) -> None:
        bases = (device for _, device in self.devices() if isinstance(device, Base))
        base = next(bases, None)
        if base is None or self.link_error:
            return
        with suppress(LearnBlockError):
            x, y, heading = base.pose()
            self._end = round(x, 3), round(y, 3), round(heading, 3)

    def surroundings(self) -> Mapping[str, object]:
        if self.calibration is None:
            return {}
        names = {"distance": self.calibration.distance, "angle": self.calibration.angle}
        sizes = self.calibration.sizes(self.settings)
        return {"calibration": {**names, "sizes": sizes}}

    @classmethod
    def halt(cls, settings: SettingsT) -> None:
        """Stop the motors of a robot whose program is gone; only a `guardian` calls this.

        Args:
            settings: how to reach the robot.

        Raises:
            RobotConnectionError: the robot cannot be reached.
        """
        raise NotImplementedError(f"{cls.name()} has a watchdog, so it needs no guardian")

    @classmethod
    def standby(cls, settings: SettingsT) -> Callable[[], object]:
        """What a guardian calls to stop the motors, having prepared what would take too long then.

        Args:
            settings: how to reach the robot.
        """
        return partial(cls.halt, settings)

    @classmethod
    def set_up(cls, settings: SettingsT, report: Callable[[Phrase], object]) -> None:  # noqa: ARG003
        """Install what LearnBlock needs on the robot.

        Args:
            settings: how to reach the robot.
            report: called with each step.

        Raises:
            LearnBlockError: the robot needs no setup, or it failed.
        """
        raise LearnBlockError("robot-needs-no-setup", name=cls.name())


def require(package: str, robot: str) -> ModuleType:
    """Import a library that only this robot needs.

    Raises:
        MissingPackageError: it is not installed.
    """
    try:
        return importlib.import_module(package)
    except ModuleNotFoundError as error:
        if error.name != package.partition(".")[0]:
            raise
        if requirements(robot):
            command = add_on(robot)
            raise MissingPackageError(
                "robot-missing-add-on", robot=robot, command=command
            ) from None
        raise MissingPackageError("robot-missing-package", robot=robot, package=package) from None


def not_written(function: Callable[..., Any], *arguments: object) -> NotWrittenError:
    """The error for a function that is not written yet, as generated by `learnblock new`.

        def heading(self) -> float:
            'Return how far the robot has turned, degrees, clockwise.'
            raise not_written(self.heading)

    Args:
        function: the function; its docstring describes the task.
        arguments: the arguments of the call.
    """
    code = inspect.unwrap(function).__code__
    task = re.split(r"\n\s*(?:Args|Raises|Returns):\n", inspect.getdoc(function) or "")[0]
    return NotWrittenError(
        "robot-not-written",
        file=code.co_filename,
        line=str(code.co_firstlineno),
        call=f"{function.__name__}({', '.join(map(repr, arguments))})",
        task=" ".join(task.split()),
    )
