"""Handlers of messages about the moments of the last run."""

from collections.abc import Mapping
from functools import partial

from anyio import to_thread

from learnblock.errors import LearnBlockError
from learnblock.server import messages
from learnblock.server.pages.page import Handler, Page
from learnblock.server.runs import telemetry
from learnblock.server.runs.looking import NO_TIMELINE


async def _read_timeline(page: Page, _: messages.ReadTimeline) -> None:
    player = page.player
    live = player.state == "running"
    read = player.looking and partial(player.looking.timeline, live=live)
    page.send(await to_thread.run_sync(read) if read else NO_TIMELINE)


async def _read_prediction(page: Page, _: messages.ReadPrediction) -> None:
    looking = page.player.require_looking()
    page.send(await to_thread.run_sync(looking.predicted))


async def _look_back(page: Page, message: messages.LookBack) -> None:
    looking = page.player.require_looking()
    page.send(await to_thread.run_sync(looking.past, message))


async def _read_past_picture(page: Page, message: messages.ReadPastPicture) -> None:
    looking = page.player.require_looking()
    picture = await to_thread.run_sync(looking.picture, message.time)
    if picture is None:
        raise LearnBlockError("play-nothing-to-look-back-at")
    page.send(telemetry.camera_frame(picture, past=True), picture.jpeg)


async def _read_values(page: Page, _: messages.ReadValues) -> None:
    player = page.player
    read = player.looking and partial(player.looking.values, player.variables)
    page.send(await to_thread.run_sync(read) if read else messages.ValuesThere())


async def _read_calls(page: Page, message: messages.ReadCalls) -> None:
    looking = page.player.require_looking()
    page.send(await to_thread.run_sync(looking.calls, message.first, message.last))


async def _read_questions(page: Page, message: messages.ReadQuestions) -> None:
    looking = page.player.require_looking()
    page.send(await to_thread.run_sync(looking.questions, message.block, message.time))


async def _ask_why(page: Page, message: messages.AskWhy) -> None:
    looking = page.player.require_looking()
    page.send(await to_thread.run_sync(looking.answer, message.question))


HANDLERS: Mapping[type, Handler] = {
    messages.ReadTimeline: _read_timeline,
    messages.ReadPrediction: _read_prediction,
    messages.LookBack: _look_back,
    messages.ReadPastPicture: _read_past_picture,
    messages.ReadValues: _read_values,
    messages.ReadCalls: _read_calls,
    messages.ReadQuestions: _read_questions,
    messages.AskWhy: _ask_why,
}
