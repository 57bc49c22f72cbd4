"""Handlers of messages about worlds."""

from itertools import count
from typing import Any

from anyio import to_thread
from msgspec import structs

from learnblock.errors import LearnBlockError, UnknownNameError, WorldError
from learnblock.server import catalog, messages
from learnblock.server.pages.page import Handlers, Page

HANDLERS = Handlers()


@HANDLERS.add
async def _read(page: Page, message: messages.ReadWorld) -> None:
    world = await to_thread.run_sync(_to_edit, message.name)
    page.send(structs.replace(world, request=message.request))


@HANDLERS.add
async def _check(page: Page, message: messages.CheckWorld) -> None:
    robot = page.session.parts.kinds[0]
    page.send(await to_thread.run_sync(_checked, message.world, robot))


@HANDLERS.add
async def _make(page: Page, message: messages.MakeWorld) -> None:
    def make() -> messages.WorldMade:
        from learnblock.monitor import worlds  # noqa: PLC0415

        world = worlds.made_world(message.template, message.size, message.seed)
        return messages.WorldMade(worlds.world_values(world))

    page.send(await to_thread.run_sync(make))


@HANDLERS.add
async def _save(page: Page, message: messages.SaveWorld) -> None:
    session = page.session
    if not message.replace and await to_thread.run_sync(_is_own, message.name):
        raise LearnBlockError("server-world-exists", name=message.name)
    wrong = await to_thread.run_sync(_saved, message.name, message.world)
    if wrong:
        page.send(structs.replace(wrong, request=message.request))
        return
    await _have_changed(page)
    await session.robots.choose_world(message.name)


@HANDLERS.add
async def _import(page: Page, message: messages.ImportWorld) -> None:
    def install() -> str:
        from learnblock.extensions import worlds  # noqa: PLC0415

        return worlds.install(worlds.unpack(message.filename, message.content))

    name = await to_thread.run_sync(install)
    await _have_changed(page)
    await page.session.robots.choose_world(name)


@HANDLERS.add
async def _export(page: Page, message: messages.ExportWorld) -> None:
    def pack() -> tuple[str, bytes]:
        from learnblock.extensions import worlds  # noqa: PLC0415

        return worlds.pack(worlds.find(message.name))

    page.send(messages.WorldExported(*await to_thread.run_sync(pack)))


@HANDLERS.add
async def _rename(page: Page, message: messages.RenameWorld) -> None:
    def rename() -> None:
        from learnblock.extensions import worlds  # noqa: PLC0415

        worlds.rename(message.name, message.title)

    await to_thread.run_sync(rename)
    await _have_changed(page)


@HANDLERS.add
async def _delete(page: Page, message: messages.DeleteWorld) -> None:
    title = await to_thread.run_sync(_title, message.name)
    await page.sessions.leave_world(page.session, message.name)

    def delete() -> None:
        from learnblock.extensions import worlds  # noqa: PLC0415

        worlds.delete(message.name)

    await to_thread.run_sync(delete)
    await _have_changed(page)
    page.send(messages.WorldDeleted(message.name, title))


@HANDLERS.add
async def _restore(page: Page, message: messages.RestoreWorld) -> None:
    def restore() -> None:
        from learnblock.extensions import worlds  # noqa: PLC0415

        worlds.restore(message.name)

    await to_thread.run_sync(restore)
    await _have_changed(page)
    await page.session.robots.choose_world(message.name)


async def _have_changed(page: Page) -> None:
    """Send every page of every project the worlds."""
    page.sessions.send(messages.Worlds(await to_thread.run_sync(catalog.world_choices)))


# The simulator is slow to import, and the server answers before that.


def _to_edit(name: str) -> messages.WorldToEdit:
    from learnblock.monitor import worlds  # noqa: PLC0415
    from learnblock.robots.simulated import find_world  # noqa: PLC0415

    catalog.check_world_name(name)
    world = find_world(name)
    return messages.WorldToEdit(
        name, worlds.world_values(world), worlds.world_lines(world), _save_as(name)
    )


def _save_as(name: str) -> str:
    """The world's name if it belongs to the user, else a free one."""
    from learnblock.robots.simulated import known_worlds  # noqa: PLC0415

    if _is_own(name):
        return name
    taken = known_worlds()
    return next(free for n in count(2) if (free := f"{name}-{n}") not in taken)


def _is_own(name: str) -> bool:
    from learnblock.extensions import worlds  # noqa: PLC0415

    return name in worlds.own_names()


def _title(name: str) -> str:
    """The title of one of the user's worlds.

    Raises:
        UnknownNameError: there is no such world.
    """
    from learnblock.extensions import worlds  # noqa: PLC0415

    if name not in worlds.own_names():
        raise UnknownNameError("world", name, worlds.own_names())
    titles = {choice.name: choice.title for choice in catalog.world_choices()}
    return titles.get(name, name)


def _checked(values: dict[str, Any], robot: str) -> messages.WorldChecked:
    from learnblock.monitor import worlds  # noqa: PLC0415

    try:
        world = worlds.world_from_values(values)
    except WorldError as error:
        return messages.WorldChecked(tuple(diagnostic.message for diagnostic in error.diagnostics))
    unreachable = tuple(
        messages.UnreachableGoal(*goal) for goal in worlds.unreachable(world, robot)
    )
    return messages.WorldChecked((), worlds.world_lines(world), unreachable)


def _saved(name: str, values: dict[str, Any]) -> messages.WorldChecked | None:
    """Save a world, or return its mistakes."""
    from learnblock.monitor import worlds  # noqa: PLC0415

    try:
        worlds.save_world(name, values)
    except WorldError as error:
        return messages.WorldChecked(tuple(diagnostic.message for diagnostic in error.diagnostics))
    return None
