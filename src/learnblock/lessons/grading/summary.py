"""What a grading says of each pupil in one line, and of the class in a few figures."""

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum

from learnblock.lessons.checks import Check
from learnblock.lessons.grading.grading import Grading
from learnblock.lessons.grading.table import stars
from learnblock.lessons.grading.values import HandedIn, HintResult, Result, Texts


class StepOutcome(StrEnum):
    """How a pupil did, in the order in which a teacher looks."""

    MISSED = "missed"
    DONE = "done"
    ABSENT = "absent"


@dataclass(frozen=True, slots=True)
class Summary:
    """A pupil's results.

    Args:
        outcome: whether the step is done in every attempt.
        met: in how many attempts each check was met.
        finished: how many attempts are finished.
        done: in how many the step is done.
        failing: the checks that are not met in all of them.
        hint: the hint that comes first most often; None if there is none.
        refused: why it was not run.
    """

    outcome: StepOutcome
    met: tuple[int, ...]
    finished: int
    done: int
    failing: tuple[int, ...]
    hint: HintResult | None
    refused: Texts


def summary_of(grading: Grading, handed_in: HandedIn, checks: Sequence[Check]) -> Summary:
    """Sum up what is known so far of a program."""
    rows = [*grading.rows_of(handed_in)]
    results = [row.result for row in rows if row.result]
    places = range(len(checks))
    if handed_in.absence:
        reason = results[0].reason if results else {}
        return Summary(StepOutcome.ABSENT, (0,) * len(places), 0, 0, (), None, reason)
    met = tuple(sum(_is_met(result, place) for result in results) for place in places)
    done = sum(stars(checks, result) > 0 for result in results)
    refusals = (result.reason for result in results if not result.checks and result.reason)
    return Summary(
        outcome=StepOutcome.DONE if rows and done == len(rows) else StepOutcome.MISSED,
        met=met,
        finished=len(results),
        done=done,
        failing=tuple(place for place in places if met[place] < len(results)),
        hint=_first_hint(results),
        refused=next(refusals, {}),
    )


def most_missed(summaries: Sequence[Summary]) -> tuple[int, int] | None:
    """The check that most programs miss, and how many do; None if none is missed."""
    counts = Counter(place for summary in summaries for place in summary.failing)
    return max(counts.items(), key=lambda pair: (pair[1], -pair[0]), default=None)


def _first_hint(results: Sequence[Result]) -> HintResult | None:
    firsts = [result.hints[0] for result in results if result.hints]
    counts = Counter(hint.rule for hint in firsts)
    often = max(counts, key=lambda rule: (counts[rule], rule), default=None)
    return next((hint for hint in firsts if hint.rule == often), None)


def _is_met(result: Result, place: int) -> bool:
    return place < len(result.checks) and result.checks[place].state == "met"
