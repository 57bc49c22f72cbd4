"""Handlers of messages about custom blocks."""

from anyio import to_thread

from learnblock.blocks.palette import preview
from learnblock.extensions import custom_blocks
from learnblock.extensions.custom_blocks import Checked, CustomBlock, Problem
from learnblock.server import messages
from learnblock.server.pages.page import Handlers, Page
from learnblock.server.runs.function_call import function_call

HANDLERS = Handlers()


@HANDLERS.add
async def _list(page: Page, _: messages.ListCustomBlocks) -> None:
    if await to_thread.run_sync(page.sessions.block_files.have_changed):
        await _renew(page)
        return
    page.send(await to_thread.run_sync(listed))


@HANDLERS.add
async def _check(page: Page, message: messages.CheckCustomBlock) -> None:
    checked = await to_thread.run_sync(_checked, message)
    page.send(_result(message.request, checked, message.language))


@HANDLERS.add
async def _save(page: Page, message: messages.SaveCustomBlock) -> None:
    checked = await to_thread.run_sync(_saved, message)
    if checked.errors:
        page.send(_result(message.request, checked, "en"))
        return
    await _have_changed(page, message.name)


@HANDLERS.add
async def _try(page: Page, message: messages.TryCustomBlock) -> None:
    call = await to_thread.run_sync(
        function_call, message.name, message.source, message.function, message.arguments
    )
    with page.sessions.starting(page.session):
        async with page.sessions.connections.reserved(page, page.session.parts.kinds):
            await page.session.runs.try_out(page.part, page.player, call)


@HANDLERS.add
async def _duplicate(page: Page, message: messages.DuplicateCustomBlock) -> None:
    duplicate = await to_thread.run_sync(custom_blocks.duplicate, message.name, message.new)
    await _have_changed(page, duplicate.name)


@HANDLERS.add
async def _delete(page: Page, message: messages.DeleteCustomBlock) -> None:
    await to_thread.run_sync(custom_blocks.delete, message.name)
    await _have_changed(page)


@HANDLERS.add
async def _restore(page: Page, message: messages.RestoreCustomBlock) -> None:
    restored = await to_thread.run_sync(custom_blocks.restore, message.name)
    await _have_changed(page, restored.name)


@HANDLERS.add
async def _export(page: Page, message: messages.ExportCustomBlock) -> None:
    page.send(messages.File(*await to_thread.run_sync(custom_blocks.export, message.name)))


@HANDLERS.add
async def _import(page: Page, message: messages.ImportCustomBlock) -> None:
    imported = await to_thread.run_sync(_imported, message)
    await _have_changed(page, imported.name)


async def _have_changed(page: Page, saved: str = "") -> None:
    """Send every page the new blocks, and the requesting page the saved name."""
    await to_thread.run_sync(page.sessions.block_files.have_changed)
    if saved:
        page.send(messages.CustomBlockSaved(saved))
    await _renew(page)


async def _renew(page: Page) -> None:
    blocks = await to_thread.run_sync(listed)
    await page.sessions.renew_blocks(page.session)
    page.sessions.send(blocks)


# These are slow and run in a thread.


def listed() -> messages.CustomBlocks:
    """All custom blocks."""
    return messages.CustomBlocks(tuple(map(_custom_block, custom_blocks.load_all())))


def _checked(message: messages.CheckCustomBlock) -> Checked:
    return custom_blocks.check(
        message.source, message.configuration, name=message.name, replaces=message.replaces
    )


def _saved(message: messages.SaveCustomBlock) -> Checked:
    return custom_blocks.save(
        message.name, message.source, message.configuration, replaces=message.replaces
    )


def _imported(message: messages.ImportCustomBlock) -> CustomBlock:
    return custom_blocks.import_file(message.content, replace=message.replace)


def _custom_block(block: CustomBlock) -> messages.CustomBlock:
    problems = tuple(map(_problem, block.problems))
    return messages.CustomBlock(
        block.name, block.category, block.functions, block.source, block.configuration, problems
    )


def _result(request: int, checked: Checked, language: str) -> messages.CustomBlockChecked:
    return messages.CustomBlockChecked(
        request=request,
        problems=tuple(map(_problem, checked.problems)),
        configuration=checked.complete,
        chosen=checked.chosen,
        previews=tuple(
            messages.CustomBlockPreview(block.name, *preview(block, language))
            for block in checked.blocks
        ),
    )


def _problem(problem: Problem) -> messages.CustomBlockProblem:
    diagnostic = problem.diagnostic
    return messages.CustomBlockProblem(
        part=problem.part,
        code=diagnostic.code,
        message=diagnostic.message,
        severity=diagnostic.severity,
        line=diagnostic.line,
        column=diagnostic.column,
        end_column=diagnostic.end_column,
    )
