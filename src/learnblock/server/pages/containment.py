"""Handlers of messages about the permissions of programs.

Only a user at the server's own computer may allow a project the network, never a program. A program
that knows the token, and may use the network itself, can connect like a page. So no key is issued
while such a program runs, and only a client that is still there after that can have received one.
"""

import secrets
from pathlib import Path

from anyio import to_thread

from learnblock import running
from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase
from learnblock.server import messages
from learnblock.server.pages.page import Handlers, Page

HANDLERS = Handlers()


@HANDLERS.add
async def _read(page: Page, _: messages.ReadContainment) -> None:
    page.send(messages.Containment(await page.sessions.contained()))


@HANDLERS.add
async def _read_network(page: Page, _: messages.ReadNetwork) -> None:
    page.network_key = ""
    allowed, folder = await to_thread.run_sync(_permission, _file(page))
    reason = _obstacle(page) or (folder and Phrase("server-network-by-folder", folder=folder))
    if not reason:
        page.network_key = secrets.token_urlsafe()
    page.send(messages.Network(allowed, page.network_key, reason or None))


@HANDLERS.add
async def _allow_network(page: Page, message: messages.AllowNetwork) -> None:
    if obstacle := _obstacle(page):
        raise LearnBlockError(obstacle.code, **obstacle.values)
    if not page.network_key or not secrets.compare_digest(
        message.key.encode(), page.network_key.encode()
    ):
        raise LearnBlockError("server-network-ask-again")
    change = running.allow_network if message.allowed else running.forbid_network
    await to_thread.run_sync(change, _file(page))
    await _read_network(page, messages.ReadNetwork())


def _obstacle(page: Page) -> Phrase | None:
    """Why this page can't change which projects may use the network."""
    if not page.is_local:
        return Phrase("server-network-only-here")
    if page.sessions.folder.read_only:
        return Phrase("server-read-only")
    if page.sessions.uses_network:
        return Phrase("server-network-in-use")
    return None


def _permission(file: Path) -> tuple[bool, str | None]:
    return running.may_use_network(file), running.folder_on_network(file)


def _file(page: Page) -> Path:
    return page.sessions.folder.file(page.session.name)
