"""Opens the connection to a brick: the chosen kind, or the first kind that works."""

from collections.abc import Callable, Sequence

import msgspec

from learnblock.errors import RobotBusyError, RobotNotFoundError
from learnblock.robots.ev3.agent_link import AgentLink
from learnblock.robots.ev3.brick import State
from learnblock.robots.ev3.direct_link import DirectLink
from learnblock.robots.ev3.link import BrickLink
from learnblock.robots.ev3.network import resolve
from learnblock.robots.ev3.rpyc_link import RpycLink
from learnblock.robots.ev3.settings import Settings
from learnblock.timing import MONOTONIC, Deadline, SteadyClock

#: Seconds for which to retry a busy brick: it drops a client after 1.5 seconds of silence.
TIMEOUT = 1.8
#: Seconds between two attempts.
PAUSE = 0.2

_LINKS: dict[str, Callable[[Settings, Callable[[State], None], SteadyClock], BrickLink]] = {
    "agent": AgentLink,
    "rpyc": RpycLink,
    "direct": DirectLink,
}


def open_link(
    settings: Settings, on_state: Callable[[State], None], clock: SteadyClock = MONOTONIC
) -> BrickLink:
    """Connect to the brick.

    Args:
        settings: the robot's settings.
        on_state: called with each new state.
        clock: the clock of its periods and limits.

    Raises:
        RobotConnectionError: the brick cannot be reached.
    """
    if settings.connection != "auto":
        link = _LINKS[settings.connection]
    else:
        link = DirectLink if settings.device else _first_open
    return when_free(lambda: link(settings, on_state, clock), clock)


def when_free(attempt: Callable[[], BrickLink], clock: SteadyClock) -> BrickLink:
    """Try again while the brick is still waiting for a program that is gone.

    Raises:
        RobotBusyError: it serves another program.
        RobotConnectionError: as the attempt.
    """
    deadline = Deadline.after(TIMEOUT, clock)
    while True:
        try:
            return attempt()
        except RobotBusyError:
            if deadline.is_over:
                raise
        clock.sleep(min(PAUSE, deadline.left))


def _first_open(
    settings: Settings, on_state: Callable[[State], None], clock: SteadyClock
) -> BrickLink:
    number = resolve(settings.address, settings.patience)
    # All attempts together must not take longer than the timeout.
    hasty = msgspec.structs.replace(
        settings, address=number, patience=settings.patience / len(_LINKS)
    )
    failures = []
    for link in _LINKS.values():
        try:
            return link(hasty, on_state, clock)
        except RobotNotFoundError as error:
            failures.append(error)
    raise _most_telling(failures, settings.address)


def _most_telling(failures: Sequence[RobotNotFoundError], address: str) -> RobotNotFoundError:
    """The failure of the connection that was at least answered, else one for all of them."""
    for failure in failures:
        if failure.phrase.code != "ev3-no-answer":
            return failure
    return RobotNotFoundError("ev3-not-found", address=address)
