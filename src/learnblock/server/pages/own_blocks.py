"""What is done when a page makes blocks of its user's own."""

from collections.abc import Mapping

from anyio import to_thread

from learnblock import own_blocks
from learnblock.blocks.palette import preview
from learnblock.own_blocks import Checked, OwnBlock, Problem
from learnblock.server import messages
from learnblock.server.pages.page import Handler, Page
from learnblock.server.runs.trial import trial


async def _list(page: Page, _: messages.ListOwnBlocks) -> None:
    if await to_thread.run_sync(page.sessions.own_files.have_changed):
        await _renew(page)
        return
    page.tell(await to_thread.run_sync(_all))


async def _check(page: Page, message: messages.CheckOwnBlock) -> None:
    checked = await to_thread.run_sync(_checked, message)
    page.tell(_told(message.request, checked, message.language))


async def _save(page: Page, message: messages.SaveOwnBlock) -> None:
    checked = await to_thread.run_sync(_saved, message)
    if checked.errors:
        page.tell(_told(0, checked, "en"))
        return
    await _have_changed(page, message.name)


async def _try(page: Page, message: messages.TryOwnBlock) -> None:
    made = await to_thread.run_sync(
        trial, message.name, message.source, message.function, message.arguments
    )
    await page.session.try_out(made)


async def _duplicate(page: Page, message: messages.DuplicateOwnBlock) -> None:
    made = await to_thread.run_sync(own_blocks.duplicate, message.name, message.new)
    await _have_changed(page, made.name)


async def _delete(page: Page, message: messages.DeleteOwnBlock) -> None:
    await to_thread.run_sync(own_blocks.delete, message.name)
    await _have_changed(page)


async def _restore(page: Page, message: messages.RestoreOwnBlock) -> None:
    restored = await to_thread.run_sync(own_blocks.restore, message.name)
    await _have_changed(page, restored.name)


async def _export(page: Page, message: messages.ExportOwnBlock) -> None:
    page.tell(messages.File(*await to_thread.run_sync(own_blocks.export, message.name)))


async def _import(page: Page, message: messages.ImportOwnBlock) -> None:
    imported = await to_thread.run_sync(_imported, message)
    await _have_changed(page, imported.name)


async def _have_changed(page: Page, saved: str = "") -> None:
    """Tell every page, and the one that asked under which name it is saved."""
    await to_thread.run_sync(page.sessions.own_files.have_changed)
    if saved:
        page.tell(messages.OwnBlockSaved(saved))
    await _renew(page)


async def _renew(page: Page) -> None:
    told = await to_thread.run_sync(_all)
    await page.sessions.renew_blocks(page.session)
    page.sessions.tell(told)


# In a thread, as it takes its time.


def _all() -> messages.OwnBlocks:
    return messages.OwnBlocks(tuple(map(_own_block, own_blocks.own_blocks())))


def _checked(message: messages.CheckOwnBlock) -> Checked:
    return own_blocks.check(
        message.source, message.configuration, name=message.name, replaces=message.replaces
    )


def _saved(message: messages.SaveOwnBlock) -> Checked:
    return own_blocks.save(
        message.name, message.source, message.configuration, replaces=message.replaces
    )


def _imported(message: messages.ImportOwnBlock) -> OwnBlock:
    return own_blocks.import_file(message.content, replace=message.replace)


def _own_block(block: OwnBlock) -> messages.OwnBlock:
    problems = tuple(map(_problem, block.problems))
    return messages.OwnBlock(
        block.name, block.category, block.functions, block.source, block.configuration, problems
    )


def _told(request: int, checked: Checked, language: str) -> messages.OwnBlockChecked:
    return messages.OwnBlockChecked(
        request=request,
        problems=tuple(map(_problem, checked.problems)),
        configuration=checked.complete,
        chosen=checked.chosen,
        previews=tuple(
            messages.OwnBlockPreview(one.name, *preview(one, language)) for one in checked.blocks
        ),
    )


def _problem(problem: Problem) -> messages.OwnBlockProblem:
    one = problem.diagnostic
    return messages.OwnBlockProblem(
        part=problem.part,
        code=one.code,
        message=one.message,
        severity=one.severity,
        line=one.line,
        column=one.column,
        end_column=one.end_column,
    )


HANDLERS: Mapping[type, Handler] = {
    messages.ListOwnBlocks: _list,
    messages.CheckOwnBlock: _check,
    messages.SaveOwnBlock: _save,
    messages.TryOwnBlock: _try,
    messages.DuplicateOwnBlock: _duplicate,
    messages.DeleteOwnBlock: _delete,
    messages.RestoreOwnBlock: _restore,
    messages.ExportOwnBlock: _export,
    messages.ImportOwnBlock: _import,
}
