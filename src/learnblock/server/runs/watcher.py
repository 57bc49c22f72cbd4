"""Passes the events of a run from its own thread to the event loop."""

import asyncio
import threading
from collections.abc import Callable, Collection, Mapping, Sequence
from typing import Any, Protocol

from learnblock.running import Report
from learnblock.running.recorded_keys import RecordedKeys
from learnblock.runtime.messages import Variables
from learnblock.runtime.status import State
from learnblock.runtime.watcher import Watcher
from learnblock.server import messages
from learnblock.server.runs.console import Voice
from learnblock.server.runs.page_speaker import PageSpeaker


class Listener(Protocol):
    """Hears of a run in the event loop; only `held_keys` is called from the run's thread."""

    @property
    def voice(self) -> Voice:
        """What takes the output of the program."""

    def on_state(self, state: State) -> None: ...

    def on_held(self, line: int) -> None: ...

    def on_variables(self, variables: Variables) -> None: ...

    def on_input(self, prompt: str) -> None: ...

    def on_keys_wanted(self) -> None: ...

    def on_sound(self, sound: messages.Sound) -> None: ...

    def held_keys(self) -> Collection[str]: ...

    def on_done(self, report: Report) -> None:
        """The program has ended, while those of other robots go on."""

    def on_ended(self, report: Report | Exception) -> None:
        """The run has ended, or something was raised instead."""


class RunWatcher(Watcher):
    """Watches one run.

    Args:
        listener: receives the events, in the event loop that is running now.
        keys: the keys that are pressed during the run, instead of those of the pages.
    """

    def __init__(self, listener: Listener, keys: RecordedKeys | None = None) -> None:
        self._listener = listener
        self._keys = keys
        self._loop = asyncio.get_running_loop()
        #: The line of the program's Python that is running; 0 before the first.
        self.current_line = 0
        self._wants_keys = False
        self._speaker = PageSpeaker(self._sound)
        self._input = threading.Condition()
        self._answer: str | None = None
        self._cancelled = False
        #: Whether the run was given up: its events are no longer passed on.
        self._is_detached = False

    # The run's thread.

    def printed(self, text: str) -> None:
        if not self._is_detached:
            self._listener.voice.printed(text)

    def line(self, number: int) -> None:
        self.current_line = number

    def called(self, skill: str, args: Sequence[Any], kwargs: Mapping[str, Any]) -> None:
        self._speaker.called(skill, args, kwargs)

    def missing(self, skill: str, device: str) -> None:
        self._speaker.missing(skill, device)

    def state(self, state: State) -> None:
        self._pass_on(self._listener.on_state, state)

    def held(self, line: int, variables: Variables) -> None:
        # The variables first: so that the page has them when it shows the pause.
        self._pass_on(self._listener.on_variables, variables)
        self._pass_on(self._listener.on_held, line)

    def variables(self, variables: Variables) -> None:
        self._pass_on(self._listener.on_variables, variables)

    def input(self, prompt: str) -> str | None:
        with self._input:
            self._answer = None
            self._pass_on(self._listener.on_input, prompt)
            self._input.wait_for(lambda: self._answer is not None or self._cancelled)
            return self._answer

    def cancel_input(self) -> None:
        with self._input:
            self._cancelled = True
            self._input.notify_all()

    def held_keys(self, time: float) -> Collection[str]:
        if self._is_detached:
            return ()
        if self._keys:
            return self._keys.held(time)
        if not self._wants_keys:
            self._wants_keys = True
            self._pass_on(self._listener.on_keys_wanted)
        return self._listener.held_keys()

    def _sound(self, sound: messages.Sound) -> None:
        self._pass_on(self._listener.on_sound, sound)

    def ended(self, report: Report | Exception) -> None:
        """Report the end of the run."""
        self._pass_on(self._listener.on_ended, report)

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
