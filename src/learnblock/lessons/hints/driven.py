"""Rules about where the robot drove, compared with where it should have been."""

import math
from collections.abc import Callable, Iterator, Sequence
from itertools import accumulate, pairwise
from typing import Any

from learnblock.evidence.evidence import TimedPose
from learnblock.evidence.gaps import heading_between, turned_along
from learnblock.language.tree.flow import condition_of, is_counted, is_loop, is_waiting
from learnblock.language.tree.nodes import (
    Branch,
    Expression,
    If,
    SkillCall,
    When,
)
from learnblock.lessons.checks import (
    At,
    Drives,
    EndsAt,
    Event,
    Happens,
    InOrder,
    Never,
    Reaches,
    Turns,
)
from learnblock.lessons.hints import driving
from learnblock.lessons.hints.driving import Misdrive
from learnblock.lessons.hints.guess import Guess
from learnblock.lessons.hints.situation import Situation, asked_in, calls_in
from learnblock.lessons.hints.vocabulary import DRIVING, LASTING, OBSTACLES, sensors
from learnblock.lessons.judging import Verdict
from learnblock.simulator.goal_description import AnyGoal, Reach, Stop, Tour

#: Seconds between a command and the first look at the robot that shows it.
_DELAY = 0.25
#: Degrees by which a robot may face another way.
_FACING = 10.0

#: The sign of teachers' rules, and our rule, for each slip.
_RULES = {
    "wrong-sign": ("wrong-sign", "wrong_sign"),
    "wrong-direction": ("wrong-direction", "wrong_sign"),
    "too-short": ("value-too-small", "value_too_small"),
    "too-long": ("value-too-large", "value_too_large"),
    "turn-too-small": ("value-too-small", "value_too_small"),
    "turn-too-large": ("value-too-large", "value_too_large"),
    "no-turn": ("no-turn", None),
    "missing": ("too-early", "too_early"),
    "swapped": ("wrong-order", None),
}


def places(situation: Situation, verdict: Verdict) -> Iterator[Guess]:
    """The robot missed places: the first leg or turn that led it astray."""
    path = situation.evidence.path if situation.evidence else ()
    if not path or situation.ended == "error":
        return
    misdrive = _misdrive(situation, verdict, path)
    if misdrive is not None:
        yield from _guess(situation, misdrive)


def _misdrive(situation: Situation, verdict: Verdict, path: Sequence[TimedPose]) -> Misdrive | None:
    match verdict.check:
        case EndsAt(x=x, y=y, radius=radius, heading=heading):
            return _ended(path, (x, y), radius, heading)
        case Reaches():
            return _goal(situation, verdict.check, path)
        case InOrder(events=events):
            points = list(_first_places(events))
            if points:
                places_ = [(point.x, point.y) for point in points]
                return _tour(path, places_, min(point.radius for point in points))
        case Happens(what=At(x=x, y=y, radius=radius), at_least=1):
            return driving.through(path, (x, y), radius) or _tour(path, [(x, y)], radius)
    return None


def _first_places(events: Sequence[Event]) -> Iterator[At]:
    """The places at which events have to begin."""
    for event in events:
        if not isinstance(event, At):
            return
        yield event


def _ended(
    path: Sequence[TimedPose], target: tuple[float, float], radius: float, heading: float | None
) -> Misdrive | None:
    last = path[-1]
    if math.dist((last.x, last.y), target) > radius:
        return driving.to_end(path, target, radius)
    if heading is not None and abs(heading_between(last.heading, heading)) > _FACING:
        return driving.facing(path, heading)
    return None


def _goal(situation: Situation, check: Reaches, path: Sequence[TimedPose]) -> Misdrive | None:
    goal = _first_missed(situation, check)
    match goal:
        case Tour(points=points, radius=radius):
            return _tour(path, [(x, y) for x, y in points], radius)
        case Reach(x=x, y=y, radius=radius, object=None, together=False, alone=False):
            return driving.through(path, (x, y), radius) or _tour(path, [(x, y)], radius)
        case Stop(x=x, y=y, radius=radius, heading=heading):
            return _ended(path, (x, y), radius, heading)
    return None


def _first_missed(situation: Situation, check: Reaches) -> AnyGoal | None:
    if situation.world is None or situation.evidence is None:
        return None
    reached = situation.evidence.reached
    goals = [goal for _, _, goal in situation.world.goal.all()]
    missed = [
        goal
        for goal in goals
        if goal.name not in reached and (not check.goals or goal.name in check.goals)
    ]
    # One that comes after another is missed because of that.
    names = {goal.name for goal in missed}
    return next((goal for goal in missed if goal.after not in names), None)


def _tour(
    path: Sequence[TimedPose], points: Sequence[tuple[float, float]], radius: float
) -> Misdrive | None:
    index, source = 0, path[0]
    for point in points:
        reached = _reached(path, index, point, radius)
        if reached is None:
            return driving.toward(path[index:], point, radius, source)
        index, source = reached, path[reached]
    return None


def _reached(
    path: Sequence[TimedPose], start: int, point: tuple[float, float], radius: float
) -> int | None:
    """Where on its way the robot was closest to a place on its first visit."""
    best: int | None = None
    for index in range(start, len(path)):
        away = math.dist((path[index].x, path[index].y), point)
        if away <= radius:
            # A robot that turns on the spot moves a little: that is no better place.
            if best is None or away < math.dist((path[best].x, path[best].y), point) - 1:
                best = index
        elif best is not None:
            break
    return best


def _guess(situation: Situation, misdrive: Misdrive) -> Iterator[Guess]:
    rule, sign = _RULES[misdrive.slip]
    if misdrive.slip == "missing":
        yield _missing(situation)
        return
    line = _line_at(situation, misdrive.time)
    about = _about(situation, line)
    sensor = None if misdrive.turned else _ending_sensor(situation, about)
    if sensor and misdrive.slip in {"too-short", "too-long"}:
        # The robot stops where a sensor tells it to.
        line, skill = sensor
        swaps = skill in OBSTACLES
        rule, sign = _RULES[_OTHER[misdrive.slip] if swaps else misdrive.slip]
        about = frozenset({skill})
        surely = 0
    else:
        surely = 5
    yield Guess(rule, (line,) if line else (), about, {}, sign, surely)  # type: ignore[arg-type]


def _missing(situation: Situation) -> Guess:
    """The program ended before the next leg: after a loop, that has too few rounds."""
    counted = [loop for loop in situation.loops if is_counted(loop)]
    if counted:
        about = frozenset({"repeat", "loop"})
        return Guess("too-few-times", (counted[-1].span.line,), about, {}, "too_early", 5)
    return Guess("too-early", sign="too_early", surely=20)


_OTHER = {"too-short": "too-long", "too-long": "too-short"}


def _line_at(situation: Situation, time: float) -> int:
    """The line whose command moved the robot from a time on."""
    return _line_before(situation, time + _DELAY)


def _line_before(situation: Situation, time: float) -> int:
    """The line whose command was the last to move the robot until a time."""
    lines = [call.line for call in situation.calls if call.skill in DRIVING and call.time <= time]
    return lines[-1] if lines else 0


def _about(situation: Situation, line: int) -> frozenset[str]:
    return frozenset(
        call.name
        for node in situation.statements
        if node.span.line == line
        for call in calls_in(node, SkillCall)
    )


def _ending_sensor(situation: Situation, about: frozenset[str]) -> tuple[int, str] | None:
    """The line and the skill of a sensor that decides how long the robot drives."""
    if not about & LASTING:
        return None
    for line, condition in _ending_conditions(situation):
        for call in asked_in(condition):
            if call.name in sensors():
                return line, call.name
    return None


def _ending_conditions(situation: Situation) -> Iterator[tuple[int, Expression]]:
    """Conditions that may end a drive, the likeliest first.

    An ``if`` or an event ends one if it asks for an obstacle: other sensors steer.
    """
    statements = situation.statements
    for node in statements:
        condition = condition_of(node)
        if condition is not None and (is_loop(node) or is_waiting(node)):
            yield node.span.line, condition
    for node in statements:
        parts: Sequence[Branch | When] = ()
        if isinstance(node, If):
            parts = node.branches
        elif isinstance(node, When):
            parts = (node,)
        for part in parts:
            if part.condition and any(call.name in OBSTACLES for call in asked_in(part.condition)):
                yield part.span.line, part.condition


def turned(situation: Situation, verdict: Verdict) -> Iterator[Guess]:
    """The robot turned by another angle in all."""
    if not isinstance(verdict.check, Turns) or situation.evidence is None:
        return
    path = situation.evidence.path
    real = turned_along(path)
    wanted, tolerance = verdict.check.by, verdict.check.tolerance
    first = next(
        (call for call in situation.calls if call.skill in DRIVING and _is_turn(call)), None
    )
    lines = (first.line,) if first and first.line else ()
    about = frozenset({first.skill}) if first else frozenset[str]()
    if abs(real) <= tolerance:
        yield Guess("no-turn", (), about, surely=5)
    elif abs(real + wanted) <= max(tolerance, abs(wanted) / 10) or real * wanted < 0:
        yield Guess("wrong-direction", lines, about, sign="wrong_sign", surely=10)
    elif abs(real) < abs(wanted):
        yield Guess("value-too-small", lines, about, sign="value_too_small", surely=5)
    else:
        turns = [abs(turned_along(pair)) for pair in pairwise(path)]
        line = _line_beyond(situation, turns, abs(wanted) + tolerance)
        yield _too_large(situation, line, surely=5)


def _line_beyond(situation: Situation, parts: Sequence[float], most: float) -> int:
    """The line whose command added what was too much; each part is of 0.1 s of the way."""
    path = situation.evidence.path if situation.evidence else ()
    beyond = (number for number, total in enumerate(accumulate(parts)) if total > most)
    number = next(beyond, None)
    return 0 if number is None else _line_before(situation, path[number].moment.time)


def _too_large(situation: Situation, line: int, surely: int) -> Guess:
    about = _about(situation, line)
    return Guess("value-too-large", (line,) if line else (), about, {}, "value_too_large", surely)


def _is_turn(call: Any) -> bool:
    return call.skill not in {"move_straight", "drive_distance"}


def drove(situation: Situation, verdict: Verdict) -> Iterator[Guess]:
    """The robot drove too little or too much, along its way."""
    if not isinstance(verdict.check, Drives) or situation.evidence is None:
        return
    path = situation.evidence.path
    first = next((call for call in situation.calls if call.skill in DRIVING), None)
    lines = (first.line,) if first and first.line else ()
    about = frozenset({first.skill}) if first else frozenset[str]()
    most = verdict.check.at_most
    if most is not None and situation.evidence.distance > most:
        driven = [math.dist(before[1:3], after[1:3]) for before, after in pairwise(path)]
        yield _too_large(situation, _line_beyond(situation, driven, most), surely=-5)
    elif situation.evidence.distance >= 1:
        yield Guess("value-too-small", lines, about, sign="value_too_small", surely=-5)


def forbidden_place(situation: Situation, verdict: Verdict) -> Iterator[Guess]:
    """The robot came to a place that it must keep away from."""
    if isinstance(verdict.check, Never) and isinstance(verdict.check.what, At):
        at = verdict.at if verdict.at is not None else situation.end
        yield _too_large(situation, _line_at(situation, at), surely=-10)


def never_moved(situation: Situation, verdict: Verdict) -> Iterator[Guess]:
    """The robot does not move at all, and should."""
    if situation.evidence is None or situation.evidence.distance > 1 or not situation.calls:
        return
    asks_place = isinstance(verdict.check, EndsAt | Drives | Reaches | Turns) or (
        isinstance(verdict.check, Happens) and isinstance(verdict.check.what, At)
    )
    never_turned = abs(turned_along(situation.evidence.path)) < 1
    if asks_place and never_turned and _has_places(situation, verdict):
        yield Guess("never-moved", sign="too_early")


def _has_places(situation: Situation, verdict: Verdict) -> bool:
    if not isinstance(verdict.check, Reaches):
        return True
    goal = _first_missed(situation, verdict.check)
    return goal is None or not hasattr(goal, "emotion")


RULES: tuple[Callable[[Situation, Verdict], Iterator[Guess]], ...] = (
    places,
    turned,
    drove,
    forbidden_place,
    never_moved,
)
