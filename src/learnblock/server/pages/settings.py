"""Handlers of messages about the settings of real robots and of camera recognition."""

from functools import partial

from anyio import to_thread

from learnblock.errors import LearnBlockError, SettingsError
from learnblock.i18n import Phrase
from learnblock.server import messages
from learnblock.server.pages.page import Handlers, Page

HANDLERS = Handlers()


@HANDLERS.add
async def _read(page: Page, message: messages.ReadSettings) -> None:
    page.send(await to_thread.run_sync(_table, message.robot))


@HANDLERS.add
async def _change(page: Page, message: messages.ChangeSettings) -> None:
    wrong = await to_thread.run_sync(_changed, message)
    page.send(await to_thread.run_sync(partial(_table, message.robot, wrong)))


# The drivers of robots are slow to import, and the server answers before that.


def _table(robot: str, wrong: dict[str, Phrase] | None = None) -> messages.SettingsTable:
    from learnblock.server.catalog import settings  # noqa: PLC0415

    try:
        rows = tuple(settings.described(settings.table(robot)))
    except SettingsError as error:
        return messages.SettingsTable(robot, problem=error.phrase)
    return messages.SettingsTable(robot, rows, wrong or {})


def _changed(message: messages.ChangeSettings) -> dict[str, Phrase]:
    """Change settings, or return the problems with them."""
    from learnblock.server.catalog import settings  # noqa: PLC0415

    if message.values.get("emotions_on_cameras") is True and not message.agreed:
        raise LearnBlockError("settings-agree-first")
    table = settings.table(message.robot)
    values = settings.chosen(table, message.values)
    wrong = table.wrong(values)
    if not wrong:
        table.change_all(values)
    return wrong
