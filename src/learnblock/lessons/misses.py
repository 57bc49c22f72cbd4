"""By how much, and where, a run missed what a check asks for.

The page, `lesson try`, `lesson check` and grading say the same.
"""

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import compress, pairwise
from typing import Any

from learnblock.i18n import Phrase
from learnblock.i18n.names import goal_phrase
from learnblock.lessons.checks import (
    At,
    Check,
    Collided,
    Drives,
    EndsAt,
    Event,
    GoalReached,
    Happens,
    InOrder,
    Never,
    Reaches,
    StaysOnLine,
    Stood,
    Turns,
)
from learnblock.lessons.evidence import Evidence, Moment, Placed, length_of
from learnblock.lessons.gaps import (
    XY,
    direction,
    gap_words,
    length_words,
    longest_stand,
    nearest_point,
    place_at,
    rounded_mm,
    rounded_seconds,
    turn_words,
    xy,
)
from learnblock.lessons.happening import heading_between, is_on_line, moments, turned_along
from learnblock.simulator import WorldDescription
from learnblock.simulator.geometry import Pose
from learnblock.simulator.goal_description import (
    AnyGoal,
    Avoid,
    Follow,
    Reach,
    Show,
    Stop,
    Tour,
    Visit,
)
from learnblock.simulator.goals import FollowGoal, RobotState

#: Degrees by which the way between the places of a tour turns at a corner.
_CORNER = 30


@dataclass(frozen=True, slots=True)
class Miss:
    """By how much a run missed something.

    Args:
        words: what was missed, and by how much.
        place: where it is, if it has a place.
        nearest: how near to it the robot came, or where it failed.
    """

    words: Phrase
    place: XY | None = None
    nearest: XY | None = None


def missed(check: Check, evidence: Evidence, world: WorldDescription | None) -> Miss | None:
    """By how much a run missed a check that it failed; None if its reason says all.

    Args:
        check: the check.
        evidence: what is known of the run.
        world: the world of the run.
    """
    run = _Run(evidence, world)
    if isinstance(check, Reaches):
        return _goals(run, check.goals or tuple(run.goals))
    if isinstance(check, Happens):
        return _event(check.what, run) if _is_missing(check, run) else None
    if isinstance(check, InOrder):
        return next((_event(event, run) for event in check.events if not run.has(event)), None)
    find = _CHECKS.get(type(check))
    return find(check, run) if find else None


@dataclass(frozen=True)
class _Run:
    evidence: Evidence
    world: WorldDescription | None

    @property
    def goals(self) -> Mapping[str, AnyGoal]:
        """The goals of the world, by name."""
        return {goal.name: goal for _, _, goal in self.world.goal.all()} if self.world else {}

    @property
    def path(self) -> Sequence[Placed]:
        return self.evidence.path

    def has(self, event: Event) -> bool:
        return bool(moments(event, self.evidence))

    def of(self, goal: AnyGoal) -> Iterable["_Run"]:
        """The same run, looked at for each robot that may reach a goal."""
        names = [goal.robot] if goal.robot else list(self.evidence.team)
        if len(names) <= 1 and not goal.robot:
            return (self,)
        return tuple(_Run(self.evidence.of(name), self.world) for name in names)


def _is_missing(check: Happens, run: _Run) -> bool:
    return len(moments(check.what, run.evidence)) < check.at_least


def _event(event: Event, run: _Run) -> Miss | None:
    """By how much an event was missed."""
    if isinstance(event, GoalReached):
        return _goals(run, (event.name,))
    if isinstance(event, At):
        return _at(event, run)
    return _stood(event, run) if isinstance(event, Stood) else None


# Goals.


def _goals(run: _Run, names: Sequence[str]) -> Miss | None:
    """By how much the first goal was missed that could have been reached."""
    known = run.goals
    missing = [known[name] for name in names if name in known and not _is_reached(name, run)]
    first = missing[0] if missing else None
    while first and first.after in known and not _is_reached(str(first.after), run):
        first = known[str(first.after)]
    return _goal(first, run) if first else None


def _is_reached(name: str, run: _Run) -> bool:
    return name in run.evidence.reached


def _goal(goal: AnyGoal, run: _Run) -> Miss | None:
    """The best miss of the robots that may reach a goal."""
    found = [miss for own in run.of(goal) if (miss := _GOALS[type(goal)](goal, own))]
    # All of several robots have to come: the last of them counts.
    choose = max if isinstance(goal, Reach) and goal.together else min
    return choose(found, key=_distance) if found else None


def _distance(miss: Miss) -> float:
    if miss.place is None or miss.nearest is None:
        return math.inf
    return math.dist(miss.place, miss.nearest)


def _reach(goal: Reach, run: _Run) -> Miss | None:
    place = (goal.x, goal.y)
    if goal.object is not None:
        words = Phrase("lesson-miss-object", thing=goal.object)
        return Miss(words, place)
    if not run.path:
        return None
    if goal.alone and math.dist(xy(run.path[-1]), place) <= goal.radius:
        words = Phrase("lesson-miss-not-alone", goal=goal_phrase(goal.name))
        return Miss(words, place, xy(run.path[-1]))
    if goal.together or goal.alone:
        return _near(goal, place, run, xy(run.path[-1]))
    return _near(goal, place, run, nearest_point(run.path, place))


def _near(goal: AnyGoal, place: XY, run: _Run, nearest: XY) -> Miss:
    gap = gap_words(xy(run.path[0]), nearest, place)
    return Miss(Phrase("lesson-miss-goal", goal=goal_phrase(goal.name), gap=gap), place, nearest)


def _tour(goal: Tour, run: _Run) -> Miss | None:
    if not run.path:
        return None
    count = len(goal.points)
    passed, left = _passed(goal, run)
    if passed >= count:
        return None
    place = goal.points[passed]
    before = goal.points[passed - 1] if passed else xy(run.path[0])
    nearest = nearest_point(left, place)
    gap = gap_words(before, nearest, place)
    code = "lesson-miss-corner" if _has_corners(goal.points) else "lesson-miss-place"
    return Miss(Phrase(code, number=passed + 1, count=count, gap=gap), place, nearest)


def _passed(goal: Tour, run: _Run) -> tuple[int, Sequence[Placed]]:
    """How many places of a tour were passed, and the way from the last of them on."""
    passed, left = 0, run.path
    for index, piece in enumerate(pairwise(run.path), 1):
        if passed == len(goal.points):
            break
        place = goal.points[passed]
        if math.dist(nearest_point(piece, place), place) <= goal.radius:
            passed, left = passed + 1, run.path[index:]
    return passed, left


def _has_corners(points: Sequence[XY]) -> bool:
    """Whether the way through places turns at each of them."""
    ways = [direction(before, after) for before, after in pairwise(points)]
    turns = [abs(heading_between(before, after)) for before, after in pairwise(ways)]
    return bool(turns) and min(turns) >= _CORNER


def _stop(goal: Stop, run: _Run) -> Miss | None:
    if not run.path:
        return None
    place, last = (goal.x, goal.y), run.path[-1]
    if math.dist(xy(last), place) > goal.radius:
        return _near(goal, place, run, xy(last))
    name = goal_phrase(goal.name)
    if goal.heading is not None:
        off = heading_between(goal.heading, last.heading)
        if abs(off) > goal.angle:
            return Miss(
                Phrase("lesson-miss-facing", goal=name, turn=turn_words(off)), place, xy(last)
            )
    longest, at = longest_stand(run.path, lambda pose: math.dist(pose, place) <= goal.radius)
    words = Phrase(
        "lesson-miss-goal-stood",
        goal=name,
        stood=rounded_seconds(longest),
        asked=rounded_seconds(goal.seconds),
    )
    return Miss(words, place, at)


def _visit(goal: Visit, run: _Run) -> Miss | None:
    tag = next((tag for tag in run.world.tag if tag.id == goal.id), None) if run.world else None
    if tag is None or not run.path:
        return None
    place = (tag.x, tag.y)
    near = min(run.path, key=lambda placed: math.dist(xy(placed), place))
    away = math.dist(xy(near), place)
    if away > goal.distance:
        over = rounded_mm(away - goal.distance)
        words = Phrase("lesson-miss-tag-far", tag=goal.id, mm=over, most=rounded_mm(goal.distance))
        return Miss(words, place, xy(near))
    around = math.radians(tag.heading)
    is_before = math.cos(around) * (near.x - tag.x) - math.sin(around) * (near.y - tag.y) > 0
    if not is_before:
        return Miss(Phrase("lesson-miss-tag-behind", tag=goal.id), place, xy(near))
    off = heading_between(direction(xy(near), place), near.heading)
    return Miss(
        Phrase("lesson-miss-tag-facing", tag=goal.id, turn=turn_words(off)), place, xy(near)
    )


def _follow(goal: Follow, run: _Run) -> Miss | None:
    line = run.world.line_named(goal.line) if run.world else None
    if line is None or not run.path:
        return None
    middle = line.polyline()
    on = [*compress(run.path, is_on_line(run.path, middle, goal.distance))]
    if not on:
        return Miss(Phrase("lesson-line-never"))
    followed = FollowGoal(goal, middle)
    progress = max(followed.progress(_state(placed)) for placed in run.path)
    share, asked = math.floor(progress * goal.fraction * 100), round(goal.fraction * 100)
    words = Phrase("lesson-miss-follow", share=share, asked=asked)
    return Miss(words, xy(on[-1]), xy(run.path[-1]))


def _state(placed: Placed) -> RobotState:
    """A robot as the goals of the simulator see it."""
    return RobotState("", placed.moment.time, Pose(placed.x, placed.y, placed.heading))


def _show(goal: Show, run: _Run) -> Miss | None:
    shown = [moment for moment, text in run.evidence.emotions if text == goal.emotion]
    if not shown:
        return Miss(Phrase("lesson-miss-emotion", emotion=goal.emotion))
    if goal.radius is None or not run.path:
        return None
    place = (goal.x, goal.y)
    places = [place_at(run.path, moment) for moment in shown]
    nearest = min(places, key=lambda shown_at: math.dist(shown_at, place))
    mm = rounded_mm(math.dist(nearest, place))
    return Miss(Phrase("lesson-miss-emotion-away", emotion=goal.emotion, mm=mm), place, nearest)


def _avoid(goal: Avoid, run: _Run) -> Miss | None:
    if miss := _bumped(run):
        return miss
    left = max(0.0, goal.distance - run.evidence.distance)
    return Miss(
        Phrase("lesson-miss-goal", goal=goal_phrase(goal.name), gap=length_words("short", left))
    )


# Other checks.


def _at(event: At, run: _Run) -> Miss | None:
    if not run.path:
        return None
    place = (event.x, event.y)
    nearest = nearest_point(run.path, place)
    gap = gap_words(xy(run.path[0]), nearest, place)
    return Miss(Phrase("lesson-miss-near", gap=gap), place, nearest)


def _stood(event: Stood, run: _Run) -> Miss | None:
    if not run.path:
        return None
    longest, at = longest_stand(run.path)
    words = Phrase(
        "lesson-miss-stood", stood=rounded_seconds(longest), asked=rounded_seconds(event.seconds)
    )
    return Miss(words, None, at)


def _never(check: Never, run: _Run) -> Miss | None:
    if isinstance(check.what, Collided):
        hits = moments(check.what, run.evidence)
        return _bumped(run, hits)
    if isinstance(check.what, At) and run.has(check.what):
        first, *_ = moments(check.what, run.evidence)
        words = Phrase("lesson-miss-was-there", at=rounded_seconds(first.time))
        return Miss(words, (check.what.x, check.what.y), place_at(run.path, first))
    return None


def _bumped(run: _Run, hits: Sequence[Moment] | None = None) -> Miss | None:
    """Where the robot bumped first; the message says how far it had driven."""
    found = hits if hits is not None else [moment for moment, _ in run.evidence.collisions]
    if not found or not run.path:
        return None
    until = [placed for placed in run.path if placed.moment.time <= found[0].time] or run.path[:1]
    mm = rounded_mm(length_of(until))
    return Miss(Phrase("lesson-miss-bump", mm=mm), xy(until[-1]), xy(until[-1]))


def _ends_at(check: EndsAt, run: _Run) -> Miss | None:
    if not run.path:
        return None
    place, last = (check.x, check.y), run.path[-1]
    if math.dist(xy(last), place) > check.radius:
        gap = gap_words(xy(run.path[0]), xy(last), place)
        return Miss(Phrase("lesson-miss-stopped", gap=gap), place, xy(last))
    if check.heading is None:
        return None
    turn = turn_words(heading_between(check.heading, last.heading))
    return Miss(Phrase("lesson-miss-stopped-facing", turn=turn), place, xy(last))


def _drives(check: Drives, run: _Run) -> Miss | None:
    driven = run.evidence.distance
    if driven < check.at_least:
        gap = length_words("short", check.at_least - driven)
    elif check.at_most is not None and driven > check.at_most:
        gap = length_words("past", driven - check.at_most)
    else:
        return None
    return Miss(Phrase("lesson-miss-driven", driven=round(driven), gap=gap))


def _turns(check: Turns, run: _Run) -> Miss | None:
    turned = turned_along(run.path)
    # A turn to the left is negative: what counts is how much of the wanted turn was made.
    over = (turned - check.by) * (1 if check.by >= 0 else -1)
    code = "lesson-gap-over" if over > 0 else "lesson-gap-under"
    gap = Phrase(code, degrees=round(abs(over)))
    return Miss(Phrase("lesson-miss-turned", turned=round(turned), gap=gap))


def _on_line(check: StaysOnLine, run: _Run) -> Miss | None:
    line = run.world.line_named(check.line) if run.world else None
    if line is None:
        return None
    is_on = is_on_line(run.path, line.polyline(), check.distance)
    if True not in is_on:
        return None
    first = is_on.index(True)
    lost = next((index for index in range(first, len(is_on)) if not is_on[index]), None)
    if lost is None:
        return None
    left, at = run.path[lost - 1], run.path[lost]
    words = Phrase("lesson-miss-left-line", at=rounded_seconds(at.moment.time))
    return Miss(words, xy(left), xy(at))


_GOALS: Mapping[type, Callable[[Any, _Run], Miss | None]] = {
    Reach: _reach,
    Follow: _follow,
    Visit: _visit,
    Tour: _tour,
    Stop: _stop,
    Show: _show,
    Avoid: _avoid,
}
_CHECKS: Mapping[type, Callable[[Any, _Run], Miss | None]] = {
    Never: _never,
    EndsAt: _ends_at,
    Drives: _drives,
    Turns: _turns,
    StaysOnLine: _on_line,
}
