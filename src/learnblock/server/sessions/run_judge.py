"""Judges the run of a program by the checks of a lesson's step, during the run and at its end."""

import asyncio
import dataclasses
from collections.abc import Awaitable
from contextlib import suppress
from dataclasses import dataclass
from typing import Any, Protocol

from anyio import to_thread

from learnblock.errors import LearnBlockError
from learnblock.evidence.evidence import Evidence, evidence_so_far
from learnblock.evidence.trace_lines import TraceLines
from learnblock.language.tree.nodes import Program as Tree
from learnblock.lessons.checks import Expert
from learnblock.lessons.expert import Experts, NoVerdictError
from learnblock.lessons.finding import Finding
from learnblock.lessons.judging import Verdict, judge
from learnblock.lessons.opened import OpenLesson
from learnblock.server.sessions.parts import Parts

#: Seconds between two looks at a running program; at least this many times the length of a look.
PERIOD, REST = 0.3, 4.0


@dataclass(frozen=True)
class Looked:
    """What has been seen of a run.

    Args:
        tree: the program.
        verdicts: the results of the checks.
        evidence: what the program did; None before its first run.
    """

    tree: Tree
    verdicts: tuple[Verdict, ...]
    evidence: Evidence | None = None


class Tell(Protocol):
    """Reports what has been seen of a run."""

    def __call__(self, looked: Looked, *, live: bool) -> Awaitable[None]:
        """Report it; `live` means that the run is in progress."""


class RunJudge:
    """Judges one run several times a second until it has ended, and then once more.

    It begins when it is made, and its methods run in the event loop.

    Args:
        opened: the lesson.
        step: the number of the step.
        parts: the programs with their robots, the pupil's first.
        experts: runs the checks that are written in Python.
        tell: called with what has changed, and at the end.
    """

    def __init__(
        self,
        opened: OpenLesson,
        step: int,
        parts: Parts,
        experts: Experts,
        tell: Tell,
    ) -> None:
        self._opened = opened
        self._step = step
        self._parts = parts
        self._experts = experts
        self._tell = tell
        self._tree = parts.first.document.good.tree
        #: The lines of the run's trace so far; its recorder adds to them in another thread.
        self.lines = TraceLines()
        self._over = asyncio.Event()
        self._is_forgotten = False
        self._task = asyncio.create_task(self._follow())

    def ended(self) -> None:
        """Judge the run once more: all its programs have ended."""
        self._over.set()

    def forget(self) -> None:
        """Stop reporting the run."""
        self._is_forgotten = True
        self._over.set()

    async def wait(self) -> None:
        """Wait until the run has been judged at its end."""
        await self._task

    async def _follow(self) -> None:
        loop, took = asyncio.get_running_loop(), 0.0
        reported, is_over = None, False
        while not is_over:
            with suppress(TimeoutError):
                async with asyncio.timeout(max(PERIOD, REST * took)):
                    await self._over.wait()
            # A run that ends while it is judged is judged once more.
            is_over = self._over.is_set()
            began = loop.time()
            judgement = await to_thread.run_sync(self._judged)
            took = loop.time() - began
            if self._is_forgotten:
                return
            if is_over or judgement.verdicts != reported:
                reported = judgement.verdicts
                await self._tell(judgement, live=not is_over)

    def _judged(self) -> Looked:
        """Judge what has happened so far; this is slow for long runs."""
        robots = [(part, player) for part in self._parts for player in part.players]
        several = len(robots) > 1
        players = {part.name_of(player) if several else "": player for part, player in robots}
        reports = {name: player.report for name, player in players.items() if player.report}
        own = next(iter(players))
        report = reports.get(own)
        collisions = {name: player.collisions for name, player in players.items()}
        evidence = evidence_so_far(self.lines, 0.0, report, collisions, own)
        now = report.time if report else _last_time(evidence)
        evidence = dataclasses.replace(evidence, now=now, team=reports)
        step, world = self._opened.step(self._step), world_of(self._opened, self._step)
        return Looked(self._tree, judge(step, self._tree, evidence, world, self._found), evidence)

    def _found(self, check: Expert, evidence: Evidence) -> Finding:
        """What the lesson's Python finds; on a computer that is too busy, the check stays open."""
        try:
            return self._experts(check, evidence)
        except NoVerdictError as error:
            return Finding("open", reason=error.phrase)


def world_of(opened: OpenLesson, step: int) -> Any:
    """The description of a step's world, for checks and hints; None if none can be used.

    The server does not know the simulator, so it does not know the type.
    """
    try:
        return opened.described_world(step)
    except LearnBlockError:
        # It has been reported when the step was shown.
        return None


def _last_time(evidence: Evidence) -> float:
    """When the last thing happened that is known of a run."""
    lines = (line for line in reversed(evidence.lines) if "collision" not in line)
    times = (line["t"] for line in lines if "t" in line)
    return float(next(times, 0.0))
