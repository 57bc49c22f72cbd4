"""What the teacher's wall shows of a pupil, taken from the messages that pass by."""

import re
import time
from collections.abc import Callable, Mapping
from typing import Any

import msgspec

from learnblock.classroom.messages import GoalState, Plan, Seat, Words, Writing
from learnblock.classroom.roster import Pupil
from learnblock.lessons.lesson import LessonText
from learnblock.server import messages
from learnblock.server.messages.base import StateName

#: A new point of the way, if it is further than this from the last one, in mm; and the most points.
_STEP, _MOST_POINTS = 15.0, 400
#: Seconds between two looks at where the robot is.
_PERIOD = 0.4
#: Seconds without any action that count as a pause.
_PAUSE = 120.0
#: Endings of a run that need no attention.
_FINE = frozenset({"finished", "stopped", "replaced", ""})
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


#: Our servers put the kind first.
_HEAD = re.compile(r'\{"kind":"(\w+)"')

# The parts that are read of the messages with these names.


class Opened(msgspec.Struct, frozen=True):
    """A project is shown."""

    name: str
    robot: str


class ProjectRenamed(msgspec.Struct, frozen=True):
    """The project has another name."""

    name: str


class Scene(msgspec.Struct, frozen=True):
    """Another world is shown, or another robot is in it."""

    world: dict[str, Any]
    lines: tuple[tuple[tuple[float, float], ...], ...]


class RobotNow(msgspec.Struct, frozen=True):
    """The place of a robot."""

    x: float
    y: float
    heading: float
    located: bool = True


class GoalNow(msgspec.Struct, frozen=True):
    """A goal of the world."""

    state: GoalState


class Telemetry(msgspec.Struct, frozen=True):
    """The robots are somewhere, ours first."""

    robots: tuple[RobotNow, ...]
    goals: tuple[GoalNow, ...] = ()


class RunState(msgspec.Struct, frozen=True):
    """The program is in another state."""

    state: StateName


class Ended(msgspec.Struct, frozen=True):
    """A run has ended."""

    ended: str
    message: Words | None = None
    goals: tuple[GoalNow, ...] = ()
    tried: bool = False
    others: bool = False


class Problem(msgspec.Struct, frozen=True):
    """A mistake in the program."""

    message: Words
    severity: str


class Document(msgspec.Struct, frozen=True):
    """The program has changed."""

    problems: tuple[Problem, ...] = ()


class LessonStep(msgspec.Struct, frozen=True):
    """A step of a lesson."""

    earned: int = 0


class LessonShown(msgspec.Struct, frozen=True):
    """A step of a lesson is shown; without a name there is no lesson."""

    name: str = ""
    title: LessonText = ""
    steps: tuple[LessonStep, ...] = ()
    step: int = 1


class LessonGoals(msgspec.Struct, frozen=True):
    """The checks of a step have been looked at."""

    earned: int = 0
    steps: tuple[LessonStep, ...] = ()


class Progress:
    """Follows one pupil.

    Args:
        now: returns the time of a monotonic clock in seconds.
    """

    def __init__(self, now: Callable[[], float] = time.monotonic) -> None:
        self._now = now
        self.scene = 0
        self.plan: Scene | None = None
        self.project = self.robot = ""
        self.pose: tuple[float, float, float] | None = None
        self.way: list[float] = []
        self.state: StateName = "idle"
        self.goals: tuple[GoalState, ...] = ()
        self.lesson: LessonText = ""
        self.step = self.steps = self.stars = 0
        self.error: Words | None = None
        self._ended_badly: Words | None = None
        self._acted = self._succeeded = now()
        self._looked = 0.0
        #: The newest telemetry, if it came too soon after the one before.
        self._unread = ""

    def acted(self, kind: str) -> None:
        """Record a message of the pupil's page."""
        if kind in _BY_ITSELF:
            return
        now = self._now()
        # A pupil who comes back after a pause was not stuck during it.
        if now - self._acted > _PAUSE:
            self._succeeded = now
        self._acted = now

    def see(self, text: str) -> None:
        """Read a message of the pupil's server, if it is about the pupil."""
        head = _HEAD.match(text)
        kind = head[1] if head else ""
        if kind == Telemetry.__name__ and self._now() < self._looked + _PERIOD:
            self._unread = text
            return
        self._read_rest()
        reader = _READERS.get(kind)
        if reader is not None:
            reader(self, text)

    def seat(self, pupil: Pupil, *, here: bool, hand: bool, writing: Writing) -> Seat:
        """What the wall shows.

        Args:
            pupil: the pupil.
            here: whether a page of the pupil is open.
            hand: whether the pupil asks for help.
            writing: whether the teacher may write.
        """
        self._read_rest()
        now = self._now()
        return Seat(
            id=pupil.id,
            name=pupil.name,
            here=here,
            hand=hand,
            project=self.project,
            robot=self.robot,
            scene=self.scene,
            pose=self.pose,
            way=tuple(self.way),
            state=self.state,
            goals=self.goals,
            lesson=self.lesson,
            step=self.step,
            steps=self.steps,
            stars=self.stars,
            error=self.error,
            quiet=int(now - self._acted),
            stuck=max(0, int(self._acted - self._succeeded)),
            writing=writing,
        )

    def plan_of(self, id: str) -> Plan | None:  # noqa: A002 - as in `Plan`
        """The world, once it is known."""
        if self.plan is None:
            return None
        return Plan(id, self.scene, self.plan.world, self.plan.lines)

    # What the messages say.

    def opened(self, message: Opened) -> None:
        """Another project is shown."""
        self.project, self.robot = message.name, message.robot
        self.way, self.goals, self._ended_badly = [], (), None

    def renamed(self, message: ProjectRenamed) -> None:
        """The project has another name."""
        self.project = message.name

    def shown(self, message: Scene) -> None:
        """Another world is shown, or another robot is in it."""
        self.plan = message
        self.scene += 1
        self.way = []

    def moved(self, message: Telemetry) -> None:
        """The robot is somewhere."""
        self._looked = self._now()
        self.goals = tuple(goal.state for goal in message.goals)
        if message.robots and message.robots[0].located:
            robot = message.robots[0]
            self.pose = (round(robot.x), round(robot.y), round(robot.heading))
            self._go(robot.x, robot.y)

    def ran(self, message: RunState) -> None:
        """The program is in another state."""
        if message.state == "starting":
            self.way, self._ended_badly = [], None
        self.state = message.state

    def ended(self, message: Ended) -> None:
        """A run has ended."""
        if message.others or message.tried:
            return
        self._ended_badly = None if message.ended in _FINE else message.message
        self.error = self._ended_badly
        if message.ended == "finished" and all(goal.state != "failed" for goal in message.goals):
            self._succeeded = self._now()

    def changed(self, message: Document) -> None:
        """The program has changed: its first mistake is what its pupil sees."""
        mistakes = (problem for problem in message.problems if problem.severity == "error")
        first = next(mistakes, None)
        self.error = first.message if first else self._ended_badly

    def taught(self, message: LessonShown) -> None:
        """A step of a lesson is shown, or no lesson."""
        if (self.lesson, self.step) != (message.title, message.step):
            self._succeeded = self._now()
        has = bool(message.name)
        self.lesson = message.title if has else ""
        self.step, self.steps = (message.step, len(message.steps)) if has else (0, 0)
        self.stars = sum(step.earned for step in message.steps)

    def judged(self, message: LessonGoals) -> None:
        """The checks of a step have been looked at."""
        if message.earned:
            self._succeeded = self._now()
        if message.steps:
            self.stars = sum(step.earned for step in message.steps)

    def _read_rest(self) -> None:
        if self._unread:
            text, self._unread = self._unread, ""
            _READERS[Telemetry.__name__](self, text)

    def _go(self, x: float, y: float) -> None:
        if len(self.way) >= 2:
            before = self.way[-2:]
            if (x - before[0]) ** 2 + (y - before[1]) ** 2 < _STEP**2:
                return
        self.way += [round(x), round(y)]
        del self.way[: -2 * _MOST_POINTS]


def _reader(kind: Any, read: Any) -> Callable[[Progress, str], None]:
    decoder: msgspec.json.Decoder[Any] = msgspec.json.Decoder(kind)
    return lambda progress, text: read(progress, decoder.decode(text))


_READERS: Mapping[str, Callable[[Progress, str], None]] = {
    kind.__name__: _reader(kind, read)
    for kind, read in {
        Opened: Progress.opened,
        ProjectRenamed: Progress.renamed,
        Scene: Progress.shown,
        Telemetry: Progress.moved,
        RunState: Progress.ran,
        Ended: Progress.ended,
        Document: Progress.changed,
        LessonShown: Progress.taught,
        LessonGoals: Progress.judged,
    }.items()
}
