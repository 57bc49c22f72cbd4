"""The last run of a project as a link proves it, and its comparison with the run of a link."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Protocol

from learnblock.i18n import Phrase
from learnblock.installation import version
from learnblock.project.files.project import Project
from learnblock.project.files.share_link import ProvedRun
from learnblock.project.files.shared_record import ProgramState, SharedRecord
from learnblock.running.job import Job
from learnblock.runtime.ending import How
from learnblock.runtime.program import KEY_SKILL
from learnblock.server import messages

#: Endings that come at no exact moment of the robot's time.
_INEXACT = frozenset({How.KILLED, How.NO_CALL, How.STOPPED})


class ProvedProject(Protocol):
    """An open project, as far as its runs are proved."""

    @property
    def project(self) -> Project:
        """The project in the form that is saved."""

    @property
    def variant(self) -> int:
        """The number of the world's variant."""


@dataclass(frozen=True)
class _Begun:
    """A run that has begun.

    Args:
        state: what is run.
        placed: whether the user has placed a robot.
        asks: whether the programs ask a person for keys or answers, or one is a guest's.
    """

    state: ProgramState
    placed: bool
    asks: bool


class RunProof:
    """Knows the last run of a project, and the one in the link that it was opened from.

    Args:
        project: the project.
    """

    def __init__(self, project: ProvedProject) -> None:
        self._project = project
        self._begun: _Begun | None = None
        self._ended: messages.Ended | None = None
        #: What the project's link holds; None if it was not opened from a link.
        self.record: SharedRecord | None = None

    @property
    def state(self) -> ProgramState:
        """What the next run would run."""
        return ProgramState.of(self._project.project, self._project.variant)

    def begin(self, jobs: Sequence[Job], *, has_guest: bool = False) -> None:
        """Remember what a run that is about to start runs; a guest's program is in no link."""
        self._ended = None
        self._begun = _Begun(
            self.state,
            placed=any(job.options.start is not None for job in jobs),
            asks=has_guest or any(_asks(job) for job in jobs),
        )

    def end(self, endings: Sequence[messages.Ended]) -> messages.RunCompared | None:
        """Remember how the run ended, and compare it with the one in the link, if there is one."""
        self._ended = _whole(endings)
        run = self.record.run if self.record else None
        if self._begun is None or self.record is None or run is None:
            return None
        same = self._ended.trace_sha256 == run.trace_sha256
        differences = () if same else tuple(self._differences(self._begun, self._ended, run))
        return messages.RunCompared(same, run.trace_sha256, differences)

    def last_run(self) -> ProvedRun | Phrase:
        """The last run, or why it proves nothing."""
        begun, ended = self._begun, self._ended
        if begun is None or ended is None:
            return Phrase("share-no-run")
        if begun.placed or begun.state != self.state:
            return Phrase("share-no-run-changed")
        if not ended.repeatable:
            return Phrase("share-no-run-real")
        if begun.asks:
            return Phrase("share-no-run-person")
        if ended.ended in _INEXACT or not ended.trace_sha256:
            return Phrase("share-no-run-stopped")
        seconds = round(ended.time, 3)
        return ProvedRun(seconds, How(ended.ended), version(), ended.trace_sha256)

    def _differences(
        self, begun: _Begun, ended: messages.Ended, run: ProvedRun
    ) -> Iterator[Phrase]:
        causes = list(self._causes(begun, ended, run))
        yield from causes
        ours = round(ended.time, 3)
        if ours != run.seconds:
            yield Phrase("share-differs-time", theirs=run.seconds, ours=ours)
        elif not causes:
            yield Phrase("share-differs-else")

    def _causes(self, begun: _Begun, ended: messages.Ended, run: ProvedRun) -> Iterator[Phrase]:
        shared = self.record.state if self.record else begun.state
        if begun.state.program != shared.program:
            yield Phrase("share-differs-program")
        if begun.state.robots != shared.robots:
            yield Phrase("share-differs-robot")
        if (begun.state.world, begun.state.variant) != (shared.world, shared.variant):
            yield Phrase("share-differs-world")
        if begun.placed:
            yield Phrase("share-differs-place")
        if run.version != version():
            yield Phrase("share-differs-version", theirs=run.version, ours=version())
        if ended.ended in _INEXACT:
            yield Phrase("share-differs-stopped")


def _asks(job: Job) -> bool:
    """Whether a program may ask for keys or an answer."""
    return KEY_SKILL in job.program.names or "input(" in job.program.python


def _whole(endings: Sequence[messages.Ended]) -> messages.Ended:
    """How a run of several programs ended: one that was stopped stands for all."""
    return next((ending for ending in endings if ending.ended in _INEXACT), endings[0])
