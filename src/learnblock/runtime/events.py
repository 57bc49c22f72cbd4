"""The events of a program, passed on to the trace and to the watcher."""

from learnblock.runtime import messages
from learnblock.runtime.hosted_robot import HostedRobot
from learnblock.runtime.watcher import Watcher


class Events:
    """Passes on a program's lines, calls and prints.

    Args:
        robot: holds the recorder once the program has created its robot.
        watcher: receives the events.
    """

    def __init__(self, robot: HostedRobot, watcher: Watcher) -> None:
        self._robot = robot
        self._watcher = watcher

    def lines(self, message: messages.Lines) -> None:
        """Record that lines are about to run."""
        if recorder := self._robot.active_recorder:
            recorder.lines(message.numbers)
        for number in message.numbers:
            self._watcher.line(number)

    def called(self, message: messages.Called) -> None:
        """Record the call of a skill."""
        if recorder := self._robot.active_recorder:
            recorder.called(message.skill, message.args, message.kwargs)

    def missing(self, message: messages.Missing) -> None:
        """Record that a skill had no effect because the robot lacks a device."""
        if recorder := self._robot.active_recorder:
            recorder.missing(message.skill, message.device)

    def printed(self, message: messages.Printed) -> None:
        """Record a print."""
        if recorder := self._robot.active_recorder:
            recorder.printed(message.text)
        self._watcher.printed(message.text)
