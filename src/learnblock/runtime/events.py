"""The events of a program, passed on to the trace and to the watcher."""

from collections.abc import Callable, Sequence

from learnblock.runtime import messages
from learnblock.runtime.hosted_robot import HostedRobot
from learnblock.runtime.messages import Called, Command
from learnblock.runtime.watcher import Watcher


class EventSender:
    """Passes on a program's lines, calls and prints.

    Args:
        robot: holds the recorder once the program has created its robot.
        watcher: receives the events.
    """

    def __init__(self, robot: HostedRobot, watcher: Watcher) -> None:
        self._robot = robot
        self._watcher = watcher
        #: Whether the watcher wants to know the lines.
        self.shows_lines = type(watcher).line is not Watcher.line
        self._shows_calls = type(watcher).called is not Watcher.called

    def steps(
        self, steps: Sequence[int | str | Called | Command], obey: Callable[[Command], object]
    ) -> None:
        """Record that lines are about to run and skills are called, and obey commands.

        Args:
            steps: the lines, calls and commands, in order.
            obey: carries out a command.
        """
        recorder = self._robot.active_recorder
        for step in steps:
            kind = type(step)
            if kind is Command:
                obey(step)  # type: ignore[arg-type] # by its kind
            elif recorder and kind is Called:
                recorder.note_call(step.skill, step.args)  # type: ignore[union-attr] # as above
            elif recorder:
                recorder.note(step)  # type: ignore[arg-type] # as above
            if self.shows_lines and kind is int:
                self._watcher.line(step)  # type: ignore[arg-type] # as above
            elif self._shows_calls:
                self._show_call(step)
        if recorder:
            # Together: only few commands leave a line between them.
            recorder.write_noted()

    def called(self, message: messages.Called) -> None:
        """Record the call of a skill."""
        if recorder := self._robot.active_recorder:
            recorder.called(message.skill, message.args, message.kwargs)
        self._watcher.called(message.skill, message.args, message.kwargs)

    def missing(self, message: messages.Missing) -> None:
        """Record that a skill had no effect because the robot lacks a device."""
        if recorder := self._robot.active_recorder:
            recorder.missing(message.skill, message.device)
        self._watcher.missing(message.skill, message.device)

    def printed(self, message: messages.Printed) -> None:
        """Record a print."""
        if recorder := self._robot.active_recorder:
            recorder.printed(message.text)
        self._watcher.printed(message.text)

    def _show_call(self, step: int | str | Called | Command) -> None:
        if isinstance(step, str):
            self._watcher.called(step, (), {})
        elif isinstance(step, Called):
            self._watcher.called(step.skill, step.args, {})
