"""Handlers of what a class sends when two pupils play in one world; see `messages.guests`."""

from learnblock.errors import LearnBlockError
from learnblock.server import messages
from learnblock.server.pages.page import Handlers, Page

HANDLERS = Handlers()


@HANDLERS.add
async def _find_robot(page: Page, _: messages.FindGuestRobot) -> None:
    page.require_class()
    page.give(_robot_for_guest(page))


def _robot_for_guest(page: Page) -> messages.GuestRobot:
    if not page.has_session:
        return messages.GuestRobot(lack="project")
    session = page.session
    if session.coach:
        return messages.GuestRobot(lack="lesson")
    # Robots that share a program are no guest's.
    if len(session.parts) == 1:
        return messages.GuestRobot(lack="robot")
    return messages.GuestRobot(session.name, session.parts.last.name)


@HANDLERS.add
async def _give_program(page: Page, _: messages.GiveProgram) -> None:
    page.require_class()
    if not page.has_session:
        page.give(messages.ProgramGiven())
        return
    part = page.part
    saved = part.saved_with(part.document)
    program = messages.GivenProgram(saved.text, saved.is_python)
    page.give(messages.ProgramGiven(program, mistakes=part.document.first_error is not None))


@HANDLERS.add
async def _keep_keys_apart(page: Page, _: messages.KeepKeysApart) -> None:
    page.require_class()
    page.session.keyboard.keep_apart(page, page.player)


@HANDLERS.add
async def _take_guest(page: Page, message: messages.TakeGuest) -> None:
    page.require_class()
    part, program = page.part, message.program
    try:
        # The robot that the guest drove may have been closed.
        if part is page.session.parts.first:
            raise LearnBlockError("tabs-no-such", name=part.name)
        await part.take_guest(page, program.text, is_python=program.is_python)
    except LearnBlockError:
        page.give(messages.GuestTaken())
        return
    page.session.keyboard.keep_apart(page, part.players[0])
    page.give(messages.GuestTaken(fits=True))
