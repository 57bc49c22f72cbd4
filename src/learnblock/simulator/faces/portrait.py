"""Draws a face."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from learnblock.simulator.faces.easel import Easel, Point, arc, oval
from learnblock.simulator.faces.expressions import Expression
from learnblock.simulator.faces.people import Person

_CHEEK = (214, 96, 90)


def portrait(expression: Expression, person: Person) -> Easel:
    """The face of a person who shows an expression."""
    painter = _Painter(Easel.blank(person.backdrop), expression.times(person.vigour), person)
    painter.head()
    painter.shading()
    for side in (-1, 1):
        painter.eye(side)
        painter.brow(side)
    painter.nose()
    painter.mouth()
    return painter.easel


@dataclass(frozen=True, slots=True)
class _Painter:
    """Draws the parts of one face; `side` is -1 for left in the picture, 1 for right."""

    easel: Easel
    expression: Expression
    person: Person

    @property
    def _outline(self) -> NDArray[np.float64]:
        return oval((0.5, 0.50), (self.person.width, self.person.height))

    def head(self) -> None:
        easel, person = self.easel, self.person
        easel.ellipse((0.5, 1.12), (0.44, 0.24), person.shirt)
        easel.ellipse((0.5, 0.43), (person.width + 0.05, person.height - 0.005), person.hair)
        easel.polygon(np.array([(0.4, 0.75), (0.6, 0.75), (0.63, 0.95), (0.37, 0.95)]), person.skin)
        easel.ellipse((0.5, 0.87), (0.09, 0.05), person.shadow, opacity=0.6, blur=0.02)
        for side in (-1, 1):
            ear = person.width + 0.01
            easel.ellipse((0.5 + side * ear, 0.53), (0.035, 0.065), person.skin)
            easel.ellipse(
                (0.5 + side * (ear + 0.002), 0.53),
                (0.018, 0.04),
                person.shadow,
                opacity=0.5,
                blur=0.008,
            )
        easel.polygon(self._outline, person.skin)

    def shading(self) -> None:
        """The shading of a face lit from above, which the detector of real faces relies on."""
        easel, person = self.easel, self.person
        relief = Easel(easel.image.copy())
        for side in (-1, 1):
            self._cheek(relief, side)
        relief.ellipse((0.5, 0.28), (0.19, 0.085), person.light, opacity=0.8, blur=0.03)
        relief.ellipse((0.5, 0.80), (0.07, 0.035), person.light, opacity=0.6, blur=0.02)
        easel.inlay(relief, self._outline)
        easel.polygon(self._fringe(), person.hair)
        line = arc((0.26, 0.27), (0.5, 0.215), (0.74, 0.27))
        easel.stroke(line, 0.02, person.shadow, opacity=0.35, blur=0.012)

    def _cheek(self, relief: Easel, side: int) -> None:
        person = self.person
        edge, eyes = person.width - 0.005, person.eyes + 0.005
        shadow, light = person.shadow, person.light
        relief.ellipse((0.5 + side * edge, 0.58), (0.05, 0.24), shadow, opacity=0.45, blur=0.03)
        relief.ellipse((0.5 + side * eyes, 0.445), (0.085, 0.045), shadow, opacity=0.6, blur=0.018)
        relief.ellipse((0.5 + side * 0.15, 0.575), (0.075, 0.05), light, opacity=0.8, blur=0.025)
        blush = 0.6 * self.expression.blush
        relief.ellipse(
            (0.5 + side * 0.165, 0.61), (0.065, 0.045), _CHEEK, opacity=blush, blur=0.025
        )

    def _fringe(self) -> NDArray[np.float64]:
        half = self.person.width + 0.01
        lower = arc((0.5 - half, 0.40), (0.5, 0.195), (0.5 + half, 0.40))
        upper = arc((0.5 + half, 0.30), (0.5, 0.07), (0.5 - half, 0.30))
        return np.vstack([lower, upper])

    def eye(self, side: int) -> None:
        person, easel = self.person, self.easel
        x, y = 0.5 + side * person.eyes, 0.455
        half, height = 0.056 * person.eye_size, 0.026 * person.eye_size * self.expression.eye
        upper = arc((x - half, y), (x, y - height), (x + half, y))
        lower = arc((x + half, y), (x, y + 0.8 * height), (x - half, y))
        white = Easel(easel.image.copy())
        opening = np.vstack([upper, lower])
        white.polygon(opening, (236, 232, 228))
        iris = 0.027 * person.eye_size
        white.ellipse((x, y - 0.002), (iris, iris), (70, 48, 34))
        white.ellipse((x, y - 0.002), (0.013, 0.013), (12, 8, 8))
        glint = 0.3 * min(iris, 1.1 * height)
        white.ellipse((x - 0.008, y - glint - 0.002), (0.006, 0.006), (250, 250, 250))
        white.stroke(upper + np.array([0, 0.006]), 0.012, person.shadow, opacity=0.5, blur=0.005)
        easel.inlay(white, opening)
        easel.stroke(upper, 0.012 * person.line, (40, 24, 20))
        easel.stroke(lower, 0.005 * person.line, person.shadow, opacity=0.8)
        bag = lower + np.array([0, 0.022])
        easel.stroke(bag, 0.006 * person.line, person.shadow, opacity=0.35, blur=0.004)

    def brow(self, side: int) -> None:
        expression, person = self.expression, self.person
        y, middle = 0.385, person.eyes + 0.005
        inner = (0.5 + side * (middle - 0.07), y + 0.8 * expression.brow_inner)
        outer = (0.5 + side * (middle + 0.065), y + 0.015 + 0.8 * expression.brow_outer)
        rise = 0.5 * (inner[1] + outer[1]) - 0.018
        path = arc(inner, (0.5 + side * middle, rise), outer)
        self.easel.stroke(path, person.brow, person.hair, opacity=0.95, blur=0.003)
        if expression.brow_inner > 0:
            frown = np.array([(0.5 + side * 0.018, 0.36), (0.5 + side * 0.022, 0.41)])
            self._fold(frown, 0.008, opacity=0.7, blur=0.003)

    def nose(self) -> None:
        easel, person = self.easel, self.person
        easel.ellipse((0.5, 0.50), (0.018, 0.09), person.light, opacity=0.9, blur=0.01)
        for side in (-1, 1):
            self._nostril(side)
        tip = self._along_nose(0.575)
        easel.ellipse((0.5, tip), (0.025, 0.02), person.light, opacity=0.7, blur=0.008)
        beneath = self._along_nose(0.628)
        easel.ellipse((0.5, beneath), (0.045, 0.008), person.shadow, opacity=0.5, blur=0.008)

    def _along_nose(self, y: float) -> float:
        """The position on this nose of a point on the usual nose."""
        root = 0.45
        return root + self.person.nose * (y - root)

    def _nostril(self, side: int) -> None:
        easel, sneer = self.easel, self.expression.sneer
        bridge = np.array([(0.5 + side * 0.04, 0.43), (0.5 + side * 0.045, 0.56)])
        self._fold(bridge, 0.015, opacity=0.4, blur=0.01)
        middle = self._along_nose(0.607) - 0.5 * sneer
        easel.ellipse((0.5 + side * 0.024, middle), (0.014, 0.008), (70, 34, 28), blur=0.003)
        wing = arc(
            (0.5 + side * 0.045, middle - 0.032),
            (0.5 + side * 0.055, middle - 0.012),
            (0.5 + side * 0.042, middle + 0.005),
        )
        self._fold(wing, 0.008, opacity=0.7, blur=0.003)
        if sneer:
            fold = np.array([(0.5 + side * 0.015, 0.475), (0.5 + side * 0.04, 0.50)])
            self._fold(fold, 0.007, opacity=0.8, blur=0.002)

    def mouth(self) -> None:
        expression, person, easel = self.expression, self.person, self.easel
        y, half, gap = 0.70 + person.chin, expression.mouth_width * person.mouth, expression.gap
        left, right = ((0.5 + side * half, y + expression.corners) for side in (-1, 1))
        over, under = y - 0.5 * gap - expression.sneer, y + 0.5 * gap
        top, bottom = arc(left, (0.5, over), right), arc(right, (0.5, under), left)
        upper_lip = arc(left, (0.5, over - 0.02 * person.lips), right)
        lower_lip = arc(right, (0.5, under + 0.028 * person.lips), left)
        easel.polygon(np.vstack([upper_lip, lower_lip]), person.lip, blur=0.002)
        easel.polygon(np.vstack([top, bottom]), (66, 22, 24))
        if gap > 0.01 and half > 0.08:
            teeth = np.vstack([top, bottom * (1, 0.35) + top[::-1] * (0, 0.65)])
            easel.polygon(teeth, (244, 240, 234))
        easel.stroke(top, 0.008 * person.line, (96, 36, 36))
        easel.ellipse((0.5, under + 0.047), (0.06, 0.01), person.shadow, opacity=0.45, blur=0.01)
        for side in (-1, 1):
            self._corner(side, half, (0.5 + side * (half + 0.005), left[1]))

    def _corner(self, side: int, half: float, corner: Point) -> None:
        """A corner of the mouth, and the fold from the nose down to it."""
        self.easel.ellipse(corner, (0.01, 0.01), self.person.shadow, opacity=0.6, blur=0.006)
        if self.expression.corners < 0 or self.expression.sneer:
            fold = arc(
                (0.5 + side * 0.065, 0.60),
                (0.5 + side * (half + 0.02), 0.65),
                (0.5 + side * (half + 0.03), 0.70),
            )
            self._fold(fold, 0.008, opacity=0.5, blur=0.004)

    def _fold(
        self, path: NDArray[np.float64], width: float, *, opacity: float, blur: float
    ) -> None:
        width *= self.person.line
        self.easel.stroke(path, width, self.person.shadow, opacity=opacity, blur=blur)
