"""One's own run of a plain program: host and program share a contained process.

It is forked from this process, and tells what the program prints as soon as it prints it.
"""

import os
import re
import select
import signal
import socket
import threading
from collections.abc import Iterator
from contextlib import suppress
from time import clock_gettime, monotonic
from typing import NoReturn

import msgspec

from learnblock.running import making, warm
from learnblock.running.batch import CAN_FORK, checked_result
from learnblock.running.job import Job
from learnblock.running.program_run import ProgramRun, Standing
from learnblock.running.report import Report
from learnblock.running.result import RunResult, packed
from learnblock.running.run_child import LARGEST
from learnblock.runtime.ending import How
from learnblock.runtime.escalation import PATIENCE
from learnblock.runtime.watcher import Watcher

#: Seconds between two messages on where the robot is, and between two turns of the watcher.
PERIOD = 0.1
#: A child hangs if it says nothing for so many seconds, and computes for less than so many.
HANGING = 15.0
_IDLE = 0.5
#: The bytes before a message that say how long it is.
_LENGTH = 8
_CHUNK = 1 << 16
#: A call of Python's `input`, or what looks like one: it needs an answer in the middle of a run.
_ASKS = re.compile(r"\binput\s*\(")


class ShownText(msgspec.Struct, tag=True, frozen=True):
    """The program has printed something."""

    text: str


class MadeRun(msgspec.Struct, tag=True, frozen=True):
    """The run has ended; `result` is packed."""

    result: bytes


class WhereNow(msgspec.Struct, tag=True, frozen=True):
    """The robot's state by now."""

    standing: Standing


_Message = ShownText | MadeRun | WhereNow
_decode = msgspec.msgpack.Decoder(_Message).decode


def can_share(job: Job) -> bool:
    """Whether host and program of a run may share a process, and nothing has to be answered."""
    is_simulated = job.robot.load().lockstep
    asks = _ASKS.search(job.program.python) is not None
    return CAN_FORK and is_simulated and not asks and warm.is_shared(job)


# Why: docs/decisions.md, "learnblock run needs one process for a plain program"
class SharedRun:
    """A run in a contained child of this process.

    Args:
        job: the run, which `can_share`.
        watcher: gets what the program prints, and a turn every now and then.
    """

    def __init__(self, job: Job, watcher: Watcher) -> None:
        self.job = job
        #: Where the robot is by now; None before that is known.
        self.standing: Standing | None = None
        #: How much of what the program prints the watcher has got.
        self.shown = 0
        self._watcher = watcher
        self._child = 0
        self._deadline: float | None = None

    def run(self) -> RunResult | None:
        """Make the run; None if that isn't possible, and the program needs its own process."""
        if threading.active_count() > 1:
            # Another thread may hold a lock, which would stay locked in the child.
            return None
        ours, theirs = socket.socketpair()
        child = os.fork()
        if child == 0:
            self._be_child(theirs)
        self._child = child
        if self._deadline:
            os.kill(child, signal.SIGTERM)
        theirs.close()
        with ours:
            result = self._received(ours)
        # Its end of the connection is closed, or what it sends can't be true.
        os.kill(child, signal.SIGKILL)
        os.waitpid(child, 0)
        if result is None and self._deadline:
            return RunResult(Report(ended=How.STOPPED))
        return result

    def stop(self) -> None:
        """End the run within a second or two; a signal's handler may call it."""
        self._deadline = monotonic() + PATIENCE.stopped + PATIENCE.killed
        # In the child there is none: it looks at the deadline before it begins.
        if self._child:
            os.kill(self._child, signal.SIGTERM)

    def _received(self, connection: socket.socket) -> RunResult | None:
        """Pass on what the child says, and return its result."""
        data, pulse = bytearray(), _Pulse(self._child)
        while self._deadline is None or monotonic() < self._deadline:
            if not select.select([connection], [], [], PERIOD)[0]:
                if pulse.note_silence():
                    return None
            else:
                pulse.note_message()
                received = connection.recv(_CHUNK)
                data += received
                if not received or len(data) > LARGEST:
                    return None
                for message in _taken(data):
                    if isinstance(message, MadeRun):
                        return checked_result(message.result, isolated=False)
                    self._accept(message)
            self._watcher.tick()
        return None

    def _accept(self, message: ShownText | WhereNow | None) -> None:
        if isinstance(message, ShownText):
            self.shown += len(message.text)
            self._watcher.printed(message.text)
        elif message is not None:
            self.standing = message.standing

    def _be_child(self, connection: socket.socket) -> NoReturn:
        """Make the run in this process, send its result, and end."""
        status = 1
        try:
            _keep_only(connection.fileno())
            teller = _Teller(self.job, connection)
            result = making.made_together(
                self.job, teller, lambda made: self._prepare(made, teller)
            )
            teller.tell(MadeRun(packed(result)))
            status = 0
        finally:
            # The child must not clean up for its parent, nor say why it failed: it is run again.
            os._exit(status)

    def _prepare(self, run: ProgramRun, teller: "_Teller") -> None:
        # Ctrl-C in a terminal reaches this process, too: our parent decides how the run ends.
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        signal.signal(signal.SIGTERM, lambda *_: run.stop())
        if self._deadline:
            run.stop()
        teller.run = run


class _Pulse:
    """Whether a child still says or computes something.

    A fork copies the locks that other threads hold, and the child may wait for one of them forever.

    Args:
        process: the number of the child.
    """

    def __init__(self, process: int) -> None:
        # The clock of a process, as clock_getcpuclockid(3) makes it on Linux.
        self._clock = ~process << 3 | 2
        self._silent = self._computed = 0.0

    def note_message(self) -> None:
        """Note that it has said something."""
        self._silent, self._computed = 0.0, clock_gettime(self._clock)

    def note_silence(self) -> bool:
        """Note that it has said nothing for a `PERIOD`; return whether it hangs.

        Periods are counted, because time also passes while this process is paused.
        """
        self._silent += PERIOD
        if self._silent < HANGING:
            return False
        before = self._computed
        self.note_message()
        return self._computed - before < _IDLE


class _Teller(making.Prints):
    """Tells the parent what the program prints, and where its robot is.

    Args:
        job: the run.
        connection: to the parent.
    """

    def __init__(self, job: Job, connection: socket.socket) -> None:
        super().__init__(job.keys)
        #: The run, once it begins.
        self.run: ProgramRun | None = None
        self._connection = connection
        self._due = 0.0

    def tell(self, message: ShownText | MadeRun | WhereNow) -> None:
        """Send a message."""
        data = msgspec.msgpack.encode(message)
        self._connection.sendall(len(data).to_bytes(_LENGTH) + data)

    def printed(self, text: str) -> None:
        self.tell(ShownText(text))

    def tick(self) -> None:
        if self.run and monotonic() >= self._due and (standing := self.run.standing):
            self._due = monotonic() + PERIOD
            self.tell(WhereNow(standing))


def _taken(data: bytearray) -> Iterator[_Message | None]:
    """The messages that have arrived as a whole; None for what is none."""
    while len(data) >= _LENGTH:
        end = _LENGTH + int.from_bytes(data[:_LENGTH])
        if len(data) < end:
            return
        message = None
        with suppress(msgspec.MsgspecError):
            message = _decode(data[_LENGTH:end])
        del data[:end]
        yield message


def _keep_only(handle: int) -> None:
    """Close all files but one: a program that got out could use them."""
    nowhere = os.open(os.devnull, os.O_RDWR)
    for standard in (0, 1, 2):
        os.dup2(nowhere, standard)
    os.closerange(3, handle)
    os.closerange(handle + 1, os.sysconf("SC_OPEN_MAX"))
