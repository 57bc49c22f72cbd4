"""Limits for the ranges and choices of parameters."""

import math
from typing import TypeGuard

from learnblock.fields import Range
from learnblock.i18n import Phrase

MOST_CHOICES = 100
LONGEST_CHOICE = 100


def range_problem(bounds: Range) -> Phrase | None:
    """The mistake in a range, or None if there is none."""
    numbers = [bounds.least, bounds.most, 1 if bounds.step is None else bounds.step]
    if not all(math.isfinite(number) and abs(number) <= 1e15 for number in numbers):
        return Phrase("block-range-ends")
    if not bounds.least < bounds.most:
        return Phrase("block-range-order")
    if bounds.step is not None and not 0 < bounds.step <= bounds.most - bounds.least:
        return Phrase("block-range-step")
    return None


def is_choice(value: object) -> TypeGuard[str]:
    """Whether a value can be a choice: a short string on one line."""
    return isinstance(value, str) and value.isprintable() and 0 < len(value) <= LONGEST_CHOICE
