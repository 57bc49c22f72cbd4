"""Handlers of messages about tag names."""

from collections.abc import Mapping

from anyio import to_thread

from learnblock.perception import tag_names
from learnblock.server import catalog, messages
from learnblock.server.pages.page import Handlers, Page

HANDLERS = Handlers()


@HANDLERS.add
async def _save(page: Page, message: messages.SaveTags) -> None:
    before = dict((await to_thread.run_sync(catalog.tag_dictionary)).names)
    await to_thread.run_sync(tag_names.save_names, message.names)
    page.sessions.tags_changed(before, message.names)
    page.sessions.send(await to_thread.run_sync(catalog.tag_dictionary))


@HANDLERS.add
async def _read(page: Page, message: messages.ReadTags) -> None:
    read = await to_thread.run_sync(tag_names.parse, message.text, message.filename)
    page.send(messages.TagsRead(dict(read)))


@HANDLERS.add
async def _export(page: Page, message: messages.ExportTags) -> None:
    page.send(await to_thread.run_sync(_file, message.format))


def _file(format_: str) -> messages.File:
    names = tag_names.tag_names()
    if format_ == "html":
        return messages.File("tags.html", _sheet(names))
    return messages.File(f"tags.{format_}", tag_names.write(names, as_csv=format_ == "csv"))


def _sheet(names: Mapping[str, int]) -> str:
    from learnblock.monitor.tag_sheet import sheet  # noqa: PLC0415 - it loads the simulator

    return sheet([(number, name) for name, number in names.items()])
