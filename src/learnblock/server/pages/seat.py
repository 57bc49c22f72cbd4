"""What the class's wall shows of a page, taken from the messages that the page is sent."""

import asyncio
from collections.abc import Callable, Sequence
from typing import Any

import msgspec
from msgspec.structs import replace

from learnblock.i18n import Phrase, with_languages
from learnblock.server import messages
from learnblock.server.messages import MissedCheck, Words, Work

#: A new point of the way, if it is further than this from the last one, in mm; and the most points.
_STEP, _MOST_POINTS = 15.0, 400
#: Seconds between two messages.
_PERIOD = 0.5
#: Endings of a run that need no attention.
_FINE = frozenset({"finished", "stopped", "replaced", ""})


class PageSeat:
    """Follows a page.

    Args:
        send: sends it a message, which the class's server takes out.
    """

    def __init__(self, send: Callable[[messages.AtSeat], object]) -> None:
        self._send = send
        self._work = Work()
        self._successes = 0
        self._scene: messages.Scene | None = None
        self._ended_badly: Words | None = None
        self._changed = asyncio.Event()

    async def serve(self) -> None:
        """Send what has changed, until cancelled."""
        while True:
            await self._changed.wait()
            # A page that opens a project is sent many messages at once.
            await asyncio.sleep(_PERIOD)
            self._send(self.news())

    def news(self) -> messages.AtSeat:
        """The message about what the page works on."""
        self._changed.clear()
        scene, self._scene = self._scene, None
        return messages.AtSeat(self._work, self._successes, scene)

    def see(self, message: messages.ToPage) -> None:
        """Follow a message that the page is sent."""
        follow = _FOLLOWERS.get(type(message))
        if follow is not None:
            follow(self, message)
            self._changed.set()

    def _now(self, **values: Any) -> None:
        self._work = replace(self._work, **values)

    # What the messages say.

    def opened(self, message: messages.Opened) -> None:
        """Another project is shown."""
        self._ended_badly = None
        self._now(project=message.name, robot=message.robot, way=(), goals=())

    def renamed(self, message: messages.ProjectRenamed) -> None:
        """The project has another name."""
        self._now(project=message.name)

    def shown(self, message: messages.Scene) -> None:
        """Another world is shown, or another robot is in it."""
        self._scene = message
        self._now(way=())

    def moved(self, message: messages.Telemetry) -> None:
        """The robot is somewhere."""
        self._now(goals=tuple(goal.state for goal in message.goals))
        if message.robots and message.robots[0].located:
            robot = message.robots[0]
            pose = (round(robot.x), round(robot.y), round(robot.heading))
            self._now(pose=pose, way=_longer(self._work.way, robot.x, robot.y))

    def ran(self, message: messages.RunState) -> None:
        """The program is in another state."""
        if message.state == "starting":
            self._ended_badly = None
            self._now(way=())
        self._now(state=message.state)

    def ended(self, message: messages.Ended) -> None:
        """A run has ended."""
        if message.others or message.tried:
            return
        self._ended_badly = None if message.ended in _FINE else _words(message.message)
        self._now(error=self._ended_badly, tries=self._work.tries + 1)
        if message.ended == "finished" and all(goal.state != "failed" for goal in message.goals):
            self._successes += 1

    def edited(self, message: messages.Document) -> None:
        """The program has changed: its first mistake is what its pupil sees."""
        mistakes = (problem for problem in message.problems if problem.severity == "error")
        first = next(mistakes, None)
        self._now(error=_words(first.message) if first else self._ended_badly)

    def taught(self, message: messages.LessonShown) -> None:
        """A step of a lesson is shown, or no lesson."""
        if (self._work.lesson, self._work.step) != (message.title, message.step):
            self._successes += 1
            self._now(tries=0, missed=None)
        has = bool(message.name)
        self._now(
            lesson=message.title if has else "",
            lesson_name=message.name,
            step=message.step if has else 0,
            steps=len(message.steps) if has else 0,
        )
        self._reached(message.steps)

    def judged(self, message: messages.LessonGoals) -> None:
        """The checks of a step have been looked at."""
        if message.earned:
            self._successes += 1
        if message.steps:
            self._reached(message.steps)
        if not message.live:
            failed = (goal for goal in message.goals if goal.state == "failed")
            self._now(missed=_missed(next(failed, None)))

    def _reached(self, steps: Sequence[messages.LessonStep]) -> None:
        behind = self._work.step - 1
        self._now(
            stars=sum(step.earned for step in steps),
            all_stars=sum(step.stars for step in steps),
            done=tuple(
                step.earned > 0 or (i < behind and not step.stars) for i, step in enumerate(steps)
            ),
        )


def _words(phrase: Phrase | None) -> Words | None:
    words: Words | None = msgspec.to_builtins(phrase, enc_hook=with_languages)
    return words


def _missed(goal: messages.LessonGoal | None) -> MissedCheck | None:
    if goal is None:
        return None
    words = msgspec.to_builtins(goal.say, enc_hook=with_languages)
    return MissedCheck(words, _words(goal.reason))


def _longer(way: tuple[float, ...], x: float, y: float) -> tuple[float, ...]:
    if way and (x - way[-2]) ** 2 + (y - way[-1]) ** 2 < _STEP**2:
        return way
    longer = (*way, round(x), round(y))
    return longer if len(longer) <= 2 * _MOST_POINTS else _thinned(longer)


def _thinned(way: tuple[float, ...]) -> tuple[float, ...]:
    """Every second point, so that a long way is shown from its beginning."""
    points = list(zip(way[::2], way[1::2], strict=True))
    # The last one stays: the way goes on from there.
    return tuple(value for point in points[(len(points) - 1) % 2 :: 2] for value in point)


_FOLLOWERS: dict[type[messages.ToPage], Callable[[PageSeat, Any], None]] = {
    messages.Opened: PageSeat.opened,
    messages.ProjectRenamed: PageSeat.renamed,
    messages.Scene: PageSeat.shown,
    messages.Telemetry: PageSeat.moved,
    messages.RunState: PageSeat.ran,
    messages.Ended: PageSeat.ended,
    messages.Document: PageSeat.edited,
    messages.LessonShown: PageSeat.taught,
    messages.LessonGoals: PageSeat.judged,
}
