"""Handlers of messages about completion and help."""

from collections.abc import Mapping
from functools import partial

from anyio import to_thread

from learnblock.server import messages
from learnblock.server.help import services
from learnblock.server.pages.page import Handler, Page


async def _complete(page: Page, message: messages.Complete) -> None:
    page.send(
        await to_thread.run_sync(
            partial(
                services.complete,
                page.session.document,
                message.notation,
                message.line,
                message.column,
                language=message.language,
                request=message.request,
            )
        )
    )


async def _describe(page: Page, message: messages.Describe) -> None:
    page.send(
        await to_thread.run_sync(
            partial(
                services.describe,
                page.session.document,
                message.notation,
                message.line,
                message.column,
                language=message.language,
                request=message.request,
            )
        )
    )


HANDLERS: Mapping[type, Handler] = {
    messages.Complete: _complete,
    messages.Describe: _describe,
}
