"""Handlers of messages about the robot and the run."""

from collections.abc import Mapping

from anyio import to_thread

from learnblock.server import messages
from learnblock.server.pages.page import Handler, Page


async def _choose_robot(page: Page, message: messages.ChooseRobot) -> None:
    await page.session.choose_robot(page.part, message.name)


async def _choose_world(page: Page, message: messages.ChooseWorld) -> None:
    await page.session.choose_world(message.name, message.variant)


async def _run(page: Page, message: messages.Run) -> None:
    if await to_thread.run_sync(page.sessions.block_files.have_changed):
        await page.sessions.renew_blocks(page.session)
    async with page.sessions.connections.reserved(page, page.session.robots):
        await page.session.runs.run(page.player, paused=message.paused)


async def _stop(page: Page, _: messages.Stop) -> None:
    await page.session.runs.stop()


async def _pause(page: Page, _: messages.Pause) -> None:
    page.player.pause()


async def _resume(page: Page, _: messages.Resume) -> None:
    page.player.resume()


async def _step(page: Page, message: messages.Step) -> None:
    page.player.step(over=message.over)


async def _set_speed(page: Page, message: messages.SetSpeed) -> None:
    page.session.runs.set_speed(message.factor)


async def _answer(page: Page, message: messages.Answer) -> None:
    page.player.answer(message.text)


async def _hold_keys(page: Page, message: messages.HoldKeys) -> None:
    page.session.keyboard.hold(page, message.keys)


async def _reset_world(page: Page, _: messages.ResetWorld) -> None:
    await page.session.runs.set_the_stage()


async def _place_robot(page: Page, message: messages.PlaceRobot) -> None:
    page.session.runs.place(page.player, message.x, message.y, message.heading)


async def _handle_robot(page: Page, message: messages.HandleRobot) -> None:
    page.player.handle(message.how)


async def _drive(page: Page, message: messages.Drive) -> None:
    page.session.runs.drive(page.player, message.advance, message.rotation)


async def _watch_camera(page: Page, message: messages.WatchCamera) -> None:
    page.watching = message.on
    page.player.watch()


HANDLERS: Mapping[type, Handler] = {
    messages.ChooseRobot: _choose_robot,
    messages.ChooseWorld: _choose_world,
    messages.Run: _run,
    messages.Stop: _stop,
    messages.Pause: _pause,
    messages.Resume: _resume,
    messages.Step: _step,
    messages.SetSpeed: _set_speed,
    messages.Answer: _answer,
    messages.HoldKeys: _hold_keys,
    messages.ResetWorld: _reset_world,
    messages.PlaceRobot: _place_robot,
    messages.HandleRobot: _handle_robot,
    messages.Drive: _drive,
    messages.WatchCamera: _watch_camera,
}
