"""Conversion of a robot's monitor to messages for the page."""

from typing import TYPE_CHECKING

import msgspec

from learnblock.server import messages

if TYPE_CHECKING:
    from learnblock.monitor import Monitor, RobotNow
    from learnblock.monitor.monitor import State
    from learnblock.monitor.pictures import Picture


def scene(monitor: "Monitor") -> messages.Scene:
    """The unchanging parts of its world."""
    return msgspec.convert(monitor.scene(), messages.Scene, from_attributes=True)


def telemetry(monitor: "Monitor") -> messages.Telemetry:
    """Its current state."""
    return of_state(monitor.state())


def of_state(state: "State") -> messages.Telemetry:
    """A state, be it the current one or one of the past."""
    return messages.Telemetry(
        time=state.time,
        robots=tuple(map(_robot, state.robots)),
        pushed=state.pushed,
        sensors=msgspec.convert(state.sensors, tuple[messages.Sensor, ...], from_attributes=True),
        goals=msgspec.convert(state.goals, tuple[messages.GoalNow, ...], from_attributes=True),
    )


def link(monitor: "Monitor") -> messages.RobotLink:
    """Its link, rounded so that noise is not reported."""
    now = monitor.link()
    return messages.RobotLink(now.state.value, _rounded(now.battery), _rounded(now.quality))


def sounds(monitor: "Monitor") -> tuple[messages.Sound, ...]:
    """The sounds since the last call."""
    return tuple(messages.Sound(one.device, one.action, one.values) for one in monitor.sounds())


def camera_frame(picture: "Picture", *, past: bool = False) -> messages.CameraFrame:
    """The message that precedes the picture itself."""
    seen = msgspec.convert(picture.seen, tuple[messages.Seen, ...], from_attributes=True)
    return messages.CameraFrame(picture.width, picture.height, picture.time, seen, past)


def _robot(now: "RobotNow") -> messages.Robot:
    # A robot whose position is unknown is drawn in the middle.
    x, y, heading = now.pose or (0.0, 0.0, 0.0)
    return messages.Robot(
        name=now.name,
        x=x,
        y=y,
        heading=heading,
        located=now.pose is not None,
        joints=now.joints,
        leds=now.leds,
        emotion=now.emotion,
        speed=now.speed,
        text=now.text,
    )


def _rounded(value: float | None) -> float | None:
    return None if value is None else round(value, 1)
