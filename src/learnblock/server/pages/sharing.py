"""Handlers of messages about links that hold a project."""

from collections.abc import Iterator

from anyio import to_thread

from learnblock.i18n import Phrase
from learnblock.project.document.document import Document
from learnblock.project.files.share_link import LinkError, SharedProject, link_of, read_link
from learnblock.server import messages
from learnblock.server.pages.page import Handlers, Page
from learnblock.server.runs.looking import Looking

HANDLERS = Handlers()


@HANDLERS.add
async def _make_link(page: Page, message: messages.MakeLink) -> None:
    session = page.session
    last = session.proof.last_run()
    run = None if isinstance(last, Phrase) else last
    shared = SharedProject(session.project, session.variant, run)
    try:
        link = await to_thread.run_sync(link_of, shared)
    except LinkError as error:
        page.send(messages.ShareLink(message.request, "", problem=error.phrase))
        return
    if isinstance(last, Phrase):
        page.send(messages.ShareLink(message.request, link, problem=last))
        return
    page.send(messages.ShareLink(message.request, link, last.trace_sha256, last.seconds))


@HANDLERS.add
async def _export_run(page: Page, message: messages.ExportRun) -> None:
    page.session.runs.require_rest()
    runs, name = list(_shown_runs(page)), page.session.name

    def write() -> bytes:
        from learnblock.server.runs.take_home import RobotRun, Titles, run_page  # noqa: PLC0415 - the page opens before

        robots = [RobotRun(looking.log, document, kind) for looking, document, kind in runs]
        return run_page(robots, Titles(name, message.language, message.pupil)).encode()

    page.send(messages.RunExported(f"{name}.html", await to_thread.run_sync(write)))


def _shown_runs(page: Page) -> Iterator[tuple[Looking, Document, str]]:
    """The kept run that the page shows, or the newest run of each robot."""
    looking = page.player.shown_run.require_looking()
    if page.player.shown_run.kept:
        yield looking, page.part.document, page.part.robot.name
        return
    for part in page.session.parts:
        for player in part.players:
            if newest := player.shown_run.newest:
                yield newest, part.document, part.robot.name


@HANDLERS.add
async def _open_link(page: Page, message: messages.OpenLink) -> None:
    shared = await to_thread.run_sync(read_link, message.link)
    unchanged = await page.sessions.find_unchanged(shared.project)
    if unchanged:
        session = await page.sessions.open(unchanged)
    else:
        page.new_projects.take()
        session = await page.sessions.start(shared.project)
    await session.follow_link(shared)
    await page.move_to(session)
    # The file of a new project does not carry anything yet.
    session.archive.changed()
