"""Which way a brick is reached: the one that was chosen, or the first that is open."""

from collections.abc import Callable
from time import monotonic, sleep

import msgspec

from learnblock.robots.ev3.agent_link import AgentLink
from learnblock.robots.ev3.brick import NoSuchWayError, State, TakenError
from learnblock.robots.ev3.direct_link import DirectLink
from learnblock.robots.ev3.link import Link
from learnblock.robots.ev3.network import resolve
from learnblock.robots.ev3.rpyc_link import RpycLink
from learnblock.robots.ev3.settings import Settings

#: Seconds for which a brick that is used by another program is asked again: it lets go of one that
#: has been silent for 1.5.
PATIENCE = 1.8

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
        way = _WAYS[settings.connection]
    else:
        way = DirectLink if settings.device else _first_open
    return _when_free(lambda: way(settings, told))


def _when_free(attempt: Callable[[], Link]) -> Link:
    """A brick does not always notice at once that its last program is gone."""
    deadline = monotonic() + PATIENCE
    while True:
        try:
            return attempt()
        except TakenError:
            if monotonic() > deadline:
                raise
        sleep(0.2)


def _first_open(settings: Settings, told: Callable[[State], None]) -> Link:
    number = resolve(settings.address, settings.patience)
    # Together they take no longer than one may.
    hasty = msgspec.structs.replace(
        settings, address=number, patience=settings.patience / len(_WAYS)
    )
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
