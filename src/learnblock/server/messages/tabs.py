"""Messages about the robots of a project: each program has a tab, with its robot or robots."""

from typing import Annotated

from msgspec import Meta, Struct

from learnblock.running import MOST_ROBOTS
from learnblock.server.messages.base import Look, Name, ShortText, StateName, ToPage, Write

Count = Annotated[int, Meta(ge=1, le=MOST_ROBOTS)]

# From the page.


class AddTab(Write, frozen=True):
    """Add an empty program for one or more robots; the reply is `TabOpened`.

    Args:
        robot: the kind of robot.
        count: how many such robots run the program.
    """

    robot: Name
    count: Count = 1


class SetRobotCount(Write, frozen=True):
    """Set how many robots run a program.

    Args:
        name: the tab of the program; empty for the one that the page shows.
        count: how many robots run it.
    """

    name: ShortText
    count: Count


class OpenTab(Look, frozen=True):
    """Show another robot and its program, or the current one again if there is no such robot.

    The reply is `TabOpened`.

    Args:
        name: the tab of its program.
        robot: the name of the robot, if several run the program; empty for the first.
    """

    name: ShortText
    robot: ShortText = ""


class CloseTab(Write, frozen=True):
    """Close a program with its robots; the pages that show it receive `TabOpened` for another."""

    name: Name


class ReopenTab(Write, frozen=True):
    """Reopen the program that was closed last; the reply is `TabOpened`."""


class RenameTab(Write, frozen=True):
    """Rename a robot, or all that share a program."""

    name: Name
    new: Name


# To the page.


class TabRobot(Struct, frozen=True, omit_defaults=True):
    """One of the robots that share a program.

    Args:
        name: its name in the world.
        state: the state of its program.
        failed: whether its last run has ended with an error.
    """

    name: str
    state: StateName
    failed: bool = False


class Tab(Struct, frozen=True, omit_defaults=True):
    """A program with its robot, or with several of one kind.

    Args:
        name: the robot's name in the world; several are numbered.
        robot: the kind of robot.
        state: the state of the program; of several, the state that needs attention most.
        failed: whether the last run of a robot has ended with an error.
        mistakes: whether the program has errors.
        robots: the robots if there are several.
    """

    name: str
    robot: str
    state: StateName
    failed: bool = False
    mistakes: bool = False
    robots: tuple[TabRobot, ...] = ()


class Tabs(ToPage, frozen=True):
    """The programs of the project with their robots, after each change.

    Args:
        tabs: the programs in their order; none if there is only one robot.
        open: the one that this page shows; empty if there is only one robot.
        shows: the name of the robot that this page shows if several run the program.
    """

    tabs: tuple[Tab, ...] = ()
    open: str = ""
    shows: str = ""


class TabOpened(ToPage, frozen=True):
    """The page shows another robot of the project; see `Opened`.

    Args:
        tab: the name of its tab; empty if it is the only robot.
        robot: the kind of robot.
        world: the world.
        shown: the number that edits of its program have from now on.
        breakpoints: those of its program.
        shows: its name if several robots run the program.
    """

    tab: str
    robot: str
    world: str
    shown: int
    breakpoints: tuple[str, ...] = ()
    shows: str = ""
