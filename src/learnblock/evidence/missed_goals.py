"""By how much, and where, a run missed the goals of its world."""

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import compress, pairwise
from typing import Any

from learnblock.evidence.evidence import Evidence, Moment, TimedPose, length_of
from learnblock.evidence.gaps import (
    XY,
    direction,
    gap_words,
    heading_between,
    is_on_line,
    length_words,
    longest_stand,
    nearest_point,
    place_at,
    rounded_mm,
    rounded_seconds,
    turn_words,
    xy,
)
from learnblock.evidence.missed_games import missed_game
from learnblock.i18n import Phrase
from learnblock.i18n.names import goal_phrase
from learnblock.simulator import WorldDescription
from learnblock.simulator.game.teams import teams_of
from learnblock.simulator.geometry import Pose
from learnblock.simulator.goal import RobotState
from learnblock.simulator.goal_description import (
    AnyGoal,
    Avoid,
    CollectThings,
    Follow,
    GameGoal,
    Gates,
    Reach,
    Score,
    Show,
    Stop,
    Tour,
    Visit,
)
from learnblock.simulator.goals import FollowGoal

#: Degrees by which the way between the places of a tour turns at a corner.
_CORNER = 30


@dataclass(frozen=True, slots=True)
class Miss:
    """By how much a run missed something.

    Args:
        words: what was missed, and by how much.
        place: where it is, if it has a place.
        nearest: how near to it the robot came, or where it failed.
        time: when it was there, in s; None without such a place.
    """

    words: Phrase
    place: XY | None = None
    nearest: XY | None = None
    time: float | None = None


@dataclass(frozen=True)
class RunInWorld:
    """A run, and the world that it was in.

    Args:
        evidence: what is known of the run.
        world: its world; None if that is not known.
    """

    evidence: Evidence
    world: WorldDescription | None

    @property
    def goals(self) -> Mapping[str, AnyGoal]:
        """The goals of the world, by name."""
        return {goal.name: goal for _, _, goal in self.world.goal.all()} if self.world else {}

    @property
    def path(self) -> Sequence[TimedPose]:
        """Where the robot was."""
        return self.evidence.path

    def of(self, goal: AnyGoal) -> Iterable["RunInWorld"]:
        """The same run, looked at for each robot that may reach a goal."""
        names = [goal.robot] if goal.robot else self._robots_of(goal.team)
        if len(self.evidence.team) <= 1 and not goal.robot:
            return (self,)
        return tuple(RunInWorld(self.evidence.of(name), self.world) for name in names)

    def _robots_of(self, team: str | None) -> Sequence[str]:
        """The robots of a team; without a team, all of them."""
        robots = list(self.evidence.team)
        if team is None or self.world is None:
            return robots
        teams = teams_of(self.world, robots)
        return [robot for robot in robots if teams[robot] == team]


def missed_goal(run: RunInWorld, names: Sequence[str]) -> Miss | None:
    """By how much the first goal was missed that could have been reached."""
    goals = run.goals
    missing = [goals[name] for name in names if name in goals and not _is_reached(name, run)]
    first = missing[0] if missing else None
    while first and first.after in goals and not _is_reached(str(first.after), run):
        first = goals[str(first.after)]
    return _goal(first, run) if first else None


def _is_reached(name: str, run: RunInWorld) -> bool:
    return name in run.evidence.reached


def _goal(goal: AnyGoal, run: RunInWorld) -> Miss | None:
    """The best miss of the robots that may reach a goal."""
    misses = [_timed(miss, own) for own in run.of(goal) if (miss := _GOALS[type(goal)](goal, own))]
    # All of several robots have to come: the last of them counts.
    choose = max if isinstance(goal, Reach) and goal.together else min
    return choose(misses, key=_distance) if misses else None


def _timed(miss: Miss, run: RunInWorld) -> Miss:
    """A miss with the first time at which the robot was nearest."""
    if (nearest := miss.nearest) is None or not run.path:
        return miss
    there = min(run.path, key=lambda placed: math.dist(xy(placed), nearest))
    return replace(miss, time=there.moment.time)


def _distance(miss: Miss) -> float:
    if miss.place is None or miss.nearest is None:
        return math.inf
    return math.dist(miss.place, miss.nearest)


def _reach(goal: Reach, run: RunInWorld) -> Miss | None:
    place = (goal.x, goal.y)
    if goal.object is not None:
        words = Phrase("miss-object", thing=goal.object)
        return Miss(words, place)
    if not run.path:
        return None
    if goal.alone and math.dist(xy(run.path[-1]), place) <= goal.radius:
        words = Phrase("miss-not-alone", goal=goal_phrase(goal.name))
        return Miss(words, place, xy(run.path[-1]))
    if goal.together or goal.alone:
        return _near(goal, place, run, xy(run.path[-1]))
    return _near(goal, place, run, nearest_point(run.path, place))


def _near(goal: AnyGoal, place: XY, run: RunInWorld, nearest: XY) -> Miss:
    gap = gap_words(xy(run.path[0]), nearest, place)
    return Miss(Phrase("miss-goal", goal=goal_phrase(goal.name), gap=gap), place, nearest)


def _tour(goal: Tour, run: RunInWorld) -> Miss | None:
    if not run.path:
        return None
    count = len(goal.points)
    passed, remaining = _passed(goal, run)
    if passed >= count:
        return None
    place = goal.points[passed]
    before = goal.points[passed - 1] if passed else xy(run.path[0])
    nearest = nearest_point(remaining, place)
    gap = gap_words(before, nearest, place)
    code = "miss-corner" if _has_corners(goal.points) else "miss-place"
    return Miss(Phrase(code, number=passed + 1, count=count, gap=gap), place, nearest)


def _passed(goal: Tour, run: RunInWorld) -> tuple[int, Sequence[TimedPose]]:
    """How many places of a tour were passed, and the way from the last of them on."""
    passed, remaining = 0, run.path
    for index, piece in enumerate(pairwise(run.path), 1):
        if passed == len(goal.points):
            break
        place = goal.points[passed]
        if math.dist(nearest_point(piece, place), place) <= goal.radius:
            passed, remaining = passed + 1, run.path[index:]
    return passed, remaining


def _has_corners(points: Sequence[XY]) -> bool:
    """Whether the way through places turns at each of them."""
    ways = [direction(before, after) for before, after in pairwise(points)]
    turns = [abs(heading_between(before, after)) for before, after in pairwise(ways)]
    return bool(turns) and min(turns) >= _CORNER


def _stop(goal: Stop, run: RunInWorld) -> Miss | None:
    if not run.path:
        return None
    place, last = (goal.x, goal.y), run.path[-1]
    if math.dist(xy(last), place) > goal.radius:
        return _near(goal, place, run, xy(last))
    name = goal_phrase(goal.name)
    if goal.heading is not None:
        off = heading_between(goal.heading, last.heading)
        if abs(off) > goal.angle:
            return Miss(Phrase("miss-facing", goal=name, turn=turn_words(off)), place, xy(last))
    longest, at = longest_stand(run.path, lambda pose: math.dist(pose, place) <= goal.radius)
    words = Phrase(
        "miss-goal-stood",
        goal=name,
        stood=rounded_seconds(longest),
        asked=rounded_seconds(goal.seconds),
    )
    return Miss(words, place, at)


def _visit(goal: Visit, run: RunInWorld) -> Miss | None:
    tag = next((tag for tag in run.world.tag if tag.id == goal.id), None) if run.world else None
    if tag is None or not run.path:
        return None
    place = (tag.x, tag.y)
    near = min(run.path, key=lambda placed: math.dist(xy(placed), place))
    away = math.dist(xy(near), place)
    if away > goal.distance:
        over = rounded_mm(away - goal.distance)
        words = Phrase("miss-tag-far", tag=goal.id, mm=over, most=rounded_mm(goal.distance))
        return Miss(words, place, xy(near))
    around = math.radians(tag.heading)
    is_before = math.cos(around) * (near.x - tag.x) - math.sin(around) * (near.y - tag.y) > 0
    if not is_before:
        return Miss(Phrase("miss-tag-behind", tag=goal.id), place, xy(near))
    off = heading_between(direction(xy(near), place), near.heading)
    return Miss(Phrase("miss-tag-facing", tag=goal.id, turn=turn_words(off)), place, xy(near))


def _follow(goal: Follow, run: RunInWorld) -> Miss | None:
    line = run.world.line_named(goal.line) if run.world else None
    if line is None or not run.path:
        return None
    middle = line.polyline()
    on = [*compress(run.path, is_on_line(run.path, middle, goal.distance))]
    if not on:
        return Miss(Phrase("miss-line-never"))
    followed = FollowGoal(goal, middle)
    progress = max(followed.progress(_state(placed)) for placed in run.path)
    share, target = math.floor(progress * goal.fraction * 100), round(goal.fraction * 100)
    words = Phrase("miss-follow", share=share, asked=target)
    return Miss(words, xy(on[-1]), xy(run.path[-1]))


def _state(placed: TimedPose) -> RobotState:
    """A robot as the goals of the simulator see it."""
    return RobotState("", placed.moment.time, Pose(placed.x, placed.y, placed.heading))


def _show(goal: Show, run: RunInWorld) -> Miss | None:
    moments = [moment for moment, text in run.evidence.emotions if text == goal.emotion]
    if not moments:
        return Miss(Phrase("miss-emotion", emotion=goal.emotion))
    if goal.radius is None or not run.path:
        return None
    place = (goal.x, goal.y)
    places = [place_at(run.path, moment) for moment in moments]
    nearest = min(places, key=lambda shown_at: math.dist(shown_at, place))
    mm = rounded_mm(math.dist(nearest, place))
    return Miss(Phrase("miss-emotion-away", emotion=goal.emotion, mm=mm), place, nearest)


def _avoid(goal: Avoid, run: RunInWorld) -> Miss | None:
    if miss := first_bump(run):
        return miss
    shortfall = max(0.0, goal.distance - run.evidence.distance)
    return Miss(
        Phrase("miss-goal", goal=goal_phrase(goal.name), gap=length_words("short", shortfall))
    )


def first_bump(run: RunInWorld, hits: Sequence[Moment] | None = None) -> Miss | None:
    """Where the robot bumped first; the message says how far it had driven."""
    bumps = hits if hits is not None else [moment for moment, _ in run.evidence.collisions]
    if not bumps or not run.path:
        return None
    until = [placed for placed in run.path if placed.moment.time <= bumps[0].time] or run.path[:1]
    mm = rounded_mm(length_of(until))
    return Miss(Phrase("miss-bump", mm=mm), xy(until[-1]), xy(until[-1]))


def _game(goal: GameGoal, run: RunInWorld) -> Miss | None:
    return Miss(missed_game(goal, run.evidence, run.world)) if run.world else None


_GOALS: Mapping[type, Callable[[Any, RunInWorld], Miss | None]] = {
    Reach: _reach,
    Follow: _follow,
    Visit: _visit,
    Tour: _tour,
    Stop: _stop,
    Show: _show,
    Avoid: _avoid,
    Score: _game,
    CollectThings: _game,
    Gates: _game,
}
