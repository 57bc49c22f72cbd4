"""Handlers of messages about the robot and the run."""

from anyio import to_thread

from learnblock.server import messages
from learnblock.server.pages.page import Handlers, Page

HANDLERS = Handlers()


@HANDLERS.add
async def _choose_robot(page: Page, message: messages.ChooseRobot) -> None:
    await page.session.robots.choose(page.part, message.name)


@HANDLERS.add
async def _choose_world(page: Page, message: messages.ChooseWorld) -> None:
    await page.session.robots.choose_world(message.name, message.variant)


@HANDLERS.add
async def _run(page: Page, message: messages.Run) -> None:
    if await to_thread.run_sync(page.sessions.block_files.have_changed):
        await page.sessions.renew_blocks(page.session)
    with page.sessions.starting(page.session):
        async with page.sessions.connections.reserved(page, page.session.parts.kinds):
            await page.session.runs.run(page.player, paused=message.paused)


@HANDLERS.add
async def _stop(page: Page, _: messages.Stop) -> None:
    await page.session.runs.stop()


@HANDLERS.add
async def _pause(page: Page, _: messages.Pause) -> None:
    page.player.pause()


@HANDLERS.add
async def _resume(page: Page, _: messages.Resume) -> None:
    page.player.resume()


@HANDLERS.add
async def _step(page: Page, message: messages.Step) -> None:
    page.player.step(over=message.over)


@HANDLERS.add
async def _set_speed(page: Page, message: messages.SetSpeed) -> None:
    page.session.runs.set_speed(message.factor)


@HANDLERS.add
async def _answer(page: Page, message: messages.Answer) -> None:
    page.player.answer(message.text)


@HANDLERS.add
async def _hold_keys(page: Page, message: messages.HoldKeys) -> None:
    page.session.keyboard.hold(page, message.keys)


@HANDLERS.add
async def _reset_world(page: Page, _: messages.ResetWorld) -> None:
    await page.session.runs.set_the_stage()


@HANDLERS.add
async def _place_robot(page: Page, message: messages.PlaceRobot) -> None:
    page.session.runs.place(page.player, message.x, message.y, message.heading)


@HANDLERS.add
async def _handle_robot(page: Page, message: messages.HandleRobot) -> None:
    page.player.handle(message.how)


@HANDLERS.add
async def _drive(page: Page, message: messages.Drive) -> None:
    page.session.runs.drive(page.player, message.advance, message.rotation)


@HANDLERS.add
async def _watch_camera(page: Page, message: messages.WatchCamera) -> None:
    page.watching = message.on
    page.player.watch()
