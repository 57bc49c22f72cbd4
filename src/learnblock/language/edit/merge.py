"""Merge two edits of the same text, line by line."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

#: The most pairs of lines to compare, which takes half a second; a longer changed section counts as
#: one change.
MOST_PAIRS = 250_000


@dataclass(frozen=True)
class Merge:
    """The result of merging two edits.

    Args:
        text: the text with both edits.
        is_conflict: whether both changed the same line, which then has only the preferred edit.
    """

    text: str
    is_conflict: bool = False


def merge(base: str, other: str, preferred: str) -> Merge:
    r"""Merge two edits of a text.

    Edits of neighbouring lines are no conflict. Of two insertions at one place the result has both,
    `other`'s first; if one begins with the other, it has only the longer one.

    Args:
        base: the text that was edited.
        other: the text after one edit.
        preferred: the text after the other edit, which wins a conflict.

    >>> merge("a\nb\nc", "a!\nb\nc", "a\nb\nc\nd").text
    'a!\nb\nc\nd'
    >>> merge("a\nb", "a 1\nb", "a 2\nb")
    Merge(text='a 2\nb', is_conflict=True)
    """
    if preferred in (base, other):
        return Merge(other)
    if base == other:
        return Merge(preferred)
    lines = base.split("\n")
    merged: list[str] = []
    copied = 0
    is_conflict = False
    for meeting in _meetings(_changes(lines, other), _changes(lines, preferred)):
        both, conflicts = meeting.merged(lines)
        merged += [*lines[copied : meeting.start], *both]
        copied = meeting.end
        is_conflict |= conflicts
    return Merge("\n".join([*merged, *lines[copied:]]), is_conflict)


@dataclass(frozen=True)
class _Change:
    """New lines for those from `start` up to `end`; an insertion if these are equal."""

    start: int
    end: int
    new: tuple[str, ...]


@dataclass
class _Meeting:
    """Changes of the lines from `start` up to `end` that overlap: of `other`, of `preferred`."""

    start: int
    end: int
    sides: tuple[list[_Change], list[_Change]]

    def takes(self, change: _Change) -> bool:
        """Whether a change that begins at or after its start belongs to it."""
        both_insert = self.start == self.end == change.start == change.end
        return both_insert or change.start < self.end

    def merged(self, lines: Sequence[str]) -> tuple[list[str], bool]:
        """The new lines, and whether a change is missing from them."""
        other, preferred = (self._applied(lines, side) for side in self.sides)
        if not self.sides[0] or other == preferred:
            return preferred, False
        if not self.sides[1]:
            return other, False
        if self.start == self.end:
            return _both(other, preferred), False
        return preferred, True

    def _applied(self, lines: Sequence[str], side: Sequence[_Change]) -> list[str]:
        applied: list[str] = []
        at = self.start
        for change in side:
            applied += [*lines[at : change.start], *change.new]
            at = change.end
        return [*applied, *lines[at : self.end]]


def _meetings(other: Sequence[_Change], preferred: Sequence[_Change]) -> Iterator[_Meeting]:
    """Group the changes by where they overlap, in the order of the text."""
    sided = [*((change, 0) for change in other), *((change, 1) for change in preferred)]
    sided.sort(key=lambda sided_change: (sided_change[0].start, sided_change[0].end))
    meeting: _Meeting | None = None
    for change, side in sided:
        if meeting is None or not meeting.takes(change):
            if meeting:
                yield meeting
            meeting = _Meeting(change.start, change.end, ([], []))
        meeting.sides[side].append(change)
        meeting.end = max(meeting.end, change.end)
    if meeting:
        yield meeting


def _both(other: list[str], preferred: list[str]) -> list[str]:
    """Two insertions; an edit that is merged again, as after a crash, is not inserted twice."""
    longer, shorter = sorted((other, preferred), key=len, reverse=True)
    return longer if longer[: len(shorter)] == shorter else other + preferred


def _changes(old: Sequence[str], text: str) -> list[_Change]:
    new = text.split("\n")
    start = _common(old, new, min(len(old), len(new)))
    tail = _common(old[::-1], new[::-1], min(len(old), len(new)) - start)
    old, new = old[start : len(old) - tail], new[start : len(new) - tail]
    if len(old) * len(new) > MOST_PAIRS:
        return [_Change(start, start + len(old), tuple(new))]
    changes: list[_Change] = []
    before, new_before = 0, 0
    for at, new_at in (*_kept(old, new), (len(old), len(new))):
        if before < at or new_before < new_at:
            changes += _split(start + before, old[before:at], new[new_before:new_at])
        before, new_before = at + 1, new_at + 1
    return changes


def _kept(old: Sequence[str], new: Sequence[str]) -> list[tuple[int, int]]:
    """The lines that both texts have, as pairs of indices in order; as many characters as possible.

    Characters are counted, not lines, because two lines ``end`` are hardly ever the same one.
    """
    most = [[0] * (len(new) + 1) for _ in range(len(old) + 1)]
    for at in reversed(range(len(old))):
        row, below, line = most[at], most[at + 1], old[at]
        for new_at in reversed(range(len(new))):
            row[new_at] = max(below[new_at], row[new_at + 1])
            if line == new[new_at]:
                row[new_at] = max(row[new_at], below[new_at + 1] + 1 + len(line))
    pairs: list[tuple[int, int]] = []
    at = new_at = 0
    while at < len(old) and new_at < len(new):
        if most[at][new_at] == most[at + 1][new_at]:
            at += 1
        elif most[at][new_at] == most[at][new_at + 1]:
            new_at += 1
        else:
            pairs.append((at, new_at))
            at, new_at = at + 1, new_at + 1
    return pairs


def _common(first: Sequence[str], other: Sequence[str], most: int) -> int:
    return next((at for at in range(most) if first[at] != other[at]), most)


def _split(start: int, old: Sequence[str], new: Sequence[str]) -> Iterator[_Change]:
    """Split a change of several lines into changes of one, if the lines correspond."""
    if len(old) != len(new):
        yield _Change(start, start + len(old), tuple(new))
        return
    for at, (before, after) in enumerate(zip(old, new, strict=True), start):
        if before == "":
            # Two people who begin to write on the same empty line do not change each other's text.
            yield _Change(at, at, (after,))
            yield _Change(at, at + 1, ())
        else:
            yield _Change(at, at + 1, (after,))
