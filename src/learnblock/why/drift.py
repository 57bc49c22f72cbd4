"""Checks a real robot's calibration by its way: how much too far it drives and turns."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from learnblock.robots.calibration import ANGLE, DISTANCE, Calibration
from learnblock.why.prediction import Prediction
from learnblock.why.ways import Way

#: Smaller differences are those of wires and of noise, not of wheels.
NOTICEABLE = 0.02
#: The shortest way and the smallest turn that give a result: mm, and degrees.
LEAST_WAY, LEAST_TURN = 150.0, 90.0
#: The minimum length of a straight part that a distance sensor can measure, mm, and its maximum
#: turn, degrees.
_APPROACH, _STRAIGHT = 50.0, 5.0
#: The object in front must come as much closer as the twin drives; otherwise it is another one.
_SQUARELY = 0.15
#: The minimum number of readings of it; fewer are only noise.
_LEAST_READINGS = 5
#: The maximum scatter of a distance sensor's readings.
_SURE = NOTICEABLE / 2
#: Less counts as standing still: mm or degrees.
_STILL = 0.5


@dataclass(frozen=True, slots=True)
class Ratio:
    """The real robot's movement as a share of its twin's.

    Args:
        ratio: 1 if it did the same, 1.04 for 4 % more.
        sensor: what measured it: ``odometry``, ``gyroscope`` or ``distance``.
        of: what the twin did in all: mm or degrees.
    """

    ratio: float
    sensor: str
    of: float

    @property
    def percent(self) -> float:
        """How much more it did, in percent; negative for less."""
        return round(100 * (self.ratio - 1), 1)

    @property
    def is_noticeable(self) -> bool:
        """Whether it is more than wires and noise can explain."""
        return abs(self.ratio - 1) >= NOTICEABLE


@dataclass(frozen=True)
class Drift:
    """How far a real robot drives and turns, compared with its commands.

    Args:
        counted_way: how far it drove by its own report, compared with its twin; None if that is not
            known, or if it was too little.
        counted_turn: how far it turned by its own report, compared with its twin.
        way: how far it really drove: of what its wheels counted if settings of ours are in that,
            otherwise of what its twin drove. None if nothing measured it.
        turn: how far it really turned, likewise.
        settings: the settings that correct it, with their values now; empty if it has none.
        better: the corrected values of those that are noticeably wrong.
    """

    counted_way: Ratio | None
    counted_turn: Ratio | None
    way: Ratio | None
    turn: Ratio | None
    settings: dict[str, float]
    better: dict[str, float]


def drift(prediction: Prediction) -> Drift:
    """Find out how much too far a real robot drives and turns."""
    legs = [*_legs(prediction)]
    counted_way = _ratio(_ways(prediction, legs), "odometry", LEAST_WAY)
    counted_turn = _ratio(_turns(prediction, prediction.real, legs), "odometry", LEAST_TURN)
    calibrated = prediction.recorded.robot.get("calibration")
    if not calibrated:
        # Its report is its true way, as far as it knows: none of our settings is in it.
        turn = _ratio(_turns(prediction, prediction.headings, legs), "gyroscope", LEAST_TURN)
        return Drift(counted_way, counted_turn, counted_way, turn or counted_turn, {}, {})
    way = _approach(prediction, legs)
    turn = _ratio(_turns_beyond_wheels(prediction, legs), "gyroscope", LEAST_TURN)
    sizes: dict[str, float] = calibrated["sizes"]
    calibration = Calibration(calibrated["distance"], calibrated["angle"])
    return Drift(
        counted_way, counted_turn, way, turn, sizes, _better(calibration, sizes, way, turn)
    )


def _better(
    calibration: Calibration, sizes: dict[str, float], way: Ratio | None, turn: Ratio | None
) -> dict[str, float]:
    if not any(ratio and ratio.is_noticeable for ratio in (way, turn)):
        return {}
    drove, turned = (ratio.ratio if ratio else 1.0 for ratio in (way, turn))
    corrected = calibration.corrected_sizes(sizes, DISTANCE * drove, ANGLE * turned)
    return {
        name: size for name, size in corrected.items() if abs(size / sizes[name] - 1) >= NOTICEABLE
    }


def _legs(prediction: Prediction) -> Iterator[tuple[float, float]]:
    """The times between two commands to the wheels."""
    lines: Sequence[dict[str, Any]] = prediction.recorded.lines
    starts = [line["t"] for line in lines if line.get("device") == "Base"]
    if starts:
        yield from zip(starts, [*starts[1:], prediction.twin.times[-1]], strict=True)


def _ways(prediction: Prediction, legs: list[tuple[float, float]]) -> Iterator[tuple[float, float]]:
    """For each leg, how far the robot and its twin drove."""
    delay = prediction.delay
    if prediction.real.times:
        for first, last in legs:
            real = prediction.real.travel(first + delay, last + delay)
            yield real, prediction.twin.travel(first, last)


def _turns(
    prediction: Prediction, way: Way, legs: list[tuple[float, float]]
) -> Iterator[tuple[float, float]]:
    """For each leg, how far the robot turned by one of its senses, and how far its twin."""
    delay = prediction.delay
    if way.times:
        for first, last in legs:
            yield way.turn(first + delay, last + delay), prediction.twin.turn(first, last)


def _turns_beyond_wheels(
    prediction: Prediction, legs: list[tuple[float, float]]
) -> Iterator[tuple[float, float]]:
    """For each leg, how far the robot turned by its gyroscope, and how far by its wheels."""
    delay, real, headings = prediction.delay, prediction.real, prediction.headings
    if real.times and headings.times:
        for first, last in legs:
            times = first + delay, last + delay
            yield headings.turn(*times), real.turn(*times)


def _ratio(legs: Iterator[tuple[float, float]], sensor: str, least: float) -> Ratio | None:
    """The ratio of both sums, to which a leg backward adds like one forward."""
    real_sum = reference_sum = sign = 0.0
    for real, reference in legs:
        if abs(reference) >= _STILL:
            sign = 1.0 if reference > 0 else -1.0
        # While its twin stands, the robot may still end what it did before.
        real_sum += sign * real
        reference_sum += sign * reference
    return (
        Ratio(round(real_sum / reference_sum, 4), sensor, round(reference_sum, 1))
        if reference_sum >= least
        else None
    )


def _approach(prediction: Prediction, legs: list[tuple[float, float]]) -> Ratio | None:
    """How far the robot drove by its distance sensor, of what its wheels counted.

    It is measured where the twin drives straight towards something, or away from it.
    """
    pairs: list[tuple[float, float]] = []
    travelled = 0.0
    for first, last in legs:
        travel = prediction.twin.travel(first, last)
        if abs(travel) < _APPROACH or abs(prediction.twin.turn(first, last)) > _STRAIGHT:
            continue
        if _is_square(_seen(prediction, first, last), travel):
            pairs += _centred([*_closer(prediction, first, last)])
            travelled += abs(travel)
    ratio = _slope(pairs)
    return None if ratio is None else Ratio(round(ratio, 4), "distance", round(travelled, 1))


def _centred(pairs: list[tuple[float, float]]) -> Iterator[tuple[float, float]]:
    """Pairs whose means are 0."""
    means = [sum(values) / len(pairs) for values in zip(*pairs, strict=True)]
    return ((distance - means[0], way - means[1]) for distance, way in pairs)


def _slope(pairs: list[tuple[float, float]]) -> float | None:
    """How much closer something came, of what was driven; None if the readings are too noisy."""
    squares = sum(way**2 for _, way in pairs)
    if not squares:
        return None
    slope = -sum(distance * way for distance, way in pairs) / squares
    noise = sum((distance + slope * way) ** 2 for distance, way in pairs) / len(pairs)
    return slope if math.sqrt(noise / squares) < _SURE else None


def _closer(prediction: Prediction, first: float, last: float) -> Iterator[tuple[float, float]]:
    """The distance in front of the robot, and how far its wheels had rolled by then."""
    for time, real, _ in prediction.distances:
        if first <= time - prediction.delay <= last:
            yield real, prediction.real.travel(first + prediction.delay, time)


def _seen(prediction: Prediction, first: float, last: float) -> list[tuple[float, float]]:
    """The distances in front of both between two times of the twin."""
    return [
        (real, twin)
        for time, real, twin in prediction.distances
        if first <= time - prediction.delay <= last
    ]


def _is_square(readings: list[tuple[float, float]], travel: float) -> bool:
    """Whether both drive straight towards the same thing, or away from it."""
    if len(readings) < _LEAST_READINGS:
        return False
    (real, twin), (last_real, last_twin) = readings[0], readings[-1]
    closer, really = twin - last_twin, real - last_real
    return abs(closer - travel) < _SQUARELY * abs(travel) and 0.5 < really / closer < 1.5
