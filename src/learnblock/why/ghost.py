"""Reports where a real robot left its twin's way, and what that means for its settings."""

from collections.abc import Iterator
from dataclasses import dataclass

from learnblock.i18n import Phrase
from learnblock.why.drift import Drift, Ratio
from learnblock.why.prediction import EMPTY, Prediction

#: A sensor is wrong if it differs by this many mm, and by this share of the correct distance.
_WRONG, _WRONG_PART = 50.0, 0.15
#: This many readings in a row must differ: a thing may be seen a moment earlier or later.
_IN_A_ROW = 5


@dataclass(frozen=True, slots=True)
class TwinFact:
    """One fact about a real robot and its twin.

    Args:
        phrase: the fact in words.
        time: when that was, in s; None for the whole run.
    """

    phrase: Phrase
    time: float | None = None


def findings(prediction: Prediction, drift: Drift) -> tuple[TwinFact, ...]:
    """The results of comparing a real robot with its twin, most important first."""
    return (*_parting(prediction), *_drift(drift), *_sensor(prediction, drift))


def unrecorded(prediction: Prediction, drift: Drift) -> tuple[Phrase, ...]:
    """The data missing from the log, which can't be compared."""
    return tuple(_unrecorded(prediction, drift))


def _parting(prediction: Prediction) -> Iterator[TwinFact]:
    if not prediction.real.times:
        return
    parting = prediction.parting
    if parting is None:
        yield TwinFact(Phrase("twin-together"))
        return
    time = round(parting.time, 1)
    x, y, _ = parting.pose
    if parting.distance >= abs(parting.angle):
        phrase = Phrase(
            "twin-parted", time=time, distance=round(parting.distance), x=round(x), y=round(y)
        )
    else:
        side = "right" if parting.angle > 0 else "left"
        phrase = Phrase("twin-askew", time=time, angle=round(abs(parting.angle)), side=side)
    yield TwinFact(phrase, parting.time)


def _drift(drift: Drift) -> Iterator[TwinFact]:
    if drift.settings:
        yield from _disobedience(drift)
    for code, ratio in (("twin-drives", drift.way), ("twin-turns", drift.turn)):
        if ratio and ratio.is_noticeable:
            yield TwinFact(_phrase(code, ratio, sensor=ratio.sensor))
    for setting, value in drift.better.items():
        if value != drift.settings[setting]:
            now = drift.settings[setting]
            yield TwinFact(Phrase("twin-set", setting=setting, value=str(value), now=str(now)))
    if not drift.settings and any(
        ratio and ratio.is_noticeable for ratio in (drift.way, drift.turn)
    ):
        yield TwinFact(Phrase("twin-no-setting"))


def _disobedience(drift: Drift) -> Iterator[TwinFact]:
    """The wheels count their own turns: if these differ, no size of a wheel is the reason."""
    counted = (drift.counted_way, drift.counted_turn)
    different = [ratio for ratio in counted if ratio and ratio.is_noticeable]
    if different:
        yield TwinFact(_phrase("twin-wheels", max(different, key=lambda ratio: abs(ratio.percent))))


def _phrase(code: str, ratio: Ratio, **more: str) -> Phrase:
    much = "more" if ratio.percent > 0 else "less"
    return Phrase(code, percent=f"{abs(ratio.percent):g}", much=much, **more)


def _sensor(prediction: Prediction, drift: Drift) -> Iterator[TwinFact]:
    """A sensor with a different reading while the robot was at the right place."""
    if prediction.parting or drift.better or prediction.world == EMPTY:
        return
    row: list[tuple[float, float, float]] = []
    for reading in prediction.distances:
        _, real, twin = reading
        row = [*row, reading] if abs(real - twin) > max(_WRONG, _WRONG_PART * twin) else []
        if len(row) == _IN_A_ROW:
            time, real, twin = row[0]
            values = {"time": round(time, 1), "real": round(real), "twin": round(twin)}
            yield TwinFact(Phrase("twin-sensor", **values), time)
            return


def _unrecorded(prediction: Prediction, drift: Drift) -> Iterator[Phrase]:
    if not prediction.real.times:
        yield Phrase("twin-no-odometry")
    elif drift.settings and not drift.way:
        yield Phrase("twin-way-not-measured")
    if drift.settings and not drift.turn:
        yield Phrase("twin-turn-not-measured")
    if prediction.world == EMPTY:
        yield Phrase("twin-empty-floor")
