"""The table of a grading as CSV: the same bytes wherever it was made."""

import csv
from collections.abc import Iterable, Sequence
from typing import TextIO

from learnblock.lessons.checks import Check
from learnblock.lessons.grading.grading import Row
from learnblock.lessons.grading.values import Result

_BEFORE = ("pupil", "step", "robot", "variant", "seed")
_AFTER = ("stars", "ended", "seconds", "trace_sha256", "checked")
#: A text that begins with one of these is a formula to spreadsheets.
_FORMULA = ("=", "+", "-", "@", "\t", "\r")


def write_table(file: TextIO, step: int, checks: Sequence[Check], rows: Iterable[Row]) -> None:
    """Write the table.

    Args:
        file: where to; its line ends are not translated.
        step: the number of the step.
        checks: the checks of the step.
        rows: the rows, in their order.
    """
    writer = csv.writer(file, lineterminator="\n")
    writer.writerow([*_BEFORE, *map(harmless, check_names(checks)), *_AFTER])
    for row in rows:
        attempt = row.attempt
        before = (row.handed_in.pupil, step, attempt.robot, attempt.variant, attempt.seed)
        cells = [*before, *_cells(row, checks)]
        writer.writerow([harmless(cell) if isinstance(cell, str) else cell for cell in cells])


def check_names(checks: Sequence[Check]) -> list[str]:
    """The headings of checks: each with its number, and its name or kind."""
    return [
        f"{number} {check.name or check.__struct_config__.tag}"
        for number, check in enumerate(checks, start=1)
    ]


def stars(checks: Sequence[Check], result: Result) -> int:
    """One star for a step that is done, and one for each optional check that is met, too."""
    met = [check.state == "met" for check in result.checks]
    if len(met) < len(checks) or not checks:
        return 0
    required = [is_met for is_met, check in zip(met, checks, strict=True) if not check.optional]
    extra = [is_met for is_met, check in zip(met, checks, strict=True) if check.optional]
    return (1 + sum(extra)) if all(required) else 0


def harmless(text: str) -> str:
    """A text that no spreadsheet takes for a formula."""
    return f"'{text}" if text.startswith(_FORMULA) else text


def _cells(row: Row, checks: Sequence[Check]) -> list[str | int]:
    result = row.result
    if result is None:
        return [*[""] * len(checks), "", "not run" if row.failure else "not finished", "", "", ""]
    if row.handed_in.absence:
        return [*[""] * len(checks), "", row.handed_in.absence, "", "", ""]
    states = [check.state for check in result.checks] or ["failed"] * len(checks)
    seconds = f"{result.seconds:.3f}"
    return [
        *states,
        stars(checks, result),
        result.ended,
        seconds,
        result.trace_sha256,
        result.checked,
    ]
