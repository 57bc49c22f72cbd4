"""What is done when a page edits the settings of real robots and of perception."""

from collections.abc import Mapping
from functools import partial

from anyio import to_thread

from learnblock.errors import LearnBlockError, SettingsError
from learnblock.server import messages
from learnblock.server.pages.page import Handler, Page
from learnblock.server.pages.sentences import sentence


async def _read(page: Page, message: messages.ReadSettings) -> None:
    page.tell(await to_thread.run_sync(_table, message.robot))


async def _change(page: Page, message: messages.ChangeSettings) -> None:
    wrong = await to_thread.run_sync(_changed, message)
    page.tell(await to_thread.run_sync(partial(_table, message.robot, wrong)))


# The drivers of robots take their time to be imported, and the server answers before they are.


def _table(robot: str, wrong: dict[str, str] | None = None) -> messages.SettingsTable:
    from learnblock.server import settings  # noqa: PLC0415

    try:
        found = tuple(settings.described(settings.table(robot)))
    except SettingsError as error:
        return messages.SettingsTable(robot, problem=sentence(error))
    return messages.SettingsTable(robot, found, wrong or {})


def _changed(message: messages.ChangeSettings) -> dict[str, str]:
    """Change settings; what is wrong with them, if that cannot be."""
    from learnblock.server import settings  # noqa: PLC0415

    if message.values.get("emotions_on_cameras") is True and not message.agreed:
        raise LearnBlockError(
            "feelings are looked for on real cameras only after you have read why they are not"
        )
    table = settings.table(message.robot)
    values = settings.chosen(table, message.values)
    wrong = table.wrong(values)
    if not wrong:
        table.change_all(values)
    return wrong


HANDLERS: Mapping[type, Handler] = {
    messages.ReadSettings: _read,
    messages.ChangeSettings: _change,
}
