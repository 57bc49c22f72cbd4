"""Parsons puzzles: the pieces of a program, and every order in which they are right."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from learnblock.errors import ProgramError
from learnblock.language import format as format_program
from learnblock.language import parse
from learnblock.lessons.lesson import Puzzle
from learnblock.lessons.opened import OpenLesson

Order = tuple[str, ...]
#: What begins a part of a program of its own, and so ends everything before it.
_TOP = ("main:", "def ", "when ")
_END = "end"


@dataclass(frozen=True, slots=True)
class Judged:
    """What an order of pieces amounts to.

    Args:
        right: whether the puzzle is solved.
        good: how many pieces are right from the start, in the right order that begins most alike.
    """

    right: bool
    good: int


def pieces(source: str) -> Order:
    """The lines of a program, without the frame of ``main`` where that is all of it.

    An ``end`` is a piece only where it is needed: not at the end of the program, and not before
    the next function or event.
    """
    try:
        text = format_program(parse(source, "puzzle.bt"))
    except ProgramError:
        text = source
    lines = [line.strip() for line in text.split("\n")]
    needed = [line for line in lines if line and not line.startswith("#")]
    if needed and needed[0] == "main:" and sum(line.startswith(_TOP) for line in needed) == 1:
        needed = needed[1:]
    return _without_implied_ends(needed)


def right_orders(opened: OpenLesson, puzzle: Puzzle) -> tuple[Order, ...]:
    """The orders that solve a puzzle, that of its program first.

    Raises:
        LessonError: its program is missing.
    """
    sources = (opened.program(puzzle.program), *puzzle.also)
    return tuple(dict.fromkeys(map(pieces, sources)))


def judge(sequence: Sequence[str], orders: Sequence[Order]) -> Judged:
    """Judge an order of pieces by those that are right."""
    order = _without_implied_ends(sequence)
    return Judged(order in orders, max(_shared(order, right) for right in orders))


def has_same_pieces(first: Order, second: Order) -> bool:
    """Whether two orders have the same pieces; an ``end`` may be needed in one of them only."""
    return sorted(_without_ends(first)) == sorted(_without_ends(second))


def _without_implied_ends(lines: Sequence[str]) -> Order:
    return tuple(line for at, line in enumerate(lines) if line != _END or _is_needed(lines[at:]))


def _is_needed(rest: Sequence[str]) -> bool:
    """Whether an ``end`` is needed before what follows it."""
    following = next((line for line in rest if line != _END), None)
    return following is not None and not following.startswith(_TOP)


def _without_ends(order: Order) -> Iterator[str]:
    return (line for line in order if line != _END)


def _shared(order: Order, right: Order) -> int:
    pairs = zip(order, right, strict=False)
    differing = (at for at, (first, second) in enumerate(pairs) if first != second)
    return next(differing, min(len(order), len(right)))
