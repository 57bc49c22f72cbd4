"""Match the statements of an edited program to those of the program before.

First, equal beginnings and ends are matched, then equal statements that occur once in both;
between those, statements of the same kind are matched in order. All steps take linear time, except
sorting the statements that occur once.
"""

from bisect import bisect_left
from collections import Counter, defaultdict, deque
from collections.abc import Callable, Hashable, Sequence
from typing import NamedTuple

from learnblock.language.tree.nodes import Assign, Def, Index, Perform, When
from learnblock.language.tree.traversal import bodies, expressions
from learnblock.language.workspace.statement_reader import Group

Kind = Callable[[Group], Hashable]


class Match(NamedTuple):
    """The index of an old statement, and whether it equals the new one."""

    place: int
    equal: bool


class _Gap(NamedTuple):
    """A range of new statements, and the range of old ones that may match."""

    start: int
    end: int
    old_start: int
    old_end: int


def aligned(new: Sequence[Group], old: Sequence[Group]) -> list[Match | None]:
    """For each new statement, the matching old one, if any."""
    matches: list[Match | None] = [None] * len(new)
    gap = _grown(new, old, _Gap(0, len(new), 0, len(old)), matches)
    for inner in _between(gap, _unique(new, old, gap), matches, equal=True):
        rest = _grown(new, old, inner, matches)
        headers = _alike(new, old, rest, _header)
        for headed in _between(rest, headers, matches, equal=False):
            _between(headed, _alike(new, old, headed, _kind), matches, equal=False)
    return matches


def _grown(
    new: Sequence[Group], old: Sequence[Group], gap: _Gap, matches: list[Match | None]
) -> _Gap:
    """Match equal statements at the beginning and the end of a gap; return the rest."""
    start, end, old_start, old_end = gap
    while start < end and old_start < old_end and new[start] == old[old_start]:
        matches[start] = Match(old_start, equal=True)
        start, old_start = start + 1, old_start + 1
    while start < end and old_start < old_end and new[end - 1] == old[old_end - 1]:
        end, old_end = end - 1, old_end - 1
        matches[end] = Match(old_end, equal=True)
    return _Gap(start, end, old_start, old_end)


def _between(
    gap: _Gap, pairs: Sequence[tuple[int, int]], matches: list[Match | None], *, equal: bool
) -> list[_Gap]:
    """Match the pairs in a gap; return the gaps between them."""
    gaps: list[_Gap] = []
    start, old_start = gap.start, gap.old_start
    for place, old_place in pairs:
        matches[place] = Match(old_place, equal)
        gaps.append(_Gap(start, place, old_start, old_place))
        start, old_start = place + 1, old_place + 1
    gaps.append(_Gap(start, gap.end, old_start, gap.old_end))
    return [gap for gap in gaps if gap.start < gap.end and gap.old_start < gap.old_end]


def _unique(new: Sequence[Group], old: Sequence[Group], gap: _Gap) -> list[tuple[int, int]]:
    """Equal statements that occur once in both ranges, limited to those in the same order."""
    part, old_part = new[gap.start : gap.end], old[gap.old_start : gap.old_end]
    if not part or not old_part:
        return []
    counts, old_counts = Counter(part), Counter(old_part)
    places = {group: place for place, group in enumerate(old_part, gap.old_start)}
    pairs = [
        (place, places[group])
        for place, group in enumerate(part, gap.start)
        if counts[group] == 1 == old_counts[group]
    ]
    return _rising(pairs)


def _rising(pairs: Sequence[tuple[int, int]]) -> list[tuple[int, int]]:
    """The longest subsequence of the pairs in which the second numbers increase."""
    tails: list[int] = []
    ends: list[int] = []
    before: list[int] = []
    for index, (_, old_place) in enumerate(pairs):
        length = bisect_left(tails, old_place)
        before.append(ends[length - 1] if length else -1)
        if length == len(tails):
            tails.append(old_place)
            ends.append(index)
        else:
            tails[length], ends[length] = old_place, index
    chosen: list[tuple[int, int]] = []
    index = ends[-1] if ends else -1
    while index >= 0:
        chosen.append(pairs[index])
        index = before[index]
    return chosen[::-1]


def _alike(
    new: Sequence[Group], old: Sequence[Group], gap: _Gap, kind: Kind
) -> list[tuple[int, int]]:
    """Pair each new statement with the next old one of the same kind."""
    waiting: defaultdict[Hashable, deque[int]] = defaultdict(deque)
    for place in range(gap.old_start, gap.old_end):
        waiting[kind(old[place])].append(place)
    pairs: list[tuple[int, int]] = []
    next_place = gap.old_start
    for place in range(gap.start, gap.end):
        places = waiting[kind(new[place])]
        while places and places[0] < next_place:
            places.popleft()
        if places:
            pairs.append((place, places[0]))
            next_place = places[0] + 1
    return pairs


def _header(group: Group) -> Hashable:
    """The first line of a statement, if it distinguishes the statement from others."""
    statement = group.statement
    match statement:
        case Def(name=name) | When(name=name):
            return type(statement), name
        case Assign(target=target, operator=operator):
            return Assign, operator, target
        case Perform(call=call):
            return type(call), call.name
    if bodies(statement):
        return type(statement), expressions(statement)
    return statement


def _kind(group: Group) -> Hashable:
    """The kind of a statement: those of the same kind may be the same block with new content."""
    statement = group.statement
    match statement:
        case Assign(target=target, operator=operator, is_local=is_local):
            return Assign, operator in {"=", "+="} and operator, type(target) is Index, is_local
        case Perform(call=call):
            return Perform, type(call)
    return (type(statement),)
