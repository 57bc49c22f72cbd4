"""What the parameters of a skill accept, for the hints of a file of one's own.

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

The block then has a field for each: a slider, choices, a colour, a dial, the names of tags. To
Python, and to whoever checks its types, they are plain numbers and texts.
"""

from dataclasses import dataclass

#: A text such as ``#ff8800``: two digits from 0 to f each for red, green and blue.
Colour = str
#: Degrees, clockwise positive.
Angle = float
#: A tag by its number, or by its name in the dictionary of tags.
TagName = int | str


@dataclass(frozen=True, slots=True)
class Range:
    """From where to where a number goes, in ``Annotated[float, Range(0, 100)]``.

    Args:
        least: the smallest.
        most: the largest.
        step: from one to the next; None for any number between them.
    """

    least: float
    most: float
    step: float | None = None

    def holds(self, value: float) -> bool:
        """Whether a number is one of them."""
        return self.least <= value <= self.most

    def __str__(self) -> str:
        return f"{self.least:g} to {self.most:g}"
