"""Types for the parameters of custom skills: each gives the block a suitable field.

    from typing import Annotated, Literal

    from learnblock.fields import Angle, Colour, Range, TagName


    def paint(
        robot,
        speed: Annotated[float, Range(0, 100)] = 50,
        brush: Literal["thin", "thick"] = "thin",
        colour: Colour = "#ff8800",
        direction: Angle = 90,
        stop_at: TagName = "ball",
    ) -> None: ...

The block then has a slider, a list of choices, a colour, a dial and the tag names as its
fields. Python and type checkers treat the values as plain numbers and strings.
"""

from dataclasses import dataclass

#: A string such as ``#ff8800``: two digits from 0 to f each for red, green and blue.
Colour = str
#: Degrees, clockwise positive.
Angle = float
#: A tag by its number or its name.
TagName = int | str


@dataclass(frozen=True, slots=True)
class Range:
    """The range of a number, in ``Annotated[float, Range(0, 100)]``.

    Args:
        least: the smallest value.
        most: the largest value.
        step: from one value to the next; None allows any number in the range.
    """

    least: float
    most: float
    step: float | None = None

    def holds(self, value: float) -> bool:
        """Whether a number is in the range."""
        return self.least <= value <= self.most

    def __str__(self) -> str:
        return f"{self.least:g} to {self.most:g}"
