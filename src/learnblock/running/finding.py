"""Finds real robots that answer."""

from collections.abc import Callable, Mapping
from contextlib import suppress
from typing import Any

from learnblock.robots import RobotEntry, entries
from learnblock.robots.real import RealRobot
from learnblock.runtime.containment.driver import give_up, in_own_thread
from learnblock.storage.settings import Settings, SettingsSection

#: How many robots that were used before are remembered.
_MOST_USED = 20
#: The most seconds that a driver has to find its robots.
LONGEST_SCAN = 5.0
#: Seconds that a driver may take longer than it should; then the look at it is given up.
_LATE = 5.0


class UsedRobots(Settings, frozen=True):
    """The kinds of robots that were connected on this computer, the newest first."""

    names: tuple[str, ...] = ()


USED: SettingsSection[UsedRobots] = SettingsSection(
    ("robots_used",), "the robots used before", UsedRobots
)


def real_robots() -> dict[str, RobotEntry]:
    """The robots that can be found and connected, by name."""
    unsimulated = {name: entry for name, entry in entries().items() if entry.simulated is not True}
    return {name: entry for name, entry in unsimulated.items() if real_kind(entry)}


def real_kind(entry: RobotEntry) -> type[RealRobot[Any]] | None:
    """The class of a real robot; None for a twin, or for a robot that cannot be loaded."""
    try:
        kind = entry.load()
    except Exception:  # noqa: BLE001 - a user's robot may raise anything; choosing it says what
        return None
    return kind if issubclass(kind, RealRobot) else None


def find(
    entry: RobotEntry, report: Callable[[Mapping[str, Any]], object]
) -> tuple[Mapping[str, Any], ...]:
    """The settings that reach each robot of a kind that answers, until its driver fails or hangs.

    The driver has the rights that it has in a run, and the time that its class asks for.

    Args:
        entry: the robot.
        report: called with the settings of each robot as it is found, in another thread.
    """
    kind = real_kind(entry)
    if kind is None:
        return ()

    matches: list[Mapping[str, Any]] = []

    def scan() -> None:
        give_up(kind.known_rights())
        for settings in kind.scan(min(kind.scan_seconds, LONGEST_SCAN)):
            matches.append(settings)
            report(settings)

    # A driver may raise any exception; connecting says what.
    with suppress(Exception):
        in_own_thread(scan, seconds=LONGEST_SCAN + _LATE)
    return tuple(matches)


def missing_add_on(entry: RobotEntry) -> str:
    """The command that installs what a robot can't be used without; empty if it is there."""
    kind = real_kind(entry)
    return kind.missing_add_on() if kind else ""


def is_in_use(entry: RobotEntry) -> bool:
    """Whether a robot is not looked for because a program on this computer uses it."""
    kind = real_kind(entry)
    if kind is None:
        return False
    try:
        return kind.is_in_use()
    except Exception:  # noqa: BLE001 - a driver may raise any exception; connecting says what
        return False


def remember(entry: RobotEntry) -> None:
    """Record that a robot was used."""
    USED.update(lambda now: {"names": (entry.name, *_others(now, entry.name))[:_MOST_USED]})


def _others(now: UsedRobots, name: str) -> tuple[str, ...]:
    return tuple(other for other in now.names if other != name)
