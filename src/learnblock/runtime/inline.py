"""Programs in the thread of their host: all take turns, and no message crosses a process."""

import sys
from collections.abc import Callable, Iterable
from threading import get_ident
from typing import Any, TypeVar

from greenlet import GreenletExit, getcurrent, greenlet

from learnblock.errors import ProgramStopped, RobotConnectionError
from learnblock.runtime import child
from learnblock.runtime.activity import Activity
from learnblock.runtime.containment.scratch import Usage
from learnblock.runtime.limits import Limits
from learnblock.runtime.link import LENGTH, NOT_ENCODABLE, AtOnce, Link, decoded_value
from learnblock.runtime.messages import (
    Answer,
    Ask,
    Called,
    Command,
    FromChild,
    FromHost,
    Message,
    Sleep,
    Steps,
)
from learnblock.runtime.values import is_small

Incoming = TypeVar("Incoming")

#: The size of a message that is queued without being encoded, for limits in bytes.
TYPICAL_SIZE = 16
#: Values of these types with fewer bytes than this are copied without a message around them.
_LISTED, _SHORT = frozenset({dict, list, tuple}), 1024


# Why: docs/decisions.md, "A program may take turns with its host in one thread"
class InlineWorker:
    """Runs a trusted program in this thread, whenever its host waits for a message.

    It can neither be limited nor killed, so a host that runs it has to be in a container of its
    own. Several programs of one host may run in its thread; each has its own time and random
    numbers.
    """

    def __init__(self) -> None:
        theirs = ProgramsEnd(self._let_host_run)
        ours: InlineLink[FromChild] = InlineLink(FromChild, self._let_program_run)
        theirs.other, ours.other = ours, theirs
        self.link: Link[FromChild] = ours
        self._host = getcurrent()
        self._program = greenlet(lambda: child.run(theirs))
        self._interrupted = False
        #: Grows while the program lets its host run, and while its host is at work.
        self.turns = 0

    def interrupt(self) -> None:
        self._interrupted = True

    def abort(self) -> None:
        """Do nothing: it has the thread of its host, which would have to be ended with it."""

    def kill(self) -> None:
        self.link.close()
        if not self._program.dead:
            self._program.throw(GreenletExit)

    def wait(self, timeout: float) -> int | None:  # noqa: ARG002 - it runs only while we wait
        return 0 if self._program.dead else None

    def usage(self, limits: Limits) -> Usage:  # noqa: ARG002 - it is the host's own
        # Asked during long waits, too: a host that simulates one is not silent.
        self.turns += 1
        return Usage()

    def activity(self) -> Activity | None:
        return None

    def _let_program_run(self) -> None:
        if not self._program.dead:
            self._program.switch()
        if self._program.dead:
            self.link.close()

    def _let_host_run(self) -> None:
        # The host runs no line of the program.
        tracer = sys.gettrace()
        sys.settrace(None)
        self.turns += 1
        self._host.switch()
        sys.settrace(tracer)
        if self._interrupted:
            self._interrupted = False
            raise ProgramStopped("stopped")


class InlineLink(Link[Incoming]):
    """One end of a conversation within a thread.

    What arrives is what would arrive over a socket: values are copied by encoding them, unless
    that changes nothing.

    Args:
        incoming: the union of the messages that may arrive.
        run_other: runs the other end until it waits for a message.
    """

    #: The other end, set before the first message.
    other: "InlineLink[Any]"

    def __init__(self, incoming: Any, run_other: Callable[[], None]) -> None:
        super().__init__(incoming)
        self.run_other = run_other
        self._queue: list[Any] = []
        self._queued = 0
        self._error: Exception | None = None
        self.is_open = True

    def put(self, message: Message) -> int:
        if stays_the_same(message):
            self._queued += TYPICAL_SIZE
        else:
            self._queued += super().put(message)
            message = self._taken()
        self._queue.append(message)
        return self._queued

    def copied(self, value: Any) -> Any:
        """A value as it would arrive at the other end."""
        if is_small(value):
            return value
        if type(value) in _LISTED and (copy := self._short_copy(value)) is not None:
            return copy
        super().put(Answer(value))
        return self._taken().value

    def _short_copy(self, value: Any) -> Any:
        """A copy in a third of the time of a message; None if the value has to be sent as one."""
        try:
            encoded = self._encoder.encode(value)
        except NOT_ENCODABLE:
            return None
        return decoded_value(encoded) if len(encoded) < _SHORT else None

    def _taken(self) -> Any:
        """The message that has just been encoded, as it arrives."""
        message = self.other.decode(self._outgoing[LENGTH:])
        self._outgoing.clear()
        return message

    def offer(self, at_once: AtOnce | None) -> None:
        self.other.at_once = at_once

    def give_turn(self) -> None:
        self.other.run_other()

    def fail(self, error: Exception) -> None:
        self.offer(None)
        self._error = error

    def flush(self) -> None:
        self._require_open()
        self.other.deliver(self._queue)
        self._queue.clear()
        self._queued = 0

    def deliver(self, messages: Iterable[Incoming]) -> None:
        """Accept messages from the other end."""
        self._messages.extend(messages)

    def receive(self, timeout: float | None = None) -> Incoming | None:
        while not self._messages or self._error:
            if self._error:
                error, self._error = self._error, None
                raise error
            self._require_open()
            self.run_other()
            if timeout is not None and not self._messages:
                return None
        return self._messages.popleft()

    def receive_now(self) -> Incoming | None:
        return self._messages.popleft() if self._messages else None

    def close(self) -> None:
        self.is_open = self.other.is_open = False

    def _require_open(self) -> None:
        if not self.is_open:
            raise EOFError("the other end of the link is gone")


class ProgramsEnd(InlineLink[FromHost]):
    """The program's end: what it sends is handled at once, so that its host can stop it."""

    def __init__(self, run_host: Callable[[], None]) -> None:
        super().__init__(FromHost, run_host)
        self._thread = get_ident()

    def put(self, message: Message) -> int:
        if get_ident() != self._thread:
            raise RobotConnectionError("run-inline-thread")
        return super().put(message)

    def flush(self) -> None:
        super().flush()
        self.run_other()


def stays_the_same(message: Message) -> bool:
    """Whether a message is surely equal after it has been encoded and decoded."""
    if isinstance(message, Called):
        return not message.kwargs and all(map(is_small, message.args))
    if isinstance(message, Ask | Command):
        return all(map(is_small, message.args))
    return isinstance(message, Steps | Sleep)
