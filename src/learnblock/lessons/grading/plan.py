"""The plan of a grading: every piece, in the order of the table, and its key in the journal."""

import hashlib
import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import msgspec

from learnblock.errors import LearnBlockError, WorldError
from learnblock.installation import version
from learnblock.lessons.grading.executing import Piece, packed_lesson
from learnblock.lessons.grading.values import HandedIn, Manner
from learnblock.lessons.opened import OpenLesson
from learnblock.lessons.trying import Attempt, attempts
from learnblock.runtime.limits import Limits
from learnblock.simulator import make_variant

#: The share of a program's pieces that are run again in isolation; at least one of them is.
SAMPLE = 0.05
#: Changes when the results of pieces mean something else.
FORMAT = 3


def last_with_checks(opened: OpenLesson) -> int:
    """The last step of a lesson that has checks.

    Raises:
        LearnBlockError: none has.
    """
    steps = enumerate(opened.lesson.step, start=1)
    numbers = [number for number, step in steps if step.check]
    if not numbers:
        raise LearnBlockError("grade-no-checks", lesson=opened.name)
    return numbers[-1]


def planned(
    opened: OpenLesson,
    step: int,
    handed_in: Iterable[HandedIn],
    *,
    robots: Sequence[str] | None = None,
    variants: int | None = None,
) -> "Plan":
    """The plan of a grading by this LearnBlock.

    Args:
        opened: the lesson.
        step: the number of the step.
        handed_in: what was handed in, in the order of the table.
        robots: what each program is tried on; None for the step's.
        variants: how many variants of the world; None for as many as the step says.
    """
    wanted = attempts(opened, step, robots=robots, variants=variants)
    tried = graded_attempts(opened, step, wanted)
    return Plan(opened, step, tuple(handed_in), tried, version())


def graded_attempts(
    opened: OpenLesson, step: int, attempts: Sequence[Attempt]
) -> tuple[Attempt, ...]:
    """The attempts of a grading: where a world has no variants, with other noise instead."""
    if _varies(opened, step):
        return tuple(attempts)
    return tuple(Attempt(attempt.robot, 0, seed=attempt.variant) for attempt in attempts)


def _varies(opened: OpenLesson, step: int) -> bool:
    world = opened.described_world(step)
    if world is None:
        return False
    try:
        make_variant(world, 1)
    except WorldError:
        return False
    return True


@dataclass(frozen=True)
class Plan:
    """A grading: what was handed in, and what each of it is tried in.

    Args:
        opened: the lesson.
        step: the number of the step.
        handed_in: what was handed in, in the order of the table.
        attempts: what each program is tried in.
        version: of LearnBlock.
        limits: the resources that each program may use.
    """

    opened: OpenLesson
    step: int
    handed_in: tuple[HandedIn, ...]
    attempts: tuple[Attempt, ...]
    version: str
    limits: Limits = Limits()  # noqa: RUF009 - it is frozen

    @cached_property
    def lesson(self) -> bytes:
        """The lesson, as every piece gets it."""
        return packed_lesson(self.opened, self.step)

    def pieces(self, handed_in: HandedIn) -> Iterator[tuple[str, Piece]]:
        """The pieces of a program, each with its key."""
        plain = [self._piece(handed_in, attempt, "shared") for attempt in self.attempts]
        compared = self._sample([self.key(piece) for piece in plain])
        for index, piece in enumerate(plain):
            chosen = replace(piece, manner="compared") if index in compared else piece
            yield self.key(chosen), chosen

    def isolated(self, handed_in: HandedIn) -> Iterator[tuple[str, Piece]]:
        """The pieces of a program that can't be trusted to share a process."""
        for attempt in self.attempts:
            piece = self._piece(handed_in, attempt, "isolated")
            yield self.key(piece), piece

    def key(self, piece: Piece) -> str:
        """What identifies a piece and its result; the pupil's name is no part of it."""
        rest = replace(piece, lesson=self._lesson_hash)
        return hashlib.sha256(msgspec.msgpack.encode((FORMAT, rest))).hexdigest()[:32]

    @cached_property
    def _lesson_hash(self) -> bytes:
        return hashlib.sha256(self.lesson).digest()

    def _sample(self, keys: Sequence[str]) -> frozenset[int]:
        """Which pieces are run again in isolation: it looks random, but is always the same."""
        count = max(1, math.ceil(SAMPLE * len(keys)))
        return frozenset(sorted(range(len(keys)), key=keys.__getitem__)[:count])

    def _piece(self, handed_in: HandedIn, attempt: Attempt, manner: Manner) -> Piece:
        return Piece(
            version=self.version,
            lesson=self.lesson,
            step=self.step,
            text=handed_in.text,
            is_python=handed_in.is_python,
            tags=tuple(sorted(handed_in.tags.items())),
            attempt=attempt,
            usual=self.attempts[0].robot,
            manner=manner,
            limits=self.limits,
        )
