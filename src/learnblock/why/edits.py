"""The lines in which two programs differ."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from difflib import SequenceMatcher

from learnblock.language.python.robot_import import for_any_robot
from learnblock.runtime.program import Program

#: The most lines for a comparison line by line, and for one that counts frequent lines too.
MOST_LINES, FEW_LINES = 10_000, 1000
#: The maximum number of characters shown of a line.
LONGEST = 80


@dataclass(frozen=True, slots=True)
class ChangedLine:
    """A line that differs.

    Args:
        line_before: its number in the first program; 0 if it is not there.
        line: its number in the second program.
        before: its text in the first one.
        after: that in the second one.
    """

    line_before: int
    line: int
    before: str
    after: str


def edits(first_program: Program, second_program: Program) -> tuple[ChangedLine, ...]:
    """The lines, as their author wrote them, in which two programs differ."""
    texts = (first_program.written, second_program.written)
    if (first_program.source_map is None) != (second_program.source_map is None):
        # One was written in Block-Text, the other one in Python.
        texts = (first_program.python, second_program.python)
    before, after = map(_lines, texts)
    return tuple(edit for edit in _edits(before, after) if edit.before or edit.after)


def line_pairs(first_program: Program, second_program: Program) -> dict[int, int]:
    """For each line of the first program's Python, its new line in the second one.

    An edited line is paired with its new version.
    """
    before, after = _lines(first_program.python), _lines(second_program.python)
    pairs: dict[int, int] = {}
    for tag, first, last, there, _ in _changes(before, after, whole=True):
        if tag in ("equal", "replace"):
            pairs.update({line + 1: line - first + there + 1 for line in range(first, last)})
    return pairs


def _lines(text: str) -> list[str]:
    # The import of the robot is no edit: the same program runs on another robot.
    return [line.rstrip() for line in _split(for_any_robot(text))]


def _split(text: str) -> list[str]:
    return text.split("\n")


def _edits(before: Sequence[str], after: Sequence[str]) -> Iterator[ChangedLine]:
    for _, first, last, there, end in _changes(before, after, whole=False):
        for number in range(max(last - first, end - there)):
            at, to = first + number, there + number
            yield ChangedLine(
                at + 1 if at < last else 0,
                to + 1 if to < end else 0,
                before[at].strip()[:LONGEST] if at < last else "",
                after[to].strip()[:LONGEST] if to < end else "",
            )


def _changes(
    before: Sequence[str], after: Sequence[str], *, whole: bool
) -> Iterator[tuple[str, int, int, int, int]]:
    """The corresponding parts of two texts, without equal ones unless `whole`."""
    if max(len(before), len(after)) > MOST_LINES:
        if whole or list(before) != list(after):
            yield "replace", 0, len(before), 0, len(after)
        return
    # Frequent lines, such as "end", are relevant in a short program, but slow in a long one.
    matcher = SequenceMatcher(None, before, after, autojunk=len(after) > FEW_LINES)
    yield from (part for part in matcher.get_opcodes() if whole or part[0] != "equal")
