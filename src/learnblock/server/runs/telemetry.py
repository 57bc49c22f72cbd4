"""Conversion of a robot's monitor to messages for the page."""

from typing import TYPE_CHECKING

from msgspec.structs import asdict

from learnblock.server import messages

if TYPE_CHECKING:
    from learnblock.monitor import Monitor
    from learnblock.monitor.monitor import State
    from learnblock.monitor.pictures import Picture


def scene(monitor: "Monitor") -> messages.Scene:
    """The unchanging parts of its world."""
    return messages.Scene(**asdict(monitor.scene()))


def telemetry(monitor: "Monitor") -> messages.Telemetry:
    """Its current state."""
    return messages.Telemetry(**asdict(monitor.state()), found=monitor.found())


def of_state(state: "State") -> messages.Telemetry:
    """A state, be it the current one or one of the past."""
    return messages.Telemetry(**asdict(state))


def link(monitor: "Monitor") -> messages.RobotLink:
    """Its link, rounded so that noise is not reported."""
    now = monitor.link()
    return messages.RobotLink(now.state, _rounded(now.battery), _rounded(now.quality))


def sounds(monitor: "Monitor") -> tuple[messages.Sound, ...]:
    """The sounds since the last call."""
    return tuple(messages.Sound(one.device, one.action, one.values) for one in monitor.sounds())


def camera_frame(picture: "Picture", *, past: bool = False) -> messages.CameraFrame:
    """The message that precedes the picture itself."""
    return messages.CameraFrame(picture.width, picture.height, picture.time, picture.seen, past)


def _rounded(value: float | None) -> float | None:
    return None if value is None else round(value, 1)
