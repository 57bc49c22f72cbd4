"""The robots of a notebook's kernel, and what happens to them with its cells."""

import ast
import builtins
import sys
import weakref
from contextlib import suppress
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING, Any

from learnblock.client import Client, endings
from learnblock.devices import Base
from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase, Value, translate
from learnblock.i18n.reader import system_language
from learnblock.notebook.answers import CellAnswer, answer_about
from learnblock.notebook.cell_program import CellProgram
from learnblock.notebook.cell_source import CellPart, cell_parts
from learnblock.notebook.robot_log import RobotLog
from learnblock.notebook.ways import CellWay, SimulatedWay, name_of, way_of
from learnblock.robots.real import RealRobot
from learnblock.robots.simulated.robot import SimulatedRobot
from learnblock.runtime.log.instrumenting import NOTING
from learnblock.runtime.log.noting import THROUGH

if TYPE_CHECKING:
    from learnblock.notebook.cell_pages import ShownCells


@cache
def session_of(shell: Any) -> "NotebookSession":
    """The session of IPython's shell."""
    return NotebookSession(shell)


class NotebookSession:
    """The robots that were made in one kernel; see `learnblock.client.notebooks.Notebook`.

    Args:
        shell: IPython's shell, which tells when cells begin and end.
    """

    def __init__(self, shell: Any) -> None:
        self._shell = shell
        self._cells = CellProgram()
        #: The present cells as they were typed: a magic may run one inside another.
        self._running: list[str] = []
        #: What the innermost of them may run.
        self._parts: list[CellPart] = []
        #: The number of the last cell that has ended, as its prompt shows it.
        self._number = 0
        #: The robots in the order in which they were made. One that no name refers to any more,
        #: as after its cell has run again, goes with its world.
        self._members: list[weakref.ref[Client]] = []
        _let_notes_pass()
        shell.ast_transformers.append(self)
        shell.events.register("pre_run_cell", self._begin_cell)
        shell.events.register("post_run_cell", self._end_cell)

    def make_room(self, robot: Client) -> None:
        """Disconnect an earlier robot that is the same device as one that is about to connect."""
        for earlier in self.robots():
            if _is_same_device(earlier, robot):
                earlier.stop()
                _say("notebook-disconnected", robot=name_of(earlier))

    def join(self, robot: Client) -> None:
        """Take a robot in that has been connected; one with a new world says so."""
        if robot.lockstep and any(earlier.lockstep for earlier in self.robots()):
            _say("notebook-new-world", world=str(robot.conditions()["world"]))
        self._cells.robot_module = type(robot).__module__
        way = way_of(robot)
        robot.membership = _Membership(way, RobotLog(robot, way))
        self._members.append(weakref.ref(robot, self._members.remove))
        if isinstance(robot, SimulatedRobot):
            # At the end of a kernel, nothing outside of it has to be stopped.
            endings.forget(robot.stop)

    def show(self, robot: Client, *, after_each_cell: bool) -> None:
        """Show a robot after this cell, and after each cell that moves it, or no longer."""
        membership = _membership(robot)
        membership.is_shown = after_each_cell
        membership.way.is_asked_for = after_each_cell

    def why(self, robot: Client, question: str) -> CellAnswer:
        """Answer a question about what a robot has done; without one, say what can be asked."""
        return answer_about(_membership(robot).log.recorded(self._cells), self._cells, question)

    def robots(self) -> list[Client]:
        """Those that are connected."""
        return [robot for robot in self._alive() if not robot.stopped]

    def _alive(self) -> list[Client]:
        return [robot for member in self._members if (robot := member())]

    # Called by IPython.

    def _begin_cell(self, cell: Any) -> None:
        self._enter(cell.raw_cell)
        if len(self._running) > 1:
            return
        for robot in self.robots():
            _membership(robot).way.begin_cell()
        simulated = [robot for robot in self.robots() if isinstance(robot, SimulatedRobot)]
        # The time is that of the last one; the others would be kept by it.
        for robot in simulated[-1:]:
            robot.take_time()

    def _enter(self, cell: str) -> None:
        self._running.append(cell)
        # A cell inside another one is its last lines.
        above = self._running[0].rstrip().count("\n") - cell.rstrip().count("\n")
        self._parts = []
        # IPython reports itself what is wrong with a cell.
        with suppress(SyntaxError):
            self._parts = list(cell_parts(cell, self._shell.transform_cell, max(above, 0)))

    def visit(self, tree: ast.Module) -> ast.Module:
        """Let a cell note its steps, and what a magic runs of it."""
        try:
            dumped = ast.dump(tree)
            for part in self._parts:
                if ast.dump(ast.parse(part.source)) == dumped:
                    return self._cells.add(part, self._number + 1)
        except (SyntaxError, ValueError, RecursionError):
            # With an await outside a function, for example.
            pass
        return tree

    def _end_cell(self, result: Any) -> None:
        # The cell that makes the first robot has begun before there was a session.
        if self._running:
            self._running.pop()
        if not result.success:
            for robot in self.robots():
                _stop_wheels(robot)
        if self._running:
            return
        self._number = result.execution_count or self._number
        for robot in self.robots():
            if isinstance(robot, SimulatedRobot):
                # The kernel asks for the time, too, and its world would go on between cells.
                robot.leave_time()
        for robot in self._alive():
            membership = _membership(robot)
            if membership.is_shown and membership.way.is_worth_showing():
                self._show(membership)

    def _show(self, membership: "_Membership") -> None:
        # Only who shows a robot needs what makes pages.
        from learnblock.notebook.cell_pages import ShownCells, cell_page  # noqa: PLC0415

        way, cells = membership.way, self._cells
        membership.shown = membership.shown or ShownCells(self._shell.display_pub.publish)
        is_simulated = isinstance(way, SimulatedWay)
        page = cell_page(membership.log, cells, self._number, *way.span) if is_simulated else ""
        membership.shown.show(way.shown(), page)


@dataclass
class _Membership:
    """What a session keeps of a robot, as long as there is the robot.

    Args:
        way: its way.
        log: what it has done.
        is_shown: whether it is shown after each cell that moves it.
        shown: the cells that have shown it, once there is one.
    """

    way: CellWay
    log: RobotLog
    is_shown: bool = False
    shown: "ShownCells | None" = None


def _membership(robot: Client) -> _Membership:
    membership: _Membership = robot.membership
    return membership


def _let_notes_pass() -> None:
    """Let cells note their steps before there is a robot whose log takes them."""
    for name in NOTING:
        setattr(builtins, name, THROUGH)


def _is_same_device(robot: Client, other: Client) -> bool:
    """Whether two real robots are reached in the same way."""
    return (
        isinstance(robot, RealRobot)
        and isinstance(other, RealRobot)
        and type(robot) is type(other)
        and robot.settings == other.settings
    )


def _stop_wheels(robot: Client) -> None:
    """Let a robot stand whose cell was stopped or has failed; it stays connected."""
    for _, device in robot.devices():
        if isinstance(device, Base):
            # Of a robot that is out of reach, the cell's own error tells that.
            with suppress(LearnBlockError):
                device.stop()


def _say(code: str, **values: Value) -> None:
    sys.stdout.write(f"{translate(Phrase(code, **values), system_language())}\n")
