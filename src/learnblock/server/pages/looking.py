"""Handlers of messages about the moments of the last run."""

from functools import partial

from anyio import to_thread

from learnblock.errors import LearnBlockError
from learnblock.server import messages
from learnblock.server.pages.page import Handlers, Page
from learnblock.server.runs import telemetry
from learnblock.server.runs.looking import NO_TIMELINE

HANDLERS = Handlers()


@HANDLERS.add
async def _read_timeline(page: Page, _: messages.ReadTimeline) -> None:
    looking, live = page.player.shown_run.looking, page.player.state == "running"
    read = looking and partial(looking.timeline, live=live)
    page.send(await to_thread.run_sync(read) if read else NO_TIMELINE)


@HANDLERS.add
async def _read_prediction(page: Page, _: messages.ReadPrediction) -> None:
    looking = page.player.shown_run.require_looking()
    page.send(await to_thread.run_sync(looking.predicted))


@HANDLERS.add
async def _look_back(page: Page, message: messages.LookBack) -> None:
    looking = page.player.shown_run.require_looking()
    page.send(await to_thread.run_sync(looking.past, message))


@HANDLERS.add
async def _read_past_picture(page: Page, message: messages.ReadPastPicture) -> None:
    looking = page.player.shown_run.require_looking()
    picture = await to_thread.run_sync(looking.picture, message.time)
    if picture is None:
        raise LearnBlockError("play-nothing-to-look-back-at")
    page.send(telemetry.camera_frame(picture, past=True), picture.jpeg)


@HANDLERS.add
async def _read_values(page: Page, _: messages.ReadValues) -> None:
    looking = page.player.shown_run.looking
    read = looking and partial(looking.values, page.player.variables)
    page.send(await to_thread.run_sync(read) if read else messages.ValuesThere())


@HANDLERS.add
async def _read_calls(page: Page, message: messages.ReadCalls) -> None:
    looking = page.player.shown_run.require_looking()
    page.send(await to_thread.run_sync(looking.calls, message.first, message.last))


@HANDLERS.add
async def _read_questions(page: Page, message: messages.ReadQuestions) -> None:
    looking = page.player.shown_run.require_looking()
    page.send(await to_thread.run_sync(looking.questions, message.block, message.time))


@HANDLERS.add
async def _ask_why(page: Page, message: messages.AskWhy) -> None:
    looking = page.player.shown_run.require_looking()
    page.send(await to_thread.run_sync(looking.answer, message.question))
