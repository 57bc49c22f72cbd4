"""A grading: makes what is missing of its plan, wherever there are workers, and keeps it."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, CancelledError, Future, wait
from dataclasses import dataclass, replace
from itertools import islice

import msgspec

from learnblock.errors import LearnBlockError
from learnblock.i18n import Phrase, in_each_language
from learnblock.lessons.expert import NoVerdictError
from learnblock.lessons.grading.executing import (
    ABOUT_OTHERS,
    MOST_HINTS,
    NotRunError,
    Piece,
    run_piece,
)
from learnblock.lessons.grading.executors import TRIES, OpenWorkers, Workers
from learnblock.lessons.grading.journal import Journal
from learnblock.lessons.grading.plan import Plan
from learnblock.lessons.grading.values import DIFFERS, HandedIn, Result, unpacked
from learnblock.lessons.trying import Attempt

#: Seconds between two looks at whether the grading is to be stopped.
WATCHING = 0.2
#: How it shows that workers are gone.
_LOST = (BrokenExecutor, CancelledError)


@dataclass(frozen=True, slots=True)
class Row:
    """A row of the table.

    Args:
        handed_in: what was handed in.
        attempt: what it was tried in.
        result: what came out; None if there is none.
        failure: why it could not be made, which is not the program's fault; None if it is not
            finished.
    """

    handed_in: HandedIn
    attempt: Attempt
    result: Result | None
    failure: Phrase | None = None


@dataclass(frozen=True, slots=True)
class Progress:
    """How far a grading is.

    Args:
        done: the pieces that are finished.
        total: all pieces.
    """

    done: int
    total: int


class Grading:
    """A grading of what was handed in.

    Args:
        plan: what is to be made.
        journal: what is finished.
    """

    def __init__(self, plan: Plan, journal: Journal) -> None:
        self.plan = plan
        self._journal = journal
        self._is_stopped = False
        self._done = self._total = 0
        #: What went wrong with pieces, by key: they are made again by the next grading.
        self._failures: dict[str, Phrase] = {}

    @property
    def is_stopped(self) -> bool:
        """Whether it was stopped before its end."""
        return self._is_stopped

    @property
    def failures(self) -> Sequence[Phrase]:
        """Why pieces could not be made."""
        return [*self._failures.values()]

    def stop(self) -> None:
        """Finish the pieces that are being made, and no further ones."""
        self._is_stopped = True

    def run(self, opened: OpenWorkers) -> Iterator[Progress]:
        """Make what is missing; yield how far it is after every finished piece.

        Args:
            opened: opens the workers, once more if they are lost.

        Raises:
            LearnBlockError: there are no workers, or they are lost again and again.
        """
        yield from self._make(self._planned(), opened)
        yield from self._make(self._doubtful(), opened)

    def rows(self) -> Iterator[Row]:
        """The rows of the table, in the order of the plan."""
        for handed_in in self.plan.handed_in:
            yield from self.rows_of(handed_in)

    def rows_of(self, handed_in: HandedIn) -> Iterator[Row]:
        """The rows of one pupil."""
        rows = [*self._rows_of(handed_in)]
        passes = bool(rows) and self._passes(rows[0].result)
        for row in rows:
            yield row if row.result is None else replace(row, result=_fitting(row.result, passes))

    def _rows_of(self, handed_in: HandedIn) -> Iterator[Row]:
        """The rows of one pupil, with all hints that may fit."""
        if handed_in.reason is not None:
            untried = Result(
                ended=handed_in.absence or "unreadable", reason=in_each_language(handed_in.reason)
            )
            yield from (Row(handed_in, attempt, untried) for attempt in self.plan.attempts)
            return
        shared = self._found(self.plan.pieces(handed_in))
        # One that was compared was isolated, too, and says that it differed.
        apart = (
            self._found(self.plan.isolated(handed_in)) if self._is_doubtful(handed_in) else shared
        )
        for attempt, first, second in zip(self.plan.attempts, shared, apart, strict=True):
            result, failure = first if _differs(first[0]) else second
            yield Row(handed_in, attempt, result, failure)

    def _passes(self, result: Result | None) -> bool:
        """Whether a run meets all checks that are not optional."""
        checks = self.plan.opened.step(self.plan.step).check
        if result is None or len(result.checks) != len(checks):
            return False
        pairs = zip(checks, result.checks, strict=True)
        return all(outcome.state == "met" or check.optional for check, outcome in pairs)

    def _make(self, keyed: Iterable[tuple[str, Piece]], opened: OpenWorkers) -> Iterator[Progress]:
        missing = {key: piece for key, piece in keyed if key not in self._journal}
        self._total += len(missing)
        for _ in range(TRIES):
            if self._is_stopped or not missing:
                return
            try:
                with opened() as workers:
                    yield from self._made_by(workers, missing)
            except _LOST:
                missing = {key: piece for key, piece in missing.items() if key not in self._journal}
            else:
                return
        raise LearnBlockError("grade-workers-lost")

    def _made_by(self, workers: Workers, missing: Mapping[str, Piece]) -> Iterator[Progress]:
        ahead = iter(missing.items())
        making: dict[Future[bytes], str] = {}
        while True:
            free = 0 if self._is_stopped else workers.most - len(making)
            for key, piece in islice(ahead, free):
                making[workers.executor.submit(run_piece, piece)] = key
            if not making:
                return
            for future in wait(making, WATCHING, FIRST_COMPLETED).done:
                self._keep(making.pop(future), future)
                yield Progress(self._done, self._total)
            if self._is_stopped:
                making = {future: key for future, key in making.items() if not future.cancel()}

    def _keep(self, key: str, future: Future[bytes]) -> None:
        try:
            self._journal.add(key, future.result())
        except (NotRunError, NoVerdictError) as error:
            self._failures[key] = error.phrase
        except (*_LOST, LearnBlockError):
            raise
        except Exception as error:  # noqa: BLE001 - a mistake of ours must not end the others
            self._failures[key] = Phrase(f"{type(error).__name__}: {error}")
        self._done += 1

    def _planned(self) -> Iterator[tuple[str, Piece]]:
        for handed_in in self._readable():
            # Those that are compared come last: after all others, in the same process.
            pieces = self.plan.pieces(handed_in)
            yield from sorted(pieces, key=lambda keyed: keyed[1].manner == "compared")

    def _doubtful(self) -> Iterator[tuple[str, Piece]]:
        """The pieces of programs whose shared runs differed from isolated ones."""
        for handed_in in self._readable():
            if self._is_doubtful(handed_in):
                yield from self.plan.isolated(handed_in)

    def _readable(self) -> Iterator[HandedIn]:
        return (handed_in for handed_in in self.plan.handed_in if handed_in.reason is None)

    def _is_doubtful(self, handed_in: HandedIn) -> bool:
        keyed = self.plan.pieces(handed_in)
        compared = (key for key, piece in keyed if piece.manner == "compared")
        return any(_differs(self._result(key)) for key in compared)

    def _found(
        self, keyed: Iterable[tuple[str, Piece]]
    ) -> list[tuple[Result | None, Phrase | None]]:
        """The results of pieces, or why they could not be made."""
        return [(self._result(key), self._failures.get(key)) for key, _ in keyed]

    def _result(self, key: str) -> Result | None:
        data = self._journal.result(key)
        return None if data is None else unpacked(data)


def _fitting(result: Result, passes_usually: bool) -> Result:  # noqa: FBT001 - one of two values
    """A result with the hints that fit: some only for programs that pass in the first attempt."""
    if not result.hints:
        return result
    fitting = [hint for hint in result.hints if passes_usually or hint.rule not in ABOUT_OTHERS]
    return msgspec.structs.replace(result, hints=tuple(fitting[:MOST_HINTS]))


def _differs(result: Result | None) -> bool:
    return result is not None and result.checked == DIFFERS
