"""Handlers of messages about the kept runs of a project."""

from anyio import to_thread

from learnblock.project.files.kept_runs import KeptRuns
from learnblock.server import messages
from learnblock.server.pages.page import Handlers, Page
from learnblock.server.runs.kept import OpenedRun, calls_beside, compared, opened

HANDLERS = Handlers()


@HANDLERS.add
async def _list(page: Page, _: messages.ListRuns) -> None:
    page.send(messages.KeptRuns(await to_thread.run_sync(_kept(page).runs)))


@HANDLERS.add
async def _open(page: Page, message: messages.OpenRun) -> None:
    runs, now = _kept(page), page.part.document

    def read() -> OpenedRun:
        return opened(runs.find(message.run), runs.read(message.run), now)

    page.session.runs.require_rest()
    page.player.show_kept(await to_thread.run_sync(read))


@HANDLERS.add
async def _close(page: Page, _: messages.CloseRun) -> None:
    page.player.shown_run.show_newest()


@HANDLERS.add
async def _name(page: Page, message: messages.NameRun) -> None:
    await to_thread.run_sync(_kept(page).name, message.run, message.name)
    await _tell(page)


@HANDLERS.add
async def _delete(page: Page, message: messages.DeleteRun) -> None:
    await to_thread.run_sync(_kept(page).delete, message.run)
    await _tell(page)


@HANDLERS.add
async def _compare(page: Page, message: messages.CompareRuns) -> None:
    runs = _kept(page)

    def compare() -> messages.RunsCompared:
        pair = [(run, runs.read(run)) for run in (message.first, message.second)]
        return compared(*pair)

    page.send(await to_thread.run_sync(compare))


@HANDLERS.add
async def _read_calls(page: Page, message: messages.ReadCallsBeside) -> None:
    runs = _kept(page)

    def read() -> messages.CallsBeside:
        return calls_beside(runs.read(message.first), runs.read(message.second))

    page.send(await to_thread.run_sync(read))


async def _tell(page: Page) -> None:
    page.session.runs_kept(await to_thread.run_sync(_kept(page).runs))


def _kept(page: Page) -> KeptRuns:
    return page.sessions.folder.kept_runs(page.session.name)
