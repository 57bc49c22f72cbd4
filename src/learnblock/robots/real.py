"""What the clients of real robots share."""

import importlib
import inspect
import re
from collections.abc import Callable, Collection, Iterator, Mapping
from types import ModuleType
from typing import Any, ClassVar, Generic

from learnblock.client import Client, Observer
from learnblock.clock import Clock
from learnblock.errors import LearnBlockError, MissingPackageError, NotWrittenError
from learnblock.robots import settings as user_settings
from learnblock.robots.settings import SettingsT


class RealRobot(Client, Generic[SettingsT]):
    """A robot that is reached over a wire.

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
        chosen: settings by their names, which go before those in the user's file.

    Raises:
        SettingsError: a setting is wrong.
        RobotConnectionError: the robot cannot be reached.
    """

    #: What can be set about such a robot.
    settings_type: ClassVar[type[Any]]

    def __init__(
        self,
        *,
        skills: Collection[str] | None = None,
        clock: Clock | None = None,
        observer: Observer | None = None,
        **chosen: Any,
    ) -> None:
        self.settings: SettingsT = user_settings.load(self.name(), self.settings_type, chosen)
        super().__init__(skills=skills, clock=clock, observer=observer)

    @classmethod
    def name(cls) -> str:
        """Its id, such as ``cozmo``."""
        return cls.__module__.rpartition(".")[2].replace("_", "-")

    @classmethod
    def scan(cls, seconds: float) -> Iterator[Mapping[str, Any]]:  # noqa: ARG003 - for who can look
        """Look for such robots; answer the settings with which each one is reached.

        Args:
            seconds: no longer than that.
        """
        yield from ()

    @classmethod
    def halt(cls, settings: SettingsT) -> None:
        """Stop the motors of a robot whose program is gone: for a `guardian` alone.

        Args:
            settings: how it is reached.

        Raises:
            RobotConnectionError: it cannot be reached.
        """
        raise NotImplementedError(f"the robot `{cls.name()}` has a watchdog of its own")

    @classmethod
    def set_up(cls, settings: SettingsT, tell: Callable[[str], object]) -> None:  # noqa: ARG003
        """Put on the robot what we need there.

        Args:
            settings: how it is reached.
            tell: is told what is being done, a sentence at a time.

        Raises:
            LearnBlockError: there is nothing to put there, or it cannot be.
        """
        raise LearnBlockError(f"the robot `{cls.name()}` needs nothing to be set up")


def require(package: str, robot: str) -> ModuleType:
    """Import a library that one robot alone needs.

    Raises:
        MissingPackageError: it is not installed; the sentence says how to install it.
    """
    try:
        return importlib.import_module(package)
    except ModuleNotFoundError as error:
        if error.name != package.partition(".")[0]:
            raise
        raise MissingPackageError(
            f"the robot `{robot}` needs the package {package}:"
            f" pip install 'learnblock-studio[{robot}]'"
        ) from None


def not_written(function: Callable[..., Any], *given: object) -> NotWrittenError:
    """What a function that its author has still to fill in raises, as `learnblock new` writes it.

        def heading(self) -> float:
            'Answer how far the robot has turned, degrees, clockwise.'
            raise not_written(self.heading)

    Args:
        function: its docstring says what it must do.
        given: what it was called with.
    """
    code = inspect.unwrap(function).__code__
    task = re.split(r"\n\s*(?:Args|Raises|Returns):\n", inspect.getdoc(function) or "")[0]
    must = " ".join(task.split())
    call = f"{function.__name__}({', '.join(map(repr, given))})"
    return NotWrittenError(
        f"{code.co_filename}:{code.co_firstlineno}: `{call}` is not written yet; what it must do:"
        f" {must}"
    )
