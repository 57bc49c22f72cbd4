"""Options of a simulated run, from arguments, environment or defaults."""

import math
import os
from collections.abc import Sequence

from learnblock.devices import Pose
from learnblock.errors import DeviceValueError


def pace_factor(pace: str | float) -> float | None:
    """Convert a pace: ``free`` to None, ``real`` to 1, and a positive number to itself.

    Raises:
        DeviceValueError: it is anything else.
    """
    if pace == "free":
        return None
    if pace == "real":
        return 1.0
    try:
        factor = float(pace)
    except ValueError:
        factor = 0.0
    if not 0 < factor < float("inf"):
        raise DeviceValueError("world-bad-pace", pace=str(pace))
    return factor


def chosen_pace(pace: str | float | None) -> float | None:
    return pace_factor(os.environ.get("LEARNBLOCK_PACE") or "free" if pace is None else pace)


def chosen_seed(seed: int | None) -> int:
    value = os.environ.get("LEARNBLOCK_SEED") or 0 if seed is None else seed
    try:
        return int(value)
    except ValueError:
        raise DeviceValueError("world-bad-seed", seed=str(value)) from None


def chosen_variant(variant: int | None) -> int:
    value = os.environ.get("LEARNBLOCK_VARIANT") or 0 if variant is None else variant
    try:
        number = int(value)
    except ValueError:
        number = -1
    if number < 0:
        raise DeviceValueError("world-bad-variant", variant=str(value))
    return number


def chosen_start(start: Sequence[float] | None) -> Pose | None:
    if start is None:
        return None
    try:
        x, y, heading = (float(value) for value in start)
    except (TypeError, ValueError):
        raise DeviceValueError("world-bad-start", start=str(start)) from None
    if not all(map(math.isfinite, (x, y, heading))):
        raise DeviceValueError("world-bad-start", start=str(start))
    return x, y, heading
