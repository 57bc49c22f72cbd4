"""The end of a server that hangs: everything is saved, then its process ends."""

import math
import os
import signal
import socket
import threading
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from queue import Empty, SimpleQueue
from types import FrameType

import uvicorn

from learnblock.i18n import Phrase

#: Seconds between two checks for another server that wants to take over.
_LOOK_FOR_OTHERS = 0.5


@dataclass(frozen=True, slots=True)
class Deadlines:
    """How long a server may take, in seconds.

    Args:
        ending: from the request to the end; then it saves everything and ends at once.
        saving: for saving everything.
    """

    ending: float = 15.0
    saving: float = 5.0


class LastResort:
    """Ends this process if it has not ended in time, or at a second request; saves first.

    Its thread begins with the server: at the end there may be no memory for one.

    Args:
        save: saves everything from this object's thread, whatever the event loop does; returns what
            could not be saved.
        announce: shows the user what happens.
        deadlines: how long the server may take.
        is_asked: whether another server asks this one to end, such as one that takes over.
        begin: begins the end of the server when another one asks for it.
        end: ends the process with a status.
    """

    def __init__(
        self,
        save: Callable[[], Iterable[Phrase]],
        announce: Callable[[Phrase], object],
        deadlines: Deadlines,
        *,
        is_asked: Callable[[], bool] = bool,
        begin: Callable[[], object] = bool,
        end: Callable[[int], object] = os._exit,
    ) -> None:
        self._save = save
        self._announce = announce
        self._deadlines = deadlines
        self._is_asked = is_asked
        self._begin = begin
        self._end = end
        #: A queue, because a signal may interrupt a thread that has the lock of an event.
        self._requests: SimpleQueue[None] = SimpleQueue()

    def start(self) -> None:
        """Wait for requests, in a thread."""
        threading.Thread(target=self._watch, name="last resort", daemon=True).start()

    def request(self) -> None:
        """Request the end; the second time, at once. A signal handler may call this."""
        self._requests.put(None)

    def _watch(self) -> None:
        while not self._requested(_LOOK_FOR_OTHERS):
            if self._is_asked():
                self._begin()
                break
        at_once = self._requested(self._deadlines.ending)
        try:
            _end_by_the_system(self._deadlines.saving)
            self._announce(Phrase("server-ends-at-once" if at_once else "server-ends-late"))
            for problem in self._save():
                self._announce(problem)
        finally:
            self._end(1)

    def _requested(self, seconds: float) -> bool:
        """Wait for a request; return whether one has arrived within this many seconds."""
        try:
            self._requests.get(timeout=seconds)
        except Empty:
            return False
        return True


def _end_by_the_system(seconds: float) -> None:
    """Have the system end this process if even saving hangs, as on a network drive."""
    if hasattr(signal, "alarm"):
        signal.alarm(math.ceil(seconds))


class EndingServer(uvicorn.Server):
    """A server whose process ends when it should, even if it hangs.

    Args:
        config: its configuration.
        last_resort: ends the process.
        announce_start: called when the server answers.
        announce_end: called when it begins to end.
    """

    def __init__(
        self,
        config: uvicorn.Config,
        last_resort: LastResort,
        announce_start: Callable[[], object],
        announce_end: Callable[[], object] = bool,
    ) -> None:
        super().__init__(config)
        self._last_resort = last_resort
        self._announce_start = announce_start
        self._announce_end = announce_end

    def run(self, sockets: list[socket.socket] | None = None) -> None:
        self._last_resort.start()
        super().run(sockets)

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        await super().startup(sockets)
        self._announce_start()

    async def shutdown(self, sockets: list[socket.socket] | None = None) -> None:
        self._announce_end()
        await super().shutdown(sockets)

    def handle_exit(self, sig: int, frame: FrameType | None) -> None:  # noqa: ARG002 - uvicorn's
        # Unlike uvicorn's, a second Ctrl-C does not leave out what saves the projects.
        self._captured_signals.append(sig)
        self.end()

    def end(self) -> None:
        """Begin to end; the second time, save and end at once. A signal handler may call this."""
        self.should_exit = True
        self._last_resort.request()
