"""What is done when a page edits the names of tags."""

from collections.abc import Mapping

from anyio import to_thread

from learnblock import tag_names
from learnblock.errors import LearnBlockError
from learnblock.server import messages
from learnblock.server.pages.page import Handler, Page
from learnblock.server.pages.sentences import sentence


def present() -> messages.Tags:
    """The dictionary as it is now, or why there is none."""
    try:
        return messages.Tags(dict(tag_names.tag_names()))
    except (LearnBlockError, OSError) as error:
        return messages.Tags({}, sentence(error))


async def _save(page: Page, message: messages.SaveTags) -> None:
    await to_thread.run_sync(tag_names.save_names, message.names)
    page.sessions.tell(await to_thread.run_sync(present))


async def _read(page: Page, message: messages.ReadTags) -> None:
    page.tell(messages.TagsRead(dict(tag_names.parse(message.text, message.filename))))


async def _export(page: Page, message: messages.ExportTags) -> None:
    page.tell(await to_thread.run_sync(_file, message.format))


def _file(format_: str) -> messages.File:
    names = tag_names.tag_names()
    if format_ == "html":
        return messages.File("tags.html", _sheet(names))
    return messages.File(f"tags.{format_}", tag_names.write(names, as_csv=format_ == "csv"))


def _sheet(names: Mapping[str, int]) -> str:
    from learnblock.tag_sheet import sheet  # noqa: PLC0415 - it brings the simulator

    return sheet([(number, name) for name, number in names.items()])


HANDLERS: Mapping[type, Handler] = {
    messages.SaveTags: _save,
    messages.ReadTags: _read,
    messages.ExportTags: _export,
}
