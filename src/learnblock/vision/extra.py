"""The camera that the user has added to every robot: the computer's webcam, or a video."""

from collections.abc import Callable
from typing import TYPE_CHECKING, Protocol

from learnblock.devices import DEFAULT_KEY
from learnblock.home import home
from learnblock.vision.settings import TABLE

if TYPE_CHECKING:
    from learnblock.perception.frames import Frame

#: Its key among a robot's cameras.
WEBCAM = "webcam"


class Source(Protocol):
    """Where pictures come from."""

    def read(self) -> "Frame | None":
        """The newest picture."""

    def close(self) -> None:
        """Let go of it; the second time it does nothing."""


def extra_source(time: Callable[[], float]) -> Source | None:
    """What the settings add, which is not opened yet; None if they add nothing.

    Args:
        time: answers the robot's time, s.

    Raises:
        SettingsError: the settings of perception are wrong.
    """
    settings = TABLE.load()
    if settings.video:
        from learnblock.vision.recording import Recording  # noqa: PLC0415 - it loads OpenCV

        return Recording(home() / settings.video, time)
    if settings.webcam != "none":
        from learnblock.vision.webcam import Webcam  # noqa: PLC0415 - as above

        return Webcam(settings.webcam)
    return None


def extra_devices(names: frozenset[str]) -> frozenset[str]:
    """What the settings add to a robot that has the devices of those names (``Type:KEY``).

    A robot without a camera of its own looks through the one that is added.

    Raises:
        SettingsError: the settings of perception are wrong.
    """
    settings = TABLE.load()
    if not settings.video and settings.webcam == "none":
        return frozenset()
    return frozenset({f"Camera:{WEBCAM}", f"Camera:{DEFAULT_KEY}"}) - names
