"""Passes the events of a run from its own thread to the event loop."""

import asyncio
import threading
from collections.abc import Callable
from typing import Protocol

from learnblock.running import Report
from learnblock.runtime.messages import Variables
from learnblock.runtime.status import State
from learnblock.runtime.watcher import Watcher
from learnblock.server.runs.console import Console


class Audience(Protocol):
    """The receiver of a run's events, in the event loop."""

    def on_state(self, state: State) -> None: ...

    def on_held(self, line: int) -> None: ...

    def on_variables(self, variables: Variables) -> None: ...

    def on_input(self, prompt: str) -> None: ...

    def on_ended(self, report: Report | Exception) -> None: ...


class RunWatcher(Watcher):
    """Watches one run.

    Args:
        audience: receives the events, in the event loop that is running now.
        console: takes the output.
    """

    def __init__(self, audience: Audience, console: Console) -> None:
        self._audience = audience
        self._console = console
        self._loop = asyncio.get_running_loop()
        #: The line of the program's Python that is running; 0 before the first.
        self.current_line = 0
        self._input = threading.Condition()
        self._answer: str | None = None
        self._cancelled = False

    # The run's thread.

    def printed(self, text: str) -> None:
        self._console.printed(text)

    def line(self, number: int) -> None:
        self.current_line = number

    def state(self, state: State) -> None:
        self._pass_on(self._audience.on_state, state)

    def held(self, line: int, variables: Variables) -> None:
        # The variables first: so that the page has them when it shows the pause.
        self._pass_on(self._audience.on_variables, variables)
        self._pass_on(self._audience.on_held, line)

    def variables(self, variables: Variables) -> None:
        self._pass_on(self._audience.on_variables, variables)

    def input(self, prompt: str) -> str | None:
        with self._input:
            self._answer = None
            self._pass_on(self._audience.on_input, prompt)
            self._input.wait_for(lambda: self._answer is not None or self._cancelled)
            return self._answer

    def cancel_input(self) -> None:
        with self._input:
            self._cancelled = True
            self._input.notify_all()

    def ended(self, report: Report | Exception) -> None:
        """Report the end of the run."""
        self._pass_on(self._audience.on_ended, report)

    # The event loop.

    def answer(self, text: str) -> None:
        """Send the program the line that it is waiting for."""
        with self._input:
            self._answer = text
            self._input.notify_all()

    def _pass_on(self, listener: Callable[..., None], *args: object) -> None:
        self._loop.call_soon_threadsafe(listener, *args)
