"""The warm process of a batch: it has loaded what runs need, and forks a child for each run.

It runs no program itself and has a single thread, so that forking is safe.
"""

import gc
import math
import os
import select
import signal
import socket
import struct
import sys
from collections import deque
from collections.abc import Iterator, Sequence
from contextlib import ExitStack
from functools import lru_cache
from importlib import import_module
from pkgutil import iter_modules
from time import monotonic
from types import FrameType

from learnblock import robots, skills
from learnblock.installation import version
from learnblock.robots import RobotEntry
from learnblock.running.job import Job, Options, unpacked
from learnblock.running.library_state import LibraryState
from learnblock.running.making import lost
from learnblock.running.plain import dead_ends, is_plain
from learnblock.running.result import packed
from learnblock.running.run_child import RunChild, forked
from learnblock.runtime.containment import kernel
from learnblock.runtime.escalation import PATIENCE
from learnblock.runtime.fork_server import ForkServer
from learnblock.storage import skill_files

#: Before each result: the index of its job, whether its program was isolated, and its length.
HEAD = struct.Struct(">I?I")
#: New objects after which Python looks for garbage; by default 700.
_UNCOLLECTED = 20_000
#: The most worlds with their pictures that are kept for children, of some 15 MB each.
_PREPARED = 4
#: Seconds between two looks at whether runs that were stopped have ended.
_LOOK = 0.5
#: What runs on simulated robots load when they need it, in addition to our skills.
_PRELOADED = (
    "email.parser",
    "learnblock.client.extra_camera",
    "learnblock.closing",
    "learnblock.perception.detectors.lines",
    "learnblock.perception.detectors.tags",
    "learnblock.perception.settings",
    "learnblock.perception.sources.asking",
    "learnblock.perception.tag_names",
    "learnblock.runtime.containment.landlock",
    "learnblock.runtime.containment.paths",
    "learnblock.runtime.containment.seccomp",
    "learnblock.simulator.camera",
    "learnblock.simulator.polyline",
    "learnblock.simulator.scenery",
    "learnblock.simulator.templates",
    "platformdirs.unix",
)


# Why: docs/decisions.md, "A batch forks a warm process"
def main() -> None:
    """Run as ``python -m learnblock.running.warm FD``: FD is our end of the connection."""
    kernel.die_with_parent(signal.SIGKILL)
    connection = socket.socket(fileno=int(sys.argv[1]))
    for module in (*_PRELOADED, *_skill_modules()):
        import_module(module)
    # Read from the installed packages, which a child would search again.
    robots.entries()
    skill_files.plugins()
    version()
    # Imported here because the server and the command line import this module, too.
    import cv2  # noqa: PLC0415

    # One processor for each run.
    cv2.setNumThreads(1)
    # A run leaves little that has to be collected.
    gc.set_threshold(_UNCOLLECTED)
    programs, is_frozen = ForkServer(), False
    idle: list[RunChild] = []
    with ExitStack() as ending:
        stream = ending.enter_context(connection.makefile("rb"))
        # They would end with us, but nobody could say what they have used.
        ending.callback(lambda: [child.end() for child in idle])
        while length := stream.read(8):
            jobs, at_once = unpacked(stream.read(int.from_bytes(length)))
            for job in jobs:
                _load(job.robot, job.options.world)
            _state()
            if not is_frozen:
                # A child that collected what we have loaded would copy all of it.
                gc.freeze()
                is_frozen = True
            runs = _Warm(connection, jobs, at_once, programs, idle)
            try:
                runs.run()
            except (BrokenPipeError, ConnectionResetError):
                # The caller has gone. Our children end with us.
                return
            if runs.is_stopped:
                return


@lru_cache(maxsize=_PREPARED)
def _load(robot: RobotEntry, world: str | None) -> object:
    """Read and draw what each child would read and draw again, since it can't keep it."""
    kind = robot.load()
    kind.known_equipment()
    # Our caller has made such a world, too: it is possible.
    return kind.prepared(Options(world=world).wishes)


def _state() -> LibraryState:
    """What further runs in a child's process must find unchanged."""
    return _state_with(len(sys.modules))


@lru_cache(maxsize=1)
def _state_with(modules: int) -> LibraryState:  # noqa: ARG001 - it is made again with new modules
    return LibraryState()


def _skill_modules() -> Iterator[str]:
    """Our skills; those of the user's folder are loaded where they are contained."""
    return (module.name for module in iter_modules(skills.__path__, f"{skills.__name__}."))


def is_shared(job: Job) -> bool:
    """Whether the program shares a process with its robot."""
    # The network is for programs that import something, which have a process of their own.
    if job.options.network or job.isolated or not is_plain(job.program):
        return False
    # Only a host in another process can end it: see `making`.
    return not dead_ends(job.program)


class _Warm:
    """The runs of a batch.

    Args:
        connection: where results are sent.
        jobs: the runs.
        at_once: how many are made at the same time.
        programs: forks the processes of isolated programs.
        idle: the children that wait for further runs of their programs, before and after it.
    """

    def __init__(
        self,
        connection: socket.socket,
        jobs: Sequence[Job],
        at_once: int,
        programs: ForkServer,
        idle: list[RunChild],
    ) -> None:
        self._connection = connection
        self._programs = programs
        self._idle = idle
        self._jobs = jobs
        self._at_once = at_once
        #: The runs to be made: the index of each job, and whether its program is isolated.
        self._waiting = deque((number, not is_shared(job)) for number, job in enumerate(jobs))
        #: The runs that are being made, by the end of the pipe at which their results arrive.
        self._children: dict[int, RunChild] = {}
        #: The runs whose child died once: the index of each job, and whether it was isolated.
        self._died: set[tuple[int, bool]] = set()
        self.is_stopped = False
        #: When the runs are killed, once they have been asked to stop.
        self._deadline = math.inf
        signal.signal(signal.SIGTERM, self._stop)

    def run(self) -> None:
        """Make all runs."""
        while len(self._idle) > self._at_once:
            self._idle.pop(0).end()
        while self._waiting or self._children:
            while self._waiting and len(self._children) < self._at_once:
                self._start(*self._waiting.popleft())
            for handle in select.select([*self._children], [], [], _LOOK)[0]:
                self._receive(handle)
            if self._deadline < monotonic():
                for child in self._children.values():
                    os.kill(child.process, signal.SIGKILL)

    def _stop(self, number: int, frame: FrameType | None) -> None:  # noqa: ARG002
        self.is_stopped = True
        self._deadline = monotonic() + PATIENCE.stopped + PATIENCE.killed
        self._waiting.clear()
        self._at_once = 0
        for child in self._children.values():
            os.kill(child.process, signal.SIGTERM)

    def _start(self, number: int, isolated: bool) -> None:  # noqa: FBT001 - as it is kept
        job = self._jobs[number]
        child = None if isolated else self._repeating(job, number)
        if child is None:
            child = self._forked(job, number, isolated)
        self._children[child.results] = child

    def _repeating(self, job: Job, number: int) -> RunChild | None:
        """A child that has run the same program, and now makes this run."""
        child = next((child for child in self._idle if child.order(job, number)), None)
        if child:
            self._idle.remove(child)
        return child

    def _forked(self, job: Job, number: int, isolated: bool) -> RunChild:  # noqa: FBT001 - as above
        def leave() -> None:
            # Neither the results of others nor what is sent to our caller are its business.
            for child in (*self._children.values(), *self._idle):
                os.close(child.results)
                os.close(child.orders)
            os.close(self._connection.fileno())
            if not isolated:
                self._programs.let_go()

        if isolated:
            self._programs.begin()
        else:
            while self._idle and len(self._idle) + len(self._children) >= self._at_once:
                self._idle.pop(0).end()
        return forked(job, number, self._programs if isolated else _state(), leave)

    def _receive(self, handle: int) -> None:
        child = self._children[handle]
        if not child.receive():
            return
        del self._children[handle]
        if child.goes_on and child.result is not None:
            self._idle.append(child)
            self._send(child, child.result)
        else:
            self._finish(child)

    def _finish(self, child: RunChild) -> None:
        status = child.end()
        if child.result is not None:
            self._send(child, child.result)
        elif not self._at_once:
            return
        elif child.is_too_large and child.isolated:
            self._send(child, b"")
        elif self._deserves_another(child, status):
            self._waiting.appendleft((child.number, child.isolated))
        elif not child.isolated:
            # It did not let its host run, or took too much: see how it ends in its own process.
            self._waiting.appendleft((child.number, True))
        else:
            self._send(child, packed(lost(child.cause(status))))

    def _deserves_another(self, child: RunChild, status: int) -> bool:
        """Whether a run is made again as it was, because its program may not be to blame."""
        run = (child.number, child.isolated)
        if run in self._died or child.is_too_large:
            return False
        self._died.add(run)
        # In a process of its own, a program can't end that of its host.
        return child.isolated or status == -signal.SIGKILL

    def _send(self, child: RunChild, result: bytes) -> None:
        head = HEAD.pack(child.number, child.isolated, len(result))
        self._connection.sendall(head + result)


if __name__ == "__main__":
    main()
