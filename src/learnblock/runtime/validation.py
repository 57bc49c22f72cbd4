"""Checks whether the messages of a child can be true: its host believes none unchecked.

A program runs in the child, so it can send whatever it likes. The types of the messages limit the
size of each field (`learnblock.runtime.messages`); here is checked what each field means.
"""

import math
import re
from collections.abc import Callable, Collection, Mapping
from typing import Any

import msgspec

from learnblock.errors import RobotConnectionError
from learnblock.runtime import messages
from learnblock.runtime.claims import NOT_CONTAINED, is_need, is_of_program, last_line
from learnblock.runtime.hosted_robot import HostedRobot
from learnblock.runtime.lines import MOST_LINES_AT_ONE_TIME
from learnblock.runtime.log.events import batch_problem
from learnblock.runtime.own_files import own_files
from learnblock.runtime.program import Program
from learnblock.runtime.variables import VariableReports

#: The most skills without effect that are counted.
MOST_MISSED = 1000
_ROBOTS = re.compile(r"learnblock\.robots(\.[A-Za-z_]\w*)+")


# Why: docs/decisions.md, "The host believes nothing"
class Validator:
    """Checks the messages of one child.

    Args:
        program: the program that it runs.
        robots: the modules besides ours from which it may import a ``Robot``.
        robot: its robot.
        variables: the reports of its variables.
        pauses: whether the program pauses at lines.
        log: whether it tells what it does.
    """

    def __init__(
        self,
        program: Program,
        robots: Collection[str],
        robot: HostedRobot,
        variables: VariableReports,
        *,
        pauses: bool,
        log: bool,
    ) -> None:
        self._last_line = last_line(program.python)
        self._robots = robots
        self._robot = robot
        self._variables = variables
        self._pauses = pauses
        self._log = log
        self._dead_ends = program.dead_ends
        self._is_contained = False
        #: When the last batch of the log ended, in ticks.
        self._ticks = 0
        #: The lines that ran at this step of the world. Its time may pass without a message.
        self._lines, self._step = 0, -1
        self._missed: set[tuple[str, str]] = set()
        self._checks: Mapping[type, Callable[[Any], None]] = {
            messages.Contained: self._check_contained,
            messages.Connect: self._check_connect,
            messages.Ask: self._check_call,
            messages.Command: self._check_call,
            messages.Sleep: self._check_sleep,
            messages.Send: _check_send,
            messages.ChangeGame: _check_change,
            messages.Called: _check_called,
            messages.Steps: self._check_steps,
            messages.Missing: self._check_missing,
            messages.Stuck: self._check_stuck,
            messages.Logged: self._check_logged,
            messages.Variables: self._check_variables,
            messages.Line: self._check_line,
            messages.Interrupted: self._check_interrupted,
            messages.Ended: self._check_ended,
        }

    def check(self, message: Any) -> None:
        """Check a message.

        Raises:
            RobotConnectionError: what it says cannot be true.
        """
        check = self._checks.get(type(message))
        if check:
            check(message)

    def _check_contained(self, _: messages.Contained) -> None:
        _require(not self._is_contained, "a program that begins twice")
        self._is_contained = True

    def _check_connect(self, message: messages.Connect) -> None:
        module = message.module
        is_known = module in self._robots or _ROBOTS.fullmatch(module)
        _require(is_known, "a robot that is not known")
        # Each robot has a time of its own.
        self._ticks, self._step = 0, -1

    def _check_call(self, message: messages.Ask | messages.Command) -> None:
        if not self._robot.offers(message.device, message.function):
            _refuse("a device or a function that the robot lacks")

    def _check_sleep(self, message: messages.Sleep) -> None:
        _require(self._robot.world.simulation is not None, "a wait for the world of a real robot")
        is_read = all(self._robot.offers(index, "read") for index in message.reads)
        _require(is_read, "a device that cannot be read")

    def _check_steps(self, message: messages.Steps) -> None:
        last, lines = self._last_line, 0
        for step in message.steps:
            kind = type(step)
            if kind is int:
                lines += 1
                if not 0 < step <= last:  # type: ignore[operator] # by its kind
                    _refuse("a line that the program lacks")
            elif kind is str:
                _require_skill(step)  # type: ignore[arg-type] # as above
            elif kind is messages.Called:
                _check_called(step)  # type: ignore[arg-type] # as above
            else:
                self._check_call(step)  # type: ignore[arg-type] # as above
        if (simulation := self._robot.world.simulation) is not None:
            if simulation.steps != self._step:
                self._step, self._lines = simulation.steps, 0
            self._lines += lines
            _require(self._lines <= MOST_LINES_AT_ONE_TIME, "more lines than are told at one time")

    def _check_missing(self, message: messages.Missing) -> None:
        _require_skill(message.skill)
        _require(is_need(message.device), "a device that is not known")
        self._missed.add((message.skill, message.device))
        _require(len(self._missed) <= MOST_MISSED, "too many skills without effect")

    def _check_logged(self, message: messages.Logged) -> None:
        _require(self._log, "events that are not kept")
        is_in_order = self._ticks <= message.first <= message.last
        _require(is_in_order, "events at a time before the last ones")
        self._ticks = message.last
        if problem := batch_problem(message.events):
            _refuse(problem)

    def _check_stuck(self, _: messages.Stuck) -> None:
        _require(self._dead_ends, "a loop that the program lacks")

    def _check_variables(self, _: messages.Variables) -> None:
        _require(self._variables.pending, "variables that were not asked for")

    def _check_line(self, message: messages.Line) -> None:
        _require(self._pauses, "a pause that was not asked for")
        _require(0 < message.number <= self._last_line, "a line that the program lacks")

    def _check_interrupted(self, message: messages.Interrupted) -> None:
        self._require_lines((message.line,))
        _require_own_file(message.file)

    def _check_ended(self, message: messages.Ended) -> None:
        self._require_lines(message.lines)
        if message.variables:
            _require(self._variables.enabled, "variables that were not asked for")
        if fault := message.fault:
            is_first = not self._is_contained and fault.phrase.code == NOT_CONTAINED
            _require(is_first or is_of_program(fault.phrase), "an error that is not known")
            self._require_lines(fault.lines)
            _require_own_file(fault.file)

    def _require_lines(self, lines: Collection[int]) -> None:
        _require(all(line <= self._last_line for line in lines), "a line that the program lacks")


def refused(reason: str) -> RobotConnectionError:
    """The error about a message that cannot be true."""
    return RobotConnectionError("run-not-a-message", reason=reason)


def decoded(value: msgspec.Raw) -> Any:
    """The value of a message to other robots.

    Raises:
        RobotConnectionError: it cannot be true.
    """
    try:
        return msgspec.msgpack.decode(value)
    except (msgspec.MsgspecError, RecursionError, UnicodeDecodeError, TypeError) as error:
        raise refused(str(error)) from error


def _check_called(message: messages.Called) -> None:
    _require_skill(message.skill)


def _check_send(message: messages.Send) -> None:
    _require(len(bytes(message.value)) <= messages.LARGEST_SENT, "a value that is too large")


def _check_change(message: messages.ChangeGame) -> None:
    _require(math.isfinite(message.amount), "an amount that is no number")


def _require_skill(name: str) -> None:
    # A program may add functions of its own.
    if not name.isidentifier():
        _refuse("a skill without a name")


def _require_own_file(name: str) -> None:
    _require(not name or name in own_files(), "a file that is not known")


def _require(condition: object, reason: str) -> None:
    if not condition:
        _refuse(reason)


def _refuse(reason: str) -> None:
    raise refused(reason)
