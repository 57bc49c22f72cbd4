"""The pauses of a program: at lines chosen by the debugger, and for input."""

from learnblock.runtime import messages
from learnblock.runtime.debugger import Debugger
from learnblock.runtime.status import State, Status
from learnblock.runtime.watcher import Watcher


class Pauses:
    """Pauses a program at breakpoints and for input, and reports that.

    Args:
        watcher: receives the reports, and is asked for input.
        debugger: decides where the program pauses; without one it never pauses.
    """

    def __init__(self, watcher: Watcher, debugger: Debugger | None) -> None:
        self.status = Status(watcher.state)
        #: Whether the program is waiting for an answer: permission to continue, or a line of input.
        self.awaits_answer = False
        self._watcher = watcher
        self._debugger = debugger
        if debugger:
            debugger.report_to(self.status)

    @property
    def at_lines(self) -> bool:
        """Whether the program may pause at lines."""
        return self._debugger is not None

    def hold(self, message: messages.Line) -> None:
        """Return when a program that has reached a line may run it."""
        self.awaits_answer = True
        if self._debugger and self._debugger.holds(message.number, message.depth):
            self.status.enter(State.HELD)
            self._watcher.held(message.number, message.variables)
            self._debugger.wait()
            self._watcher.resumed()
            self.status.leave(State.HELD)

    def input(self, prompt: str, *, stopping: bool) -> str | None:
        """The line of input for a program; None if there is none or the run is being stopped."""
        self.awaits_answer = True
        self.status.enter(State.INPUT)
        answer = None if stopping else self._watcher.input(prompt)
        self.status.leave(State.INPUT)
        return answer

    def end(self) -> None:
        """Never pause the program again: the run is being stopped."""
        if self._debugger:
            self._debugger.end()
        self._watcher.cancel_input()
