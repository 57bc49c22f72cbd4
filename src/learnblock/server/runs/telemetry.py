"""The world as the page is told of it."""

from typing import TYPE_CHECKING

import msgspec

from learnblock.server import messages

if TYPE_CHECKING:
    from learnblock.robots.picture import Picture
    from learnblock.robots.stage import Stage


def scene(stage: "Stage") -> messages.Scene:
    """What stands there."""
    return msgspec.convert(stage.scene(), messages.Scene, from_attributes=True)


def telemetry(stage: "Stage", block: str | None) -> messages.Telemetry:
    """How it is now, while `block` runs."""
    state = stage.state()
    return messages.Telemetry(
        time=state.time,
        robots=msgspec.convert(state.robots, tuple[messages.Robot, ...], from_attributes=True),
        pushed=state.pushed,
        sensors=state.sensors,
        block=block,
        goals=msgspec.convert(state.goals, tuple[messages.GoalNow, ...], from_attributes=True),
    )


def sounds(stage: "Stage") -> tuple[messages.Sound, ...]:
    """What was to be heard since this was last asked."""
    return tuple(messages.Sound(one.device, one.action, one.values) for one in stage.sounds())


def camera_frame(picture: "Picture") -> messages.CameraFrame:
    """What is said before the picture itself."""
    seen = msgspec.convert(picture.seen, tuple[messages.Seen, ...], from_attributes=True)
    return messages.CameraFrame(picture.width, picture.height, picture.time, seen)
