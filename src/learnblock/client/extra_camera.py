"""The camera that the user's settings add to every robot: the computer's webcam, or a video."""

from collections.abc import Callable
from typing import TYPE_CHECKING, Protocol

from learnblock.client.rights import Rights
from learnblock.devices import DEFAULT_KEY
from learnblock.perception.settings import TABLE
from learnblock.storage.home import home

if TYPE_CHECKING:
    from learnblock.perception.frames import Frame

#: Its key among a robot's cameras.
WEBCAM = "webcam"


class PictureSource(Protocol):
    """A source of pictures."""

    def read(self) -> "Frame | None":
        """The newest picture."""

    def close(self) -> None:
        """Close it; calling it twice is harmless."""


def extra_source(time: Callable[[], float]) -> PictureSource | None:
    """The source that the settings add, not opened yet; None if they add none.

    Args:
        time: returns the robot's time in seconds.

    Raises:
        SettingsError: the camera recognition settings are invalid.
    """
    settings = TABLE.load()
    if settings.video:
        from learnblock.perception.sources.recording import Recording  # noqa: PLC0415 - slow

        return Recording(home() / settings.video, time)
    if settings.webcam != "none":
        from learnblock.perception.sources.webcam import Webcam  # noqa: PLC0415 - as above

        return Webcam(settings.webcam)
    return None


def extra_devices(names: frozenset[str]) -> frozenset[str]:
    """The devices that the settings add to a robot with these devices (``Type:KEY``).

    On a robot without a built-in camera the added one is also the default camera.

    Raises:
        SettingsError: the camera recognition settings are invalid.
    """
    settings = TABLE.load()
    if not settings.video and settings.webcam == "none":
        return frozenset()
    return frozenset({f"Camera:{WEBCAM}", f"Camera:{DEFAULT_KEY}"}) - names


def extra_rights() -> Rights:
    """The rights of the camera and the components for recognition that the settings choose.

    Raises:
        SettingsError: the camera recognition settings are invalid.
    """
    settings = TABLE.load()
    return Rights(
        network=bool(settings.apriltag or settings.emotionrecognition),
        devices=() if settings.webcam == "none" else ("/dev/video*",),
    )
