"""Handlers of questions about the program: completion, help, and the robots that can run it."""

from functools import partial

from anyio import to_thread

from learnblock.server import catalog, messages
from learnblock.server.help import services
from learnblock.server.pages.page import Handlers, Page

HANDLERS = Handlers()


@HANDLERS.add
async def _complete(page: Page, message: messages.Complete) -> None:
    page.send(
        await to_thread.run_sync(
            partial(
                services.complete,
                page.part.document,
                message.notation,
                message.line,
                message.column,
                language=message.language,
                request=message.request,
            )
        )
    )


@HANDLERS.add
async def _describe(page: Page, message: messages.Describe) -> None:
    page.send(
        await to_thread.run_sync(
            partial(
                services.describe,
                page.part.document,
                message.notation,
                message.line,
                message.column,
                language=message.language,
                request=message.request,
            )
        )
    )


@HANDLERS.add
async def _runs_on(page: Page, message: messages.ReadRunsOn) -> None:
    del message
    page.send(await to_thread.run_sync(catalog.runs_on, page.part.document))
