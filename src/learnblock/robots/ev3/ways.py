"""Which way a brick is reached: the one that was chosen, or the first that is open."""

from collections.abc import Callable

import msgspec

from learnblock.robots.ev3.agent_link import AgentLink
from learnblock.robots.ev3.brick import NoSuchWayError, State
from learnblock.robots.ev3.direct_link import DirectLink
from learnblock.robots.ev3.link import Link
from learnblock.robots.ev3.rpyc_link import RpycLink
from learnblock.robots.ev3.settings import Settings

_WAYS: dict[str, Callable[[Settings, Callable[[State], None]], Link]] = {
    "agent": AgentLink,
    "rpyc": RpycLink,
    "direct": DirectLink,
}


def find_way(settings: Settings, told: Callable[[State], None]) -> Link:
    """A way to the brick, open.

    Args:
        settings: of the robot.
        told: is given each new state.

    Raises:
        RobotConnectionError: there is none; the sentence says what was tried.
    """
    if settings.connection != "auto":
        return _WAYS[settings.connection](settings, told)
    if settings.device:
        return DirectLink(settings, told)
    return _first_open(settings, told)


def _first_open(settings: Settings, told: Callable[[State], None]) -> Link:
    # Together they take no longer than one may.
    hasty = msgspec.structs.replace(settings, patience=settings.patience / len(_WAYS))
    refusals = []
    for name, way in _WAYS.items():
        try:
            return way(hasty, told)
        except NoSuchWayError as error:
            refusals.append(f"{name}: {error}")
    raise NoSuchWayError(
        f"no EV3 is found at {settings.address}: is it switched on, and this computer in its"
        f" network? Tried were {'; '.join(refusals)}"
    )
