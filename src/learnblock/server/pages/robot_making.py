"""Handlers of messages about new robots."""

from anyio import to_thread

from learnblock.errors import FileTakenError, NewNameError, RobotDescriptionError
from learnblock.server import catalog, messages
from learnblock.server.pages.page import Handlers, Page
from learnblock.storage.home import home

HANDLERS = Handlers()


@HANDLERS.add
async def _begin(page: Page, _: messages.BeginRobot) -> None:
    from learnblock.new.template import read  # noqa: PLC0415 - few pages make robots

    page.send(messages.RobotBegun(read("robot/description.toml")))


@HANDLERS.add
async def _make(page: Page, message: messages.MakeRobot) -> None:
    try:
        files = await to_thread.run_sync(_written, message.name.strip(), message.description)
    except RobotDescriptionError as error:
        problems = (
            messages.RobotProblem(diagnostic.message, diagnostic.line)
            for diagnostic in error.diagnostics
        )
        page.send(messages.RobotMade(message.name, problems=tuple(problems)))
        return
    page.sessions.send(messages.Robots(await to_thread.run_sync(catalog.robot_choices)))
    page.send(messages.RobotMade(message.name.strip(), files))


def _written(name: str, description: str) -> tuple[str, ...]:
    """Write a robot's files; return their paths.

    Raises:
        NewNameError: the robot can't have this name.
        RobotDescriptionError: the description is invalid.
        OSError: a file cannot be written.
    """
    from learnblock.new.files import write_new  # noqa: PLC0415 - as above
    from learnblock.new.names import check_robot_name  # noqa: PLC0415
    from learnblock.new.robot import files_at_home  # noqa: PLC0415
    from learnblock.new.robot_plan import named, parse_plan  # noqa: PLC0415

    check_robot_name(name)
    files = files_at_home(named(parse_plan(description), name), home())
    try:
        write_new(files)
    except FileTakenError:
        raise NewNameError("new-robot-exists", name=name) from None
    return tuple(map(str, files))
