"""Handlers of messages about the robots of a project."""

from learnblock.server import messages
from learnblock.server.pages.page import Handlers, Page

HANDLERS = Handlers()


@HANDLERS.add
async def _add(page: Page, message: messages.AddTab) -> None:
    await page.session.robots.add(page, message.robot, message.count)


@HANDLERS.add
async def _set_count(page: Page, message: messages.SetRobotCount) -> None:
    part = page.session.parts.require(message.name) if message.name else page.part
    await page.session.robots.set_count(part, message.count)


@HANDLERS.add
async def _open(page: Page, message: messages.OpenTab) -> None:
    page.session.robots.show(page, message.name, message.robot)


@HANDLERS.add
async def _close(page: Page, message: messages.CloseTab) -> None:
    await page.session.robots.close(message.name)


@HANDLERS.add
async def _reopen(page: Page, _: messages.ReopenTab) -> None:
    await page.session.robots.reopen(page)


@HANDLERS.add
async def _rename(page: Page, message: messages.RenameTab) -> None:
    await page.session.robots.rename(message.name, message.new)
