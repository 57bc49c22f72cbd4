"""Ctrl-C and SIGTERM, which end a command in order instead of in the middle of something."""

import signal
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from functools import partial
from queue import Empty, SimpleQueue
from types import FrameType

from learnblock.cli.console import say

#: Seconds after which a signal is noticed that came in the instant before a wait began: Python
#: calls its handler only once the wait is over.
_LOOK_AGAIN = 0.5


@contextmanager
def stopped_by_signals(end: Callable[[], object]) -> Iterator[None]:
    """Let Ctrl-C and SIGTERM end a run, which still leads to a report."""

    def stop(number: int, frame: FrameType | None) -> None:  # noqa: ARG001
        end()

    before = {number: signal.signal(number, stop) for number in (signal.SIGINT, signal.SIGTERM)}
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


@contextmanager
def served_until_ctrl_c() -> Iterator[None]:
    """Say how to stop and wait for it at the end of the block; being asked earlier counts, too.

    Python drops a KeyboardInterrupt that is raised in a callback of its own, such as one of the
    import system, so a command that only waited for that exception could miss a Ctrl-C.

    Raises:
        KeyboardInterrupt: always, at the end of the block.
    """
    # Its `put` may be called by a signal's handler at any moment; that of an Event may not.
    requests: SimpleQueue[None] = SimpleQueue()
    with stopped_by_signals(partial(requests.put, None)):
        yield
        say("cli-stop-with-ctrl-c")
        _await(requests)
    raise KeyboardInterrupt


def _await(requests: SimpleQueue[None]) -> None:
    while True:
        with suppress(Empty):
            return requests.get(timeout=_LOOK_AGAIN)
