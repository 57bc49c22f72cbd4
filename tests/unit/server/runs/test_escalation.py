"""The event loop ends something by stronger and stronger measures."""

import asyncio

from learnblock.runtime.escalation import EndTimeouts
from learnblock.server.runs.escalation import escalate_async


def test_the_event_loop_escalates_in_the_same_way():
    async def end(kills):
        ended, taken = asyncio.Event(), []
        kill = ended.set if kills else bool
        measures = EndTimeouts(0.01, 0.01).measures(
            lambda: taken.append("stop"), lambda: (taken.append("kill"), kill())
        )
        return await escalate_async(measures, ended), taken

    assert asyncio.run(end(kills=True)) == (True, ["stop", "kill"])
    assert asyncio.run(end(kills=False)) == (False, ["stop", "kill"])
