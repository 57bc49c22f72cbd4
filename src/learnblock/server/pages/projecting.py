"""Handlers of messages about projects, their history and the code that they carry."""

from collections.abc import Iterator
from dataclasses import replace

from anyio import to_thread

from learnblock import robots, running
from learnblock.blocks import block_sets
from learnblock.i18n import Phrase
from learnblock.project.files import unpacking
from learnblock.project.files.exchange import export
from learnblock.project.files.packing import fits
from learnblock.project.files.project import Project, ProjectPart
from learnblock.project.files.project_file import LARGEST
from learnblock.server import catalog, messages
from learnblock.server.pages import custom_blocks, libraries
from learnblock.server.pages.page import Handlers, Page
from learnblock.server.sessions.prepared import DEFAULT_WORLD, EMPTY

HANDLERS = Handlers()


@HANDLERS.add
async def _open(page: Page, message: messages.Open) -> None:
    await page.move_to(await page.sessions.open(message.name), message.tab)


@HANDLERS.add
async def _new(page: Page, message: messages.New) -> None:
    page.new_projects.take()
    project = await to_thread.run_sync(new_project, message)
    await page.move_to(await page.sessions.start(project))


@HANDLERS.add
async def _open_example(page: Page, message: messages.OpenExample) -> None:
    wanted = messages.New(message.name, message.example, message.robot, language=message.language)
    project = await to_thread.run_sync(new_project, wanted)
    unchanged = await page.sessions.find_unchanged(project)
    if unchanged:
        session = await page.sessions.open(unchanged)
    else:
        page.new_projects.take()
        session = await page.sessions.start(project)
    await page.move_to(session)


@HANDLERS.add
async def _close(page: Page, _: messages.CloseProject) -> None:
    await page.move_out()


@HANDLERS.add
async def _import(page: Page, message: messages.Import) -> None:
    page.new_projects.take()
    folder = page.sessions.folder
    project = await to_thread.run_sync(folder.import_file, message.filename, message.text)
    await page.move_to(await page.sessions.start(project))
    page.session.archive.changed()


@HANDLERS.add
async def _import_original(page: Page, message: messages.ImportOriginal) -> None:
    page.new_projects.take()
    folder = page.sessions.folder
    project, report = await to_thread.run_sync(
        folder.import_original, message.filename, message.content, message.libraries.get
    )
    await page.move_to(await page.sessions.start(project))
    page.send(messages.OriginalImported(message.filename, report.changed, report.missing))


@HANDLERS.add
async def _save_as(page: Page, message: messages.SaveAs) -> None:
    page.new_projects.take()
    project = page.session.project
    copy = await page.sessions.start(replace(project, name=message.name))
    await _copy_picture(page, project.name, copy.name)
    await copy.resume_lesson()
    await page.move_to(copy)
    # The file of the copy does not carry anything yet.
    page.session.archive.changed()


@HANDLERS.add
async def _rename(page: Page, message: messages.RenameProject) -> None:
    if message.project:
        await page.sessions.rename_unshown(message.project, message.name)
        await _list(page, messages.ListProjects())
    else:
        await page.sessions.rename(page.session, message.name)


@HANDLERS.add
async def _copy(page: Page, message: messages.CopyProject) -> None:
    page.new_projects.take()
    session = await page.sessions.open(message.project)
    copy = await page.sessions.start(replace(session.project, name=message.name))
    # The file of the copy does not carry anything yet.
    copy.archive.changed()
    for opened in (session, copy):
        page.sessions.left(opened)
    await _copy_picture(page, session.name, copy.name)
    await _list(page, messages.ListProjects())


async def _copy_picture(page: Page, name: str, copy: str) -> None:
    folder = page.sessions.folder
    await to_thread.run_sync(folder.copy_picture, name, copy)
    await to_thread.run_sync(folder.lesson(name).copy_to, folder.lesson(copy), page.browser)


@HANDLERS.add
async def _keep_picture(page: Page, message: messages.KeepPicture) -> None:
    # The page made the picture while it was perhaps leaving the project.
    if not page.has_session or page.session.name != message.project:
        return
    folder = page.sessions.folder
    await to_thread.run_sync(folder.keep_picture, message.project, message.content)
    await _list(page, messages.ListProjects())


@HANDLERS.add
async def _delete(page: Page, message: messages.Delete) -> None:
    await page.sessions.delete(message.name)
    await _list(page, messages.ListProjects())


@HANDLERS.add
async def _export(page: Page, message: messages.Export) -> None:
    if message.project:
        session = await page.sessions.open(message.project)
        page.sessions.left(session)
        project, part = session.project, 0
    else:
        project, part = page.session.project, page.session.parts.index(page.part)
    filename, text = await to_thread.run_sync(export, project, message.format, part)
    page.send(messages.File(filename, text))
    if message.format == "learnblock" and not await to_thread.run_sync(fits, project):
        page.send(messages.Failed(Phrase("project-carries-less", limit=LARGEST)))


@HANDLERS.add
async def _list(page: Page, _: messages.ListProjects) -> None:
    entries = await to_thread.run_sync(page.sessions.folder.entries)
    page.send(messages.Projects(tuple(entries)))


@HANDLERS.add
async def _list_history(page: Page, _: messages.ListHistory) -> None:
    folder, name = page.sessions.folder, page.session.name
    versions = await to_thread.run_sync(folder.versions, name)
    runs = await to_thread.run_sync(folder.runs, name)
    page.send(messages.History(versions, runs))


@HANDLERS.add
async def _restore(page: Page, message: messages.Restore) -> None:
    folder, session = page.sessions.folder, page.session
    earlier = await to_thread.run_sync(folder.read_version, session.name, message.version)
    await session.restore(earlier)


@HANDLERS.add
async def _install(page: Page, _: messages.InstallOffered) -> None:
    session = page.session
    code = session.offered
    await to_thread.run_sync(unpacking.install, code)
    await to_thread.run_sync(page.sessions.block_files.have_changed)
    session.installed(code)
    await page.sessions.renew_blocks(session)
    page.sessions.send(await to_thread.run_sync(custom_blocks.listed))
    page.sessions.send(await to_thread.run_sync(libraries.listed))


def new_project(message: messages.New) -> Project:
    """Create a project with the program of an example, or with an empty one."""
    if message.example is None:
        robot = robots.find(message.robot or running.DEFAULT_ROBOT).name
        world = message.world or DEFAULT_WORLD
        return Project(
            name=message.name,
            blocktext=EMPTY,
            robot=robot,
            world=world,
            shown=block_sets.of_new_projects(),
        )
    example = catalog.example(message.example)
    project = Project(name=message.name, world=example.world)
    project = project.with_parts(list(_parts(example.name, message.language)))
    if message.robot and catalog.suits(message.robot, example.name):
        return replace(project, robot=message.robot)
    return project


def _parts(example: str, language: str) -> Iterator[ProjectPart]:
    for program, robot, count in catalog.example_programs(example):
        text = running.example_text(program, language)
        yield ProjectPart(program.rpartition("/")[2], text, robot=robot, count=count)
