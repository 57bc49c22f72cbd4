"""Prints repeated faults: each once, and later how often it was repeated."""

import asyncio
import logging
import re
import sys
import time
from collections import OrderedDict
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass

#: Seconds until the same fault is printed again.
_PAUSE = 60.0
#: The most faults that are remembered; the oldest are forgotten.
_MOST = 100
#: What differs from one time to the next: addresses, ports, counts.
_DETAIL = re.compile(r"0x[0-9a-f]+|\d+")
_LONGEST_KEY = 200


@dataclass
class _Repeated:
    printed: float
    count: int = 0


class SaidOnce(logging.Filter):
    """Lets a record pass only if the same fault was not printed in the last minute.

    Any computer in the network can cause some faults, such as bytes that are not HTTP, again and
    again; they must not fill the terminal.

    Args:
        now: returns the time of a monotonic clock in seconds.
    """

    def __init__(self, now: Callable[[], float] = time.monotonic) -> None:
        super().__init__()
        self._now = now
        self._faults: OrderedDict[tuple[str, ...], _Repeated] = OrderedDict()

    def filter(self, record: logging.LogRecord) -> bool:
        """Whether to print a record; one that is printed again gets the number of omitted ones."""
        key = _key(record)
        now = self._now()
        fault = self._faults.pop(key, None)
        if fault and now - fault.printed < _PAUSE:
            fault.count += 1
            self._remember(key, fault)
            return False
        if fault and fault.count:
            record.msg = f"{record.getMessage()} ({fault.count} times more since)"
            record.args = ()
        self._remember(key, _Repeated(now))
        return True

    def _remember(self, key: tuple[str, ...], fault: _Repeated) -> None:
        self._faults[key] = fault
        if len(self._faults) > _MOST:
            self._faults.popitem(last=False)


def is_fault(record: logging.LogRecord) -> bool:
    """Whether a record reports a fault: a request cut off by the server's end is none."""
    error = record.exc_info and record.exc_info[1]
    return not isinstance(error, asyncio.CancelledError)


def _key(record: logging.LogRecord) -> tuple[str, ...]:
    """What two records of the same fault have in common."""
    error = record.exc_info and record.exc_info[1]
    first, *_ = record.getMessage().splitlines() or [""]
    return (
        record.name,
        _DETAIL.sub("#", first)[:_LONGEST_KEY],
        type(error).__name__ if error else "",
        _DETAIL.sub("#", str(error))[:_LONGEST_KEY] if error else "",
    )


@contextmanager
def faults_said_once() -> Iterator[None]:
    """Print what goes wrong in this process to its standard error, each fault once a minute."""
    handler = logging.StreamHandler(sys.stderr)
    handler.setLevel(logging.WARNING)
    handler.addFilter(is_fault)
    handler.addFilter(SaidOnce())
    root = logging.getLogger()
    root.addHandler(handler)
    try:
        yield
    finally:
        root.removeHandler(handler)
