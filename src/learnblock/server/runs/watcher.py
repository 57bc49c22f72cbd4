"""Passes the events of a run from its own thread to the event loop."""

import asyncio
import threading
from collections.abc import Callable, Collection
from typing import TYPE_CHECKING

from learnblock.running import Report
from learnblock.runtime.messages import Variables
from learnblock.runtime.status import State
from learnblock.runtime.watcher import Watcher
from learnblock.server.runs.console import Voice

if TYPE_CHECKING:
    from learnblock.server.runs.player import Player


class RunWatcher(Watcher):
    """Watches one run.

    Args:
        player: receives the events, in the event loop that is running now.
        voice: takes the output.
    """

    def __init__(self, player: "Player", voice: Voice) -> None:
        self._player = player
        self._voice = voice
        self._loop = asyncio.get_running_loop()
        #: The line of the program's Python that is running; 0 before the first.
        self.current_line = 0
        self._wants_keys = False
        self._input = threading.Condition()
        self._answer: str | None = None
        self._cancelled = False
        #: Whether the run was given up: its events are no longer passed on.
        self._is_detached = False

    # The run's thread.

    def printed(self, text: str) -> None:
        if not self._is_detached:
            self._voice.printed(text)

    def line(self, number: int) -> None:
        self.current_line = number

    def state(self, state: State) -> None:
        self._pass_on(self._player.on_state, state)

    def held(self, line: int, variables: Variables) -> None:
        # The variables first: so that the page has them when it shows the pause.
        self._pass_on(self._player.on_variables, variables)
        self._pass_on(self._player.on_held, line)

    def variables(self, variables: Variables) -> None:
        self._pass_on(self._player.on_variables, variables)

    def input(self, prompt: str) -> str | None:
        with self._input:
            self._answer = None
            self._pass_on(self._player.on_input, prompt)
            self._input.wait_for(lambda: self._answer is not None or self._cancelled)
            return self._answer

    def cancel_input(self) -> None:
        with self._input:
            self._cancelled = True
            self._input.notify_all()

    def held_keys(self, time: float) -> Collection[str]:
        del time
        if self._is_detached:
            return ()
        if not self._wants_keys:
            self._wants_keys = True
            self._pass_on(self._player.on_keys_wanted)
        return self._player.held_keys()

    def ended(self, report: Report | Exception) -> None:
        """Report the end of the run."""
        self._pass_on(self._player.on_ended, report)

    # The event loop.

    def answer(self, text: str) -> None:
        """Send the program the line that it is waiting for."""
        with self._input:
            self._answer = text
            self._input.notify_all()

    def detach(self) -> None:
        """Stop passing on events of a run that was given up: another one may have begun."""
        self._is_detached = True

    # Both.

    def _pass_on(self, listener: Callable[..., None], *args: object) -> None:
        self._loop.call_soon_threadsafe(self._deliver, listener, *args)

    def _deliver(self, listener: Callable[..., None], *args: object) -> None:
        if not self._is_detached:
            listener(*args)
