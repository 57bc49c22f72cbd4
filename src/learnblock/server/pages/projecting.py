"""Handlers of messages about projects."""

from collections.abc import Mapping
from dataclasses import replace

from anyio import to_thread

from learnblock import running
from learnblock.i18n import Phrase
from learnblock.server import catalog, messages
from learnblock.server.pages.page import Handler, Page
from learnblock.server.projects.packing import fits
from learnblock.server.projects.project_file import LARGEST, Project
from learnblock.server.sessions.prepared import DEFAULT_WORLD

_EMPTY = "main:\n    pass\nend\n"


async def _open(page: Page, message: messages.Open) -> None:
    await page.move_to(await page.sessions.open(message.name))


async def _new(page: Page, message: messages.New) -> None:
    page.new_projects.take()
    project = await to_thread.run_sync(new_project, message)
    await page.move_to(await page.sessions.start(project))


async def _import(page: Page, message: messages.Import) -> None:
    page.new_projects.take()
    folder = page.sessions.folder
    project = await to_thread.run_sync(folder.import_file, message.filename, message.text)
    await page.move_to(await page.sessions.start(project))
    page.session.archive.changed()


async def _import_original(page: Page, message: messages.ImportOriginal) -> None:
    page.new_projects.take()
    folder = page.sessions.folder
    project, report = await to_thread.run_sync(
        folder.import_original, message.filename, message.content, message.libraries.get
    )
    await page.move_to(await page.sessions.start(project))
    page.send(messages.OriginalImported(message.filename, report.changed, report.missing))


async def _save_as(page: Page, message: messages.SaveAs) -> None:
    page.new_projects.take()
    await page.move_to(await page.sessions.start(replace(page.session.project, name=message.name)))
    # The file of the copy does not carry anything yet.
    page.session.archive.changed()


async def _rename(page: Page, message: messages.RenameProject) -> None:
    await page.sessions.rename(page.session, message.name)


async def _delete(page: Page, message: messages.Delete) -> None:
    await page.sessions.delete(message.name)
    await _list(page, messages.ListProjects())


async def _export(page: Page, message: messages.Export) -> None:
    folder, project = page.sessions.folder, page.session.project
    filename, text = await to_thread.run_sync(folder.export, project, message.format)
    page.send(messages.File(filename, text))
    if message.format == "learnblock" and not await to_thread.run_sync(fits, project):
        page.send(messages.Failed(Phrase("project-carries-less", limit=LARGEST)))


async def _list(page: Page, _: messages.ListProjects) -> None:
    entries = await to_thread.run_sync(page.sessions.folder.entries)
    page.send(messages.Projects(tuple(entries)))


def new_project(message: messages.New) -> Project:
    """Create a project with the program of an example, or with an empty one."""
    if message.example is None:
        return _project(message.name, _EMPTY, running.DEFAULT_ROBOT, DEFAULT_WORLD)
    example = catalog.example(message.example)
    text = running.read_text(running.example(f"{example.name}.bt"))
    return _project(message.name, text, example.robot, example.world)


def _project(name: str, blocktext: str, robot: str, world: str) -> Project:
    return Project(name=name, blocktext=blocktext, robot=robot, world=world)


HANDLERS: Mapping[type, Handler] = {
    messages.Open: _open,
    messages.New: _new,
    messages.Import: _import,
    messages.ImportOriginal: _import_original,
    messages.SaveAs: _save_as,
    messages.RenameProject: _rename,
    messages.Delete: _delete,
    messages.Export: _export,
    messages.ListProjects: _list,
}
