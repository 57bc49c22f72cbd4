"""Looks for real robots while a page asks for them."""

import asyncio
from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import dataclass
from typing import Any, Literal

from anyio import CapacityLimiter, to_thread
from msgspec import structs

from learnblock.errors import LearnBlockError
from learnblock.installation import Installation
from learnblock.robots import RobotEntry
from learnblock.robots.settings import given_names
from learnblock.running import finding
from learnblock.server import messages
from learnblock.server.runs.installer import Installer
from learnblock.server.runs.viewers import Viewer, Viewers

#: Seconds until robots of a kind are looked for again: a robot that answers is not disturbed.
AGAIN, AGAIN_AFTER_FOUND = 1.0, 6.0
#: Seconds until the kinds are listed again: a file that failed to load may be corrected by then.
LIST_AGAIN = 5.0
#: How many drivers look at the same time.
_MOST_AT_ONCE = 8
#: The most robots of a kind; an address book is not a robot.
_MOST_OF_A_KIND = 20
#: A robot is gone after this many looks without an answer; a beacon may come between two looks.
_PATIENCE = 2

#: The settings that reach each robot of a kind.
Settings = tuple[Mapping[str, Any], ...]


@dataclass(frozen=True, slots=True)
class Found:
    """A robot that answers.

    Args:
        shown: the robot as pages know it.
        entry: its kind.
        chosen: the settings that reach it.
    """

    shown: messages.NearbyRobot
    entry: RobotEntry
    chosen: Mapping[str, Any]


class Nearby:
    """The robots that answer, for every page that asks.

    Args:
        is_busy: whether a robot with this name is in use, and must not be disturbed.
    """

    def __init__(self, is_busy: Callable[[str], bool]) -> None:
        self._is_busy = is_busy
        #: Installs what robots need.
        self.installer = Installer(self.show, self.refresh, _installing)
        self._pages = Viewers()
        self._searching: asyncio.Task[None] | None = None
        self._found: dict[str, tuple[Found, ...]] = {}
        self._missed: dict[str, int] = {}
        #: The kinds whose first look has ended.
        self._looked: set[str] = set()
        #: The kinds that a program elsewhere on this computer uses.
        self._elsewhere: set[str] = set()
        self._known: dict[str, messages.KnownRobot] = {}
        self._limiter: CapacityLimiter | None = None
        #: The looks under way, by kind; one continues even if no page waits for it.
        self._looks: dict[str, asyncio.Task[tuple[Settings, bool]]] = {}
        self._last: messages.RobotsNearby | None = None

    def find(self, id: str) -> Found | None:  # noqa: A002 - as in the message
        """The robot with this id, if it has answered."""
        every = (robot for same in self._found.values() for robot in same)
        return next((robot for robot in every if robot.shown.id == id), None)

    def join(self, page: Viewer) -> None:
        """Send a page every change from now on."""
        if page not in self._pages:
            self._pages.add(page)
        if self._last:
            page.send(self._last)
        if self._searching is None:
            self._searching = asyncio.create_task(self._search())

    def leave(self, page: Viewer) -> None:
        """Stop sending changes to a page; without pages, the search stops."""
        if page in self._pages:
            self._pages.remove(page)
        if not self._pages:
            self.close()

    def close(self) -> None:
        """Stop looking; what is being asked now ends within its time limit."""
        if self._searching:
            self._searching.cancel()
            self._searching = None
        self._found, self._looked, self._last = {}, set(), None

    async def finish_looking(self, robot: str) -> None:
        """Return once no robot of a kind is being looked for; a look takes a few seconds."""
        if robot in self._looks:
            await asyncio.wait([self._looks[robot]])

    async def refresh(self) -> dict[str, RobotEntry]:
        """Read again which kinds there are, their names, and which are in use.

        Returns:
            The kinds, by name.
        """
        entries = await to_thread.run_sync(finding.real_robots)
        self._known = await to_thread.run_sync(self._read_known, entries)
        self.show()
        return entries

    async def _search(self) -> None:
        self._limiter = CapacityLimiter(_MOST_AT_ONCE)
        sought: set[str] = set()
        async with asyncio.TaskGroup() as group:
            while True:
                entries = await self.refresh()
                for name in entries.keys() - sought:
                    group.create_task(self._repeat(entries[name]))
                sought |= entries.keys()
                await asyncio.sleep(LIST_AGAIN)

    async def _repeat(self, entry: RobotEntry) -> None:
        while True:
            # A robot in use is not disturbed; it stays in the list until it is free again.
            if not self._is_busy(entry.name):
                settings, used = await asyncio.shield(self._begin_to_look(entry))
                if not self._is_busy(entry.name):
                    self._note(entry, settings)
                    self._elsewhere.discard(entry.name)
                    self._elsewhere |= {entry.name} if used else set()
            self._looked.add(entry.name)
            self.show()
            await asyncio.sleep(AGAIN_AFTER_FOUND if self._found.get(entry.name) else AGAIN)

    def _begin_to_look(self, entry: RobotEntry) -> "asyncio.Task[tuple[Settings, bool]]":
        """The look at a kind that is under way, or else a new one."""
        if entry.name not in self._looks:
            loop = asyncio.get_running_loop()

            def report(chosen: Mapping[str, Any]) -> None:
                loop.call_soon_threadsafe(self._note_early, entry, chosen)

            look = to_thread.run_sync(
                _look, entry, report, limiter=self._limiter, abandon_on_cancel=True
            )
            self._looks[entry.name] = asyncio.create_task(look)
            self._looks[entry.name].add_done_callback(lambda _: self._looks.pop(entry.name))
        return self._looks[entry.name]

    def _note_early(self, entry: RobotEntry, chosen: Mapping[str, Any]) -> None:
        """Show a robot before the look at its kind has ended."""
        robot = _found(entry, chosen)
        if self._pages and not self._is_busy(entry.name) and self.find(robot.shown.id) is None:
            same = (*self._found.get(entry.name, ()), robot)
            self._found[entry.name] = same[:_MOST_OF_A_KIND]
            self.show()

    def _note(self, entry: RobotEntry, settings: Settings) -> None:
        self._missed[entry.name] = 0 if settings else self._missed.get(entry.name, 0) + 1
        if settings or self._missed[entry.name] >= _PATIENCE:
            self._found[entry.name] = tuple(
                _found(entry, chosen) for chosen in settings[:_MOST_OF_A_KIND]
            )

    def show(self) -> None:
        """Send the pages what has changed."""
        if not self._pages:
            return
        nearby = (robot.shown for same in self._found.values() for robot in same)
        known = (
            structs.replace(
                robot,
                is_busy=self._is_used(robot.robot),
                looking=self._is_new(robot.robot),
                add_on=robot.add_on and self.installer.shown(robot.robot, robot.add_on),
            )
            for robot in self._known.values()
        )
        shown = messages.RobotsNearby(tuple(nearby), tuple(known))
        if shown != self._last:
            self._last = shown
            self._pages.send(shown)

    def _is_new(self, name: str) -> bool:
        """Whether the search has not looked for a kind yet."""
        return self._searching is not None and name not in self._looked

    def _is_used(self, name: str) -> bool:
        return self._is_busy(name) or name in self._elsewhere

    def _read_known(self, entries: Mapping[str, RobotEntry]) -> dict[str, messages.KnownRobot]:
        used: tuple[str, ...] = ()
        with suppress(LearnBlockError):
            used = finding.USED.load().names
        order = sorted(entries, key=lambda name: used.index(name) if name in used else len(used))
        names = given_names()
        known = {}
        for name in order:
            add_on = _missing_add_on(entries[name])
            given_name = names.get(name, "")
            known[name] = messages.KnownRobot(name, given_name, name in used, add_on=add_on)
        return known


def _installing(robot: str) -> tuple[str, ...]:
    """The words of the command that installs what a robot needs."""
    return Installation.current().adding(robot)


def _missing_add_on(entry: RobotEntry) -> messages.AddOn | None:
    command = finding.missing_add_on(entry)
    if not command:
        return None
    return messages.AddOn(command, Installation.current().may_add(entry.name))


def _look(
    entry: RobotEntry, report: Callable[[Mapping[str, Any]], object]
) -> tuple[Settings, bool]:
    """The settings that reach each robot of a kind, and whether another program uses it."""
    settings = finding.find(entry, report)
    return settings, not settings and finding.is_in_use(entry)


def _found(entry: RobotEntry, chosen: Mapping[str, Any]) -> Found:
    place = str(chosen.get("device") or chosen.get("address") or "")
    port = chosen.get("port") or chosen.get("direct_port")
    where = f"{place}:{port}" if port and not chosen.get("device") else place
    kind = str(chosen.get("connection", ""))
    shown = messages.NearbyRobot(
        id=" ".join(filter(None, (entry.name, kind, where)))[:400],
        robot=entry.name,
        way=_way(str(chosen.get("device") or ""), place),
        place=place,
    )
    return Found(shown, entry, chosen)


def _way(device: str, address: str) -> Literal["wifi", "usb", "bluetooth", "computer"]:
    if "rfcomm" in device:
        return "bluetooth"
    if device:
        return "usb"
    return "computer" if address.startswith(("127.", "localhost")) or not address else "wifi"
