"""Handlers of messages about edits of the program."""

from learnblock.project.document.document import Document
from learnblock.server import messages
from learnblock.server.pages.page import Handlers, Page

Edit = messages.EditBlocks | messages.EditText | messages.RecoverBlocks | messages.RecoverText

HANDLERS = Handlers()


@HANDLERS.add
async def _edit_blocks(page: Page, message: messages.EditBlocks) -> None:
    if _is_for_the_shown_program(page, message):
        await page.part.edit(page, message.edit, message.revision, "blocks", message.workspace)


@HANDLERS.add
async def _edit_text(page: Page, message: messages.EditText) -> None:
    if _is_for_the_shown_program(page, message):
        await page.part.edit(page, message.edit, message.revision, message.notation, message.text)


@HANDLERS.add
async def _recover_blocks(page: Page, message: messages.RecoverBlocks) -> None:
    if _is_for_the_shown_program(page, message):
        await page.part.recover(page, message.edit, "blocks", message.workspace, message.base)


@HANDLERS.add
async def _recover_text(page: Page, message: messages.RecoverText) -> None:
    if _is_for_the_shown_program(page, message):
        await page.part.recover(page, message.edit, message.notation, message.text, message.base)


def _is_for_the_shown_program(page: Page, message: Edit) -> bool:
    """False for an edit of a robot that another page has closed in the meantime."""
    return message.shown == page.shown.number


@HANDLERS.add
async def _undo(page: Page, _: messages.Undo) -> None:
    await page.part.undo()


@HANDLERS.add
async def _redo(page: Page, _: messages.Redo) -> None:
    await page.part.redo()


@HANDLERS.add
async def _format(page: Page, _: messages.Format) -> None:
    await page.part.change(Document.formatted)


@HANDLERS.add
async def _rename(page: Page, message: messages.Rename) -> None:
    await page.part.change(
        lambda document: document.renamed(message.sort, message.name, message.new)
    )


@HANDLERS.add
async def _set_breakpoints(page: Page, message: messages.SetBreakpoints) -> None:
    page.session.robots.set_breakpoints(page.part, tuple(message.blocks))
