"""What readings look like: how the page shows them, and which a sensor may give.

Each type of sensor has one of these as its `form`. From it are derived the page's values and plots,
the readings of a fake robot, and the checks of a new robot's driver.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any, ClassVar

#: A single value of a reading; None if nothing is measured.
Value = float | bool | None
#: Its place, such as a side, its number among those of the same place (0 for the only one), and it.
Single = tuple[str, int, Value]


def is_number(value: object, least: float = -math.inf, most: float = math.inf) -> bool:
    """Whether a value is a finite number from `least` to `most`."""
    return (
        isinstance(value, int | float)
        and not isinstance(value, bool)
        and math.isfinite(value)
        and least <= value <= most
    )


@dataclass(frozen=True, slots=True)
class Form:
    """A reading that is a single number.

    Args:
        lowest: the smallest usual value.
        highest: the largest usual value.
        unit: the unit of its values, such as ``mm``; empty if they have none.
        digits: the decimals that are shown.
        is_limited: whether no value is outside `lowest` to `highest`.
        quiet: the reading of a robot on which nothing acts; None if it depends on what the robot
            does.
    """

    #: The type of a reading, as Python writes it.
    annotation: ClassVar[str] = "float"

    lowest: float
    highest: float
    unit: str = ""
    digits: int = 0
    is_limited: bool = field(default=True, kw_only=True)
    quiet: Any = field(default=None, kw_only=True)

    def singles(self, reading: Any) -> Iterator[Single]:
        """The single values of a reading."""
        yield "", 0, reading

    def fits(self, reading: Any) -> bool:
        """Whether a reading has this form; for one of another type it may raise an error."""
        return self._is_value(reading)

    def _is_value(self, value: object) -> bool:
        limits = (self.lowest, self.highest) if self.is_limited else ()
        return is_number(value, *limits)


@dataclass(frozen=True, slots=True)
class YesOrNo(Form):
    """A reading that is True or False."""

    annotation = "bool"

    lowest: float = 0
    highest: float = 1
    digits: int = 1

    def fits(self, reading: Any) -> bool:
        return isinstance(reading, bool)


@dataclass(frozen=True, slots=True)
class CodeOrNone(Form):
    """A reading that is a whole number, or None before the first one."""

    annotation = "int | None"

    def fits(self, reading: Any) -> bool:
        return reading is None or isinstance(reading, int)


@dataclass(frozen=True, slots=True)
class ByPlace(Form):
    """A reading with a number for each of some places, None for a place without a sensor.

    Args:
        places: all places that there can be.
    """

    annotation = "dict[str, float | None]"

    places: tuple[str, ...] = field(default=(), kw_only=True)

    def singles(self, reading: Any) -> Iterator[Single]:
        return ((place, 0, value) for place, value in reading.items() if value is not None)

    def fits(self, reading: Any) -> bool:
        return set(reading) <= set(self.places) and all(
            value is None or self._is_value(value) for value in reading.values()
        )


@dataclass(frozen=True, slots=True)
class Buttons(ByPlace):
    """A reading with True or False for each button."""

    annotation = "dict[str, bool]"

    lowest: float = 0
    highest: float = 1
    digits: int = 1

    def fits(self, reading: Any) -> bool:
        return all(isinstance(value, bool) for value in reading.values())


@dataclass(frozen=True, slots=True)
class SeveralByPlace(ByPlace):
    """A reading with a list of numbers for each of some places."""

    annotation = "dict[str, list[float]]"

    def singles(self, reading: Any) -> Iterator[Single]:
        for place, values in reading.items():
            for number, value in enumerate(values, start=1):
                yield place, number, value

    def fits(self, reading: Any) -> bool:
        return set(reading) <= set(self.places) and all(
            self._is_value(value) for values in reading.values() for value in values
        )


@dataclass(frozen=True, slots=True)
class Axes(ByPlace):
    """A reading with a number for each of its places, in their order."""

    annotation = "tuple[float, ...]"

    def singles(self, reading: Any) -> Iterator[Single]:
        return ((place, 0, value) for place, value in zip(self.places, reading, strict=True))

    def fits(self, reading: Any) -> bool:
        return len(reading) == len(self.places) and all(map(self._is_value, reading))
