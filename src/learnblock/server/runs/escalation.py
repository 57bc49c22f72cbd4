"""Ending something from the event loop; see `learnblock.runtime.escalation`.

It is a module of its own, because `learnblock run` has no event loop and starts without asyncio.
"""

import asyncio
from collections.abc import Iterable
from contextlib import suppress

from learnblock.runtime.escalation import Measure


async def escalate_async(measures: Iterable[Measure], ended: asyncio.Event) -> bool:
    """Take measures until an event has happened; return whether it has.

    Args:
        measures: the measures, the weakest first.
        ended: set at the end.
    """
    for measure in measures:
        measure.take()
        if await happens(ended, measure.seconds):
            return True
    return False


async def happens(event: asyncio.Event, seconds: float) -> bool:
    """Wait at most this many seconds for an event; return whether it has happened."""
    with suppress(TimeoutError):
        async with asyncio.timeout(seconds):
            await event.wait()
    return event.is_set()
