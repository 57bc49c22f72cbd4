"""What the teacher's wall shows of a pupil, as the pupil's server and pages tell it."""

import time
from collections.abc import Callable
from dataclasses import dataclass

from msgspec.structs import asdict

from learnblock.classroom.messages import Plan, Seat, Writing
from learnblock.classroom.roster import Pupil
from learnblock.server import messages

#: Seconds without any action that count as a pause.
_PAUSE = 120.0
#: Times are told in steps of so many seconds: each step is a message about each pupil.
_GRAIN = 5
#: What a page sends by itself, which says nothing about its pupil.
_BY_ITSELF = frozenset(
    kind.__name__
    for kind in (
        messages.Complete, messages.Describe, messages.ReadRunsOn, messages.ReadTimeline,
        messages.ReadValues, messages.ReadQuestions, messages.ListProjects, messages.ListRuns,
        messages.ListLessons, messages.ListHistory, messages.KeepPicture, messages.ReadNetwork,
        messages.HoldKeys, messages.Open, messages.CloseProject,
    )
)  # fmt: skip


@dataclass(frozen=True)
class _Known:
    """What a page works on.

    Args:
        now: its last message.
        scene: the number of its world.
        world: its world, once it is known.
    """

    now: messages.AtSeat
    scene: int = 0
    world: messages.Scene | None = None


_NOTHING = _Known(messages.AtSeat(messages.Work()))


class Progress:
    """Follows one pupil.

    Args:
        now: returns the time of a monotonic clock in seconds.
    """

    def __init__(self, now: Callable[[], float] = time.monotonic) -> None:
        self._now = now
        self._scenes = 0
        self._pages: dict[object, _Known] = {}
        #: What the wall shows.
        self._shown = _NOTHING
        self._acted = self._succeeded = now()
        self._begun = False
        self._answered = now()
        #: When the last page was closed, and when the hand was raised; None if neither is so.
        self._left: float | None = None
        self._raised: float | None = None

    def acted(self, kind: str) -> None:
        """Record a message of the pupil's page."""
        if kind in _BY_ITSELF:
            return
        now = self._now()
        # A pupil who comes back after a pause was not stuck during it.
        if now - self._acted > _PAUSE:
            self._succeeded = now
        self._acted = now
        self._begun = True

    def raise_hand(self, *, on: bool) -> None:
        """Record that the pupil asks for help, or no longer does."""
        if not on:
            self._raised = None
        elif self._raised is None:
            self._raised = self._now()

    @property
    def has_raised_hand(self) -> bool:
        """Whether the pupil asks for help."""
        return self._raised is not None

    def are_here(self, *, on: bool) -> None:
        """Record whether the pupil has a page open."""
        if on:
            self._left = None
        elif self._left is None:
            self._left = self._now()

    def answered(self) -> None:
        """Record that the pupil's server answers."""
        self._answered = self._now()

    def see(self, page: object, now: messages.AtSeat) -> None:
        """Note what a page works on."""
        before = self._pages.get(page, _NOTHING)
        if now.successes > before.now.successes:
            self._succeeded = self._now()
        if now.scene:
            self._scenes += 1
            self._pages[page] = _Known(now, self._scenes, now.scene)
        else:
            self._pages[page] = _Known(now, before.scene, before.world)

    def look_at(self, page: object) -> None:
        """Show what a page works on; what was shown stays until it says so."""
        self._shown = self._pages.get(page, self._shown)

    def forget(self, page: object) -> None:
        """A page has gone."""
        self._pages.pop(page, None)

    def work_of(self, page: object) -> messages.Work:
        """What a page works on, as far as it has said."""
        return self._pages.get(page, _NOTHING).now.work

    @property
    def place(self) -> tuple[str, int]:
        """The lesson and the step that are shown."""
        work = self._shown.now.work
        return work.lesson_name, work.step

    @property
    def is_running(self) -> bool:
        """Whether the program that is shown runs, as far as its page has said."""
        return self._shown.now.work.state in {"starting", "running"}

    @property
    def lesson_name(self) -> str:
        """The name of the lesson that is shown; empty without one."""
        return self._shown.now.work.lesson_name

    def seat(self, pupil: Pupil, *, here: bool, question: str = "", writing: Writing) -> Seat:
        """What the wall shows.

        Args:
            pupil: the pupil.
            here: whether a page of the pupil is open.
            question: what the pupil needs help with.
            writing: whether the teacher may write.
        """
        now = self._now()
        return Seat(
            **asdict(self._shown.now.work),
            id=pupil.id,
            name=pupil.name,
            here=here,
            gone=_steps(now - (now if self._left is None else self._left)),
            silent=_steps(now - self._answered) if here else 0,
            begun=self._begun,
            hand=self.has_raised_hand,
            waits=_steps(now - (now if self._raised is None else self._raised)),
            question=question,
            scene=self._shown.scene,
            quiet=_steps(now - self._acted),
            stuck=_steps(self._acted - self._succeeded),
            writing=writing,
        )

    def plan_of(self, id: str) -> Plan | None:  # noqa: A002 - as in `Plan`
        """The world, once it is known."""
        world = self._shown.world
        return Plan(id, self._shown.scene, world) if world else None


def _steps(seconds: float) -> int:
    return max(0, int(seconds) // _GRAIN * _GRAIN)
