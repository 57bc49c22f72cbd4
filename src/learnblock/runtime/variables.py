"""The variables of a program, reported several times a second and at its end."""

from time import monotonic
from typing import Any

from learnblock.runtime import messages
from learnblock.runtime.conversation import Conversation
from learnblock.runtime.watcher import Watcher

#: Seconds of the wall clock between two reports.
PERIOD = 0.2
#: Seconds within which a program waiting for its world must send its variables.
TIMEOUT = 0.2


class VariableReports:
    """Asks the program for its variables and passes them on.

    Args:
        watcher: receives the variables.
    """

    def __init__(self, watcher: Watcher) -> None:
        #: Whether variables are reported; any thread may set it.
        self.enabled = False
        #: Whether the program has yet to answer.
        self.pending = False
        self._watcher = watcher
        self._last = 0.0

    @property
    def are_due(self) -> bool:
        """Whether the program should be asked again."""
        return self.enabled and monotonic() - self._last > PERIOD

    def request(self, conversation: Conversation) -> None:
        """Ask the program, unless it has yet to answer."""
        self._last = monotonic()
        if not self.pending:
            self.pending = True
            conversation.send_unasked(messages.ShowVariables())

    def receive(self, message: messages.Variables) -> None:
        """Pass on the variables that the program sent."""
        self.pending, self._last = False, monotonic()
        if self.enabled:
            self._watcher.variables(message)

    def wait(self, conversation: Conversation) -> Any:
        """The next message from a program that was asked; None if it has answered or is slow.

        Raises:
            EOFError: the program is gone.
        """
        left = self._last + TIMEOUT - monotonic()
        return conversation.receive(left) if self.pending and left > 0 else None
