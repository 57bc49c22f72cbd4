"""How a robot drove, as straight legs with turns between them, and which one led it astray."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import combinations, pairwise
from typing import Literal

from learnblock.evidence.evidence import TimedPose
from learnblock.evidence.gaps import heading_between

#: In 0.1 s: mm from which a robot drives, and degrees from which it turns.
_DRIVES, _TURNS = 0.5, 0.8
#: Seconds of standing between two movements.
_STANDS = 0.05
#: Shorter legs are a robot that settles, mm.
_SHORTEST = 12.0
#: Smaller turns are none, degrees.
_NO_TURN = 15.0
#: Headings that differ by less are the same direction, degrees.
_SAME, _OPPOSITE = 30.0, 150.0
#: With more legs a robot follows something, and its way can't be compared with a place.
MOST_LEGS = 40
#: Among so many first legs, two may be in the wrong order.
_SWAPPED = 8

#: How a leg or the turn before it is wrong.
Slip = Literal[
    "wrong-sign",
    "wrong-direction",
    "too-short",
    "too-long",
    "turn-too-small",
    "turn-too-large",
    "no-turn",
    "missing",
    "swapped",
]


@dataclass(frozen=True)
class Leg:
    """A straight part of a way.

    Args:
        start: where it began.
        end: where it ended.
        length: mm; negative for backwards.
        turn: the degrees turned since the leg before, to the right positive.
        turned_at: when that turn began, in seconds; the start of the leg if there was none.
    """

    start: TimedPose
    end: TimedPose
    length: float
    turn: float
    turned_at: float

    @property
    def time(self) -> float:
        return self.start.moment.time

    @property
    def vector(self) -> tuple[float, float]:
        return self.end.x - self.start.x, self.end.y - self.start.y


@dataclass(frozen=True)
class Misdrive:
    """What led a robot astray.

    Args:
        slip: how.
        time: when the leg or turn began that is wrong.
        turned: whether it is a turn.
    """

    slip: Slip
    time: float
    turned: bool = False


def legs(path: Sequence[TimedPose]) -> tuple[tuple[Leg, ...], float, float]:
    """The straight parts of a way; the degrees turned after the last, and when that turn began."""
    parts: list[Leg] = []
    turn, turned_at = 0.0, math.nan
    stood = 0.0
    current: list[TimedPose] = []
    forwards = True
    for before, after in pairwise(path):
        dx, dy = after.x - before.x, after.y - before.y
        turned = heading_between(before.heading, after.heading)
        length = math.hypot(dx, dy)
        is_ahead = _ahead(before, dx, dy) >= 0
        stood = stood + after.moment.time - before.moment.time if length < _DRIVES else 0.0
        straight = length >= _DRIVES and abs(turned) < _TURNS
        if current and (not straight or is_ahead != forwards):
            if straight or abs(turned) >= _TURNS or stood > _STANDS:
                leg = _leg(current, turn, turned_at, forwards=forwards)
                if leg:
                    parts.append(leg)
                    turn, turned_at = 0.0, math.nan
                current = []
            else:
                continue
        if straight:
            forwards = is_ahead if not current else forwards
            current = current or [before]
            current.append(after)
        elif abs(turned) >= _TURNS / 2:
            turned_at = before.moment.time if math.isnan(turned_at) else turned_at
            turn += turned
    if current and (leg := _leg(current, turn, turned_at, forwards=forwards)):
        parts.append(leg)
        turn, turned_at = 0.0, math.nan
    return tuple(parts), turn, turned_at


def _ahead(before: TimedPose, dx: float, dy: float) -> float:
    angle = math.radians(before.heading)
    return dx * math.cos(angle) - dy * math.sin(angle)


def _leg(
    places: Sequence[TimedPose], turn: float, turned_at: float, *, forwards: bool
) -> Leg | None:
    start, end = places[0], places[-1]
    length = math.hypot(end.x - start.x, end.y - start.y)
    if length < _SHORTEST:
        return None
    at = start.moment.time if math.isnan(turned_at) else turned_at
    return Leg(start, end, length if forwards else -length, turn, at)


def toward(
    path: Sequence[TimedPose], target: tuple[float, float], radius: float, source: TimedPose
) -> Misdrive | None:
    """Why a robot did not come from one place to the next; only the first leg counts.

    Args:
        path: its way from there on.
        target: the next place, mm.
        radius: how close it has to come, mm.
        source: where it was, and its heading.
    """
    driven, turned, turned_at = legs(path)
    if len(driven) > MOST_LEGS:
        return None
    dx, dy = target[0] - source.x, target[1] - source.y
    distance = math.hypot(dx, dy)
    wanted = heading_between(source.heading, _heading(dx, dy))
    if not driven:
        return _only_turned(wanted, turned, turned_at, path)
    first = driven[0]
    real = _driven_heading(first)
    off = heading_between(_heading(dx, dy), real)
    if abs(off) <= _SAME:
        return _along(first, distance, radius, off, driven[1:])
    if _continues(driven, wanted):
        return Misdrive("too-long", first.time)
    return _aside(first, wanted, off)


def _continues(driven: Sequence[Leg], wanted: float) -> bool:
    """Whether a robot drives past the place where it has to turn, and turns later."""
    passes = abs(driven[0].turn) < _NO_TURN and driven[0].length > 0
    return passes and len(driven) > 1 and abs(heading_between(driven[1].turn, wanted)) < _SAME


def _only_turned(
    wanted: float, turned: float, turned_at: float, path: Sequence[TimedPose]
) -> Misdrive:
    if abs(wanted) > _SAME and abs(turned) > _NO_TURN and abs(turned + wanted) < _SAME:
        return Misdrive("wrong-direction", turned_at, turned=True)
    return Misdrive("missing", path[-1].moment.time if path else 0.0)


def _along(
    leg: Leg, distance: float, radius: float, off: float, more: Sequence[Leg]
) -> Misdrive | None:
    length = abs(leg.length)
    if length < distance - radius:
        if more and abs(more[0].turn) < _NO_TURN and more[0].length * leg.length > 0:
            # It drives on in the same direction: several legs for one way.
            total = length + abs(more[0].length)
            return None if abs(total - distance) <= radius else Misdrive("too-short", leg.time)
        return Misdrive("too-short", leg.time)
    if length > distance + radius:
        return Misdrive("too-long", leg.time)
    slip: Slip = "turn-too-large" if off * leg.turn > 0 else "turn-too-small"
    return Misdrive(slip, leg.turned_at, turned=True)


def _aside(leg: Leg, wanted: float, off: float) -> Misdrive:
    """A leg in another direction than wanted."""
    real = leg.turn
    if abs(off) >= _OPPOSITE and abs(real) < _NO_TURN:
        if abs(wanted) < _OPPOSITE or leg.length < 0:
            return Misdrive("wrong-sign", leg.time)
        return Misdrive("no-turn", leg.time, turned=True)
    if abs(real) < _NO_TURN:
        return Misdrive("no-turn", leg.time, turned=True)
    if abs(wanted) > _NO_TURN and abs(heading_between(real, -wanted)) < _SAME:
        return Misdrive("wrong-direction", leg.turned_at, turned=True)
    if real * wanted < 0 and abs(real) < _OPPOSITE:
        return Misdrive("wrong-direction", leg.turned_at, turned=True)
    slip: Slip = "turn-too-large" if abs(real) > abs(wanted) else "turn-too-small"
    return Misdrive(slip, leg.turned_at, turned=True)


def to_end(
    path: Sequence[TimedPose], target: tuple[float, float], radius: float
) -> Misdrive | None:
    """Which single leg or turn, if it were another, would have led a robot to where it should end.

    Args:
        path: its way.
        target: where it should end, mm.
        radius: how close, mm.
    """
    driven, _, _ = legs(path)
    if not path or not driven or len(driven) > MOST_LEGS:
        return None
    start = path[0]
    for misdrive, variant in _fixes(driven):
        if math.dist(_end(start, variant), target) <= radius:
            return misdrive
    return (
        _scaled(start, driven, target, radius)
        or _turned(start, driven, target, radius)
        or _straight(start, driven, target)
    )


def through(
    path: Sequence[TimedPose], target: tuple[float, float], radius: float
) -> Misdrive | None:
    """Which single leg or turn, if it were another, would have led a robot past a place.

    Args:
        path: its way.
        target: the place, mm.
        radius: how close it has to come, mm.
    """
    driven, _, _ = legs(path)
    if not path or len(driven) < 2 or len(driven) > MOST_LEGS:
        return None
    for misdrive, variant in _fixes(driven):
        corners = pairwise(_corners(path[0], variant))
        if any(_away(target, start, end) <= radius for start, end in corners):
            return misdrive
    return None


def _away(
    point: tuple[float, float], start: tuple[float, float], end: tuple[float, float]
) -> float:
    """The mm from a point to a straight part of a way."""
    dx, dy = end[0] - start[0], end[1] - start[1]
    square = dx * dx + dy * dy
    along = ((point[0] - start[0]) * dx + (point[1] - start[1]) * dy) / square if square else 0.0
    share = min(1.0, max(0.0, along))
    return math.dist(point, (start[0] + share * dx, start[1] + share * dy))


def _straight(
    start: TimedPose, driven: Sequence[Leg], target: tuple[float, float]
) -> Misdrive | None:
    """Whether a robot never turned on a way with a corner."""
    wanted = _heading(target[0] - start.x, target[1] - start.y)
    is_aside = _SAME < abs(heading_between(start.heading, wanted)) < _OPPOSITE
    if is_aside and all(abs(leg.turn) < _NO_TURN for leg in driven):
        return Misdrive("no-turn", driven[-1].time, turned=True)
    return None


def _fixes(driven: Sequence[Leg]) -> Iterator[tuple[Misdrive, Sequence[Leg]]]:
    """Ways with one thing the other way round, the last first, and then with all of them."""
    last_first = list(reversed(list(enumerate(driven))))
    for index, leg in last_first:
        if leg.length < 0:
            yield Misdrive("wrong-sign", leg.time), _with(driven, index, _backwards(leg))
    for index, leg in last_first:
        if abs(leg.turn) > _NO_TURN:
            mirrored = _with(driven, index, replace(leg, turn=-leg.turn))
            yield Misdrive("wrong-direction", leg.turned_at, turned=True), mirrored
    for index, leg in last_first:
        yield Misdrive("wrong-sign", leg.time), _with(driven, index, _backwards(leg))
    if any(abs(leg.turn) > _NO_TURN for leg in driven):
        first = next(leg for leg in driven if abs(leg.turn) > _NO_TURN)
        opposite = [replace(leg, turn=-leg.turn) for leg in driven]
        yield Misdrive("wrong-direction", first.turned_at, turned=True), opposite
    yield Misdrive("wrong-sign", driven[0].time), [_backwards(leg) for leg in driven]
    for index, other in combinations(range(min(len(driven), _SWAPPED)), 2):
        swapped = _with(driven, index, replace(driven[index], length=driven[other].length))
        swapped = _with(swapped, other, replace(driven[other], length=driven[index].length))
        yield Misdrive("swapped", driven[index].time), swapped


def _with(driven: Sequence[Leg], index: int, leg: Leg) -> Sequence[Leg]:
    return [*driven[:index], leg, *driven[index + 1 :]]


def _backwards(leg: Leg) -> Leg:
    return replace(leg, length=-leg.length)


def _end(start: TimedPose, driven: Sequence[Leg]) -> tuple[float, float]:
    """Where a robot ends that drives these legs and turns."""
    *_, end = _corners(start, driven)
    return end


def _corners(start: TimedPose, driven: Sequence[Leg]) -> Iterator[tuple[float, float]]:
    """Where a robot is that drives these legs and turns: at the start, and after each leg."""
    x, y, heading = start.x, start.y, start.heading
    yield x, y
    for leg in driven:
        heading += leg.turn
        angle = math.radians(heading)
        x += leg.length * math.cos(angle)
        y -= leg.length * math.sin(angle)
        yield x, y


def _scaled(
    start: TimedPose, driven: Sequence[Leg], target: tuple[float, float], radius: float
) -> Misdrive | None:
    """The leg, or all of them, that had to be longer or shorter by the smallest factor."""
    end = _end(start, driven)
    error = target[0] - end[0], target[1] - end[1]
    choices: list[tuple[float, Misdrive]] = []
    whole = end[0] - start.x, end[1] - start.y
    for vector, time in [*((leg.vector, leg.time) for leg in driven), (whole, driven[0].time)]:
        square = vector[0] ** 2 + vector[1] ** 2
        if square < _SHORTEST**2:
            continue
        more = (error[0] * vector[0] + error[1] * vector[1]) / square
        distance = math.hypot(error[0] - more * vector[0], error[1] - more * vector[1])
        if distance <= radius and more > -1:
            slip: Slip = "too-short" if more > 0 else "too-long"
            choices.append((abs(math.log(1 + more)), Misdrive(slip, time)))
        elif distance <= radius:
            choices.append((math.inf, Misdrive("wrong-sign", time)))
    return min(choices, key=lambda choice: choice[0])[1] if choices else None


def _turned(
    start: TimedPose,
    driven: Sequence[Leg],
    target: tuple[float, float],
    radius: float,
) -> Misdrive | None:
    """The turn that had to be larger or smaller."""
    for index in reversed(range(len(driven))):
        leg = driven[index]
        if index == 0 and len(driven) > 1 and abs(leg.turn) < _NO_TURN:
            break
        pivot = leg.start.x, leg.start.y
        end = _end(start, driven)
        if abs(math.dist(pivot, target) - math.dist(pivot, end)) > radius:
            continue
        real = _heading(end[0] - pivot[0], end[1] - pivot[1])
        wanted = _heading(target[0] - pivot[0], target[1] - pivot[1])
        more = heading_between(real, wanted)
        if abs(leg.turn) < _NO_TURN:
            return Misdrive("no-turn", leg.time, turned=True)
        slip: Slip = "turn-too-small" if more * leg.turn > 0 else "turn-too-large"
        return Misdrive(slip, leg.turned_at, turned=True)
    return None


def facing(path: Sequence[TimedPose], wanted: float) -> Misdrive | None:
    """Why a robot ends at the right place and faces the wrong way."""
    driven, turn, turned_at = legs(path)
    if not path or len(driven) > MOST_LEGS:
        return None
    last = path[-1]
    if abs(turn) < _NO_TURN:
        time = driven[-1].time if driven else 0.0
        return Misdrive("no-turn", time, turned=True)
    before = last.heading - turn
    if abs(heading_between(before - turn, wanted)) < _NO_TURN:
        return Misdrive("wrong-direction", turned_at, turned=True)
    slip = _compared(turn, heading_between(before, wanted))
    if slip == "turn-too-large":
        turned_at = _left(path, wanted, turned_at)
    return Misdrive(slip, turned_at, turned=True)


def _left(path: Sequence[TimedPose], wanted: float, since: float) -> float:
    """When a robot last stood and faced right before it turned on, in seconds."""
    for before, after in reversed(list(pairwise(path))):
        if before.moment.time <= since:
            break
        has_stood = abs(heading_between(before.heading, after.heading)) < _TURNS / 2
        if has_stood and abs(heading_between(after.heading, wanted)) < _NO_TURN:
            return after.moment.time
    return since


def _compared(turn: float, wanted: float) -> Slip:
    return "turn-too-large" if abs(turn) > abs(wanted) else "turn-too-small"


def _heading(dx: float, dy: float) -> float:
    """The heading of a direction: clockwise, 0 in the east."""
    return math.degrees(math.atan2(-dy, dx))


def _driven_heading(leg: Leg) -> float:
    return _heading(*leg.vector)
