"""Handlers of messages about the code that a project carries."""

from anyio import to_thread

from learnblock.server import messages
from learnblock.server.pages import custom_blocks, libraries
from learnblock.server.pages.handlers import Handlers
from learnblock.server.pages.page import Page
from learnblock.server.projects import offering

HANDLERS = Handlers()


@HANDLERS.add
async def _install(page: Page, _: messages.InstallOffered) -> None:
    session = page.session
    code = session.offered
    await to_thread.run_sync(offering.install, code)
    await to_thread.run_sync(page.sessions.block_files.have_changed)
    session.installed(code)
    await page.sessions.renew_blocks(session)
    page.sessions.send(await to_thread.run_sync(custom_blocks.listed))
    page.sessions.send(await to_thread.run_sync(libraries.listed))
