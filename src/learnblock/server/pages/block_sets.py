"""Handlers of messages about block sets."""

from functools import partial
from pathlib import PurePath

from anyio import to_thread

from learnblock.blocks import block_sets
from learnblock.i18n import Phrase
from learnblock.server import messages
from learnblock.server.pages.page import Handlers, Page

HANDLERS = Handlers()


@HANDLERS.add
async def _list(page: Page, _: messages.ListBlockSets) -> None:
    page.send(await to_thread.run_sync(_all))


@HANDLERS.add
async def _choose(page: Page, message: messages.ChooseBlockSet) -> None:
    page.session.show_blocks(message.set)


@HANDLERS.add
async def _read(page: Page, message: messages.ReadBlockSet) -> None:
    name = PurePath(message.filename).stem
    read = await to_thread.run_sync(block_sets.parse, message.text, name)
    page.send(messages.BlockSetRead(read))


@HANDLERS.add
async def _save(page: Page, message: messages.SaveBlockSet) -> None:
    save = partial(block_sets.save_own, message.set, replace=message.replace)
    await to_thread.run_sync(save)
    page.sessions.send(await to_thread.run_sync(_all))


@HANDLERS.add
async def _delete(page: Page, message: messages.DeleteBlockSet) -> None:
    await to_thread.run_sync(block_sets.delete_own, message.name)
    page.sessions.send(await to_thread.run_sync(_all))


@HANDLERS.add
async def _export(page: Page, message: messages.ExportBlockSet) -> None:
    text = await to_thread.run_sync(block_sets.write, message.set)
    page.send(messages.File(f"{message.set.name}.toml", text))


def _all() -> messages.BlockSets:
    own, wrong = block_sets.own()
    problems = tuple(
        Phrase("server-block-set-file", name=error.filename, problem=error.phrase)
        for error in wrong
    )
    return messages.BlockSets(tuple(block_sets.built_in().values()), own, problems)
