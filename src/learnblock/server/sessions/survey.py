"""What contains programs on this computer, for every page."""

import asyncio

from anyio import to_thread

from learnblock.runtime.containment.survey import Finding, survey


class Survey:
    """What contains programs on this computer, tried out for the first page that asks."""

    def __init__(self) -> None:
        self._findings: tuple[Finding, ...] = ()
        self._trying = asyncio.Lock()

    async def findings(self) -> tuple[Finding, ...]:
        """What contains programs, and what does not."""
        async with self._trying:
            self._findings = self._findings or await to_thread.run_sync(survey)
        return self._findings
