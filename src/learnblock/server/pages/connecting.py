"""Handlers of messages about finding real robots and about the connection to one of them."""

from collections.abc import Mapping
from typing import Any

from anyio import to_thread

from learnblock.errors import LearnBlockError, SettingsError
from learnblock.i18n import Phrase
from learnblock.installation import Installation
from learnblock.robots import RobotEntry, find
from learnblock.server import catalog, messages
from learnblock.server.pages.page import Handlers, Page

# The drivers of robots are slow to import, and the server answers before that.

HANDLERS = Handlers()


@HANDLERS.add
async def _find(page: Page, message: messages.FindRobots) -> None:
    nearby = page.sessions.connections.nearby
    (nearby.join if message.on else nearby.leave)(page)


@HANDLERS.add
async def _connect(page: Page, message: messages.ConnectRobot) -> None:
    connections = page.sessions.connections
    robot = connections.nearby.find(message.id)
    entry = robot.entry if robot else await to_thread.run_sync(_real, message.id)
    await connections.connect(page, message.id, entry, robot.chosen if robot else {})
    if not page.sessions.folder.read_only:
        await to_thread.run_sync(_remember, entry)
    await _refresh(page)


@HANDLERS.add
async def _disconnect(page: Page, _: messages.DisconnectRobot) -> None:
    # Without waiting: a driver that is still connecting may take seconds to give up.
    page.sessions.connections.begin_to_disconnect(page)


@HANDLERS.add
async def _try(page: Page, message: messages.TryRobot) -> None:
    page.sessions.connections.of(page).act(message.action)


@HANDLERS.add
async def _correct(page: Page, message: messages.CorrectRobot) -> None:
    connections = page.sessions.connections
    connected = connections.of(page)
    corrected = await to_thread.run_sync(_corrected, connected.robot, connected.settings, message)
    page.send(corrected)
    if corrected.saved:
        # The driver reads its settings when it connects.
        await connections.connect(page, connected.id, connected.robot, connected.chosen)


@HANDLERS.add
async def _name(page: Page, message: messages.NameRobot) -> None:
    await to_thread.run_sync(_named, message.robot, message.name.strip())
    page.sessions.send(messages.Robots(await to_thread.run_sync(catalog.robot_choices)))
    await _refresh(page)


@HANDLERS.add
async def _use(page: Page, _: messages.UseRobot) -> None:
    connections = page.sessions.connections
    connected = connections.of(page)
    await to_thread.run_sync(_saved, connected.robot, connected.chosen)
    await connections.disconnect(page)
    if page.has_session:
        await page.session.robots.choose(page.part, connected.robot.name)


@HANDLERS.add
async def _install(page: Page, message: messages.InstallAddOn) -> None:
    installer = page.sessions.connections.nearby.installer
    if not message.on:
        await installer.stop()
        return
    entry = await to_thread.run_sync(_real, message.robot)
    if not Installation.current().may_add(entry.name):
        raise LearnBlockError("connect-not-ours-to-install", robot=entry.name)
    if await to_thread.run_sync(_lacks_add_on, entry):
        installer.begin(entry.name)


async def _refresh(page: Page) -> None:
    await page.sessions.connections.nearby.refresh()


def _real(name: str) -> RobotEntry:
    """The real robot with this name.

    Raises:
        LearnBlockError: there is none, or it is simulated.
    """
    from learnblock.running.finding import real_kind  # noqa: PLC0415

    entry = find(name)
    entry.load()
    if real_kind(entry) is None:
        raise LearnBlockError("settings-simulated", robot=name)
    return entry


def _lacks_add_on(entry: RobotEntry) -> bool:
    from learnblock.running.finding import missing_add_on  # noqa: PLC0415

    return bool(missing_add_on(entry))


def _table(entry: RobotEntry) -> Any:
    from learnblock.server.catalog import settings  # noqa: PLC0415

    return settings.table(entry.name)


def _remember(entry: RobotEntry) -> None:
    from learnblock.running.finding import remember  # noqa: PLC0415

    remember(entry)


def _named(robot: str, name: str) -> None:
    _table(_real(robot)).change_all({"name": name})


def _saved(entry: RobotEntry, chosen: Mapping[str, Any]) -> None:
    """Save what reaches a robot, so that programs reach it too."""
    if chosen:
        _table(entry).change_all(chosen)


def _corrected(
    entry: RobotEntry, settings: Any, message: messages.CorrectRobot
) -> messages.RobotCorrected:
    calibration = entry.load().calibration  # type: ignore[attr-defined] # a real robot
    if calibration is None or settings is None:
        return messages.RobotCorrected(problem=Phrase("connect-needs-no-correction"))
    after = calibration.corrected(settings, message.distance, message.angle)
    corrections = tuple(
        messages.Correction(name, getattr(settings, name), value) for name, value in after.items()
    )
    table = _table(entry)
    problem = next(iter(table.wrong(after).values()), None)
    if problem or not message.save:
        return messages.RobotCorrected(corrections, problem=problem)
    try:
        table.change_all(after)
    except SettingsError as error:
        return messages.RobotCorrected(corrections, problem=error.phrase)
    return messages.RobotCorrected(corrections, saved=True)
