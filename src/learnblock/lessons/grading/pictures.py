"""Pictures of the ways driven: each world is drawn once, and the ways over it."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from learnblock.errors import WorldError
from learnblock.lessons.grading.html import tag
from learnblock.lessons.trying import Attempt
from learnblock.simulator import WorldDescription, make_variant
from learnblock.simulator.picture import plan
from learnblock.simulator.picture.svg import element
from learnblock.simulator.picture.view import HEADER, MARGIN, PictureView, fitted

#: Pixels of a picture on the page.
WIDTH = 300


@dataclass(frozen=True)
class Pictures:
    """Pictures of the ways driven in a world and its variants.

    Args:
        world: the world as it is drawn.
        variants: the variants in which programs were tried.
    """

    world: WorldDescription
    variants: tuple[int, ...]

    @cached_property
    def view(self) -> PictureView:
        """The same for all variants: the whole floor."""
        return fitted(self.world.floor.size, np.empty((0, 2)), bar=False)

    def worlds(self) -> str:
        """The worlds, which the pictures use."""
        symbols = (
            tag(
                "symbol",
                *map(element, plan.drawn(world, self.view)),
                id=_name(variant),
                viewBox=self._box,
            )
            for variant, world in self._varied()
        )
        return tag("svg", *symbols, width=0, height=0, class_="worlds", aria_hidden="true")

    def picture(self, attempt: Attempt, path: Sequence[tuple[int, int]], title: str) -> str:
        """A way in its world, in which it begins at a ring and ends at a dot."""
        points = self.view.all(path)
        width, height = self._size
        world = tag(
            "use",
            href=f"#{_name(attempt.variant)}",
            x=f"{MARGIN:.0f}",
            y=f"{HEADER:.0f}",
            width=f"{width:.0f}",
            height=f"{height:.0f}",
        )
        parts = [tag("title", title), world]
        if points:
            places = " ".join(f"{x:.0f},{y:.0f}" for x, y in points)
            (x, y), (end_x, end_y) = points[0], points[-1]
            parts += [
                tag("polyline", points=places, class_="edge"),
                tag("polyline", points=places, class_="way"),
                tag("circle", cx=round(x), cy=round(y), r=14, class_="start"),
                tag("circle", cx=round(end_x), cy=round(end_y), r=12, class_="end"),
            ]
        scaled = round(WIDTH * height / width)
        return tag("svg", *parts, viewBox=self._box, width=WIDTH, height=scaled, role="img")

    @property
    def _size(self) -> tuple[float, float]:
        return self.view.plot

    @property
    def _box(self) -> str:
        width, height = self._size
        return f"{MARGIN:.0f} {HEADER:.0f} {width:.0f} {height:.0f}"

    def _varied(self) -> Iterator[tuple[int, WorldDescription]]:
        for variant in sorted(set(self.variants)):
            try:
                yield variant, make_variant(self.world, variant) if variant else self.world
            except WorldError:
                yield variant, self.world


def _name(variant: int) -> str:
    return f"world-{variant}"
