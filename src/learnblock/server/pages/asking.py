"""Handlers of questions about the program: completion, help, and the robots that can run it."""

from collections.abc import Callable
from functools import partial
from typing import TypeVar

from anyio import to_thread
from msgspec.structs import asdict

from learnblock.project.help import services
from learnblock.server import catalog, messages
from learnblock.server.pages.page import Handlers, Page

HANDLERS = Handlers()
Answer = TypeVar("Answer")


@HANDLERS.add
async def _complete(page: Page, message: messages.Complete) -> None:
    completions = await _at_cursor(services.complete, page, message)
    page.send(messages.Completions(message.request, completions.from_column, completions.options))


@HANDLERS.add
async def _describe(page: Page, message: messages.Describe) -> None:
    description = await _at_cursor(services.describe, page, message)
    page.send(messages.Description(request=message.request, **asdict(description)))


async def _at_cursor(
    answer: Callable[..., Answer], page: Page, message: messages.Complete | messages.Describe
) -> Answer:
    place = (page.part.document, message.notation, message.line, message.column)
    return await to_thread.run_sync(partial(answer, *place, language=message.language))


@HANDLERS.add
async def _runs_on(page: Page, message: messages.ReadRunsOn) -> None:
    del message
    page.send(await to_thread.run_sync(catalog.runs_on, page.part.document))
