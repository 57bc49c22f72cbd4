"""How alike programs are: the same, the same with other names, or sharing most of their parts.

None of this says who wrote what. Short programs with one task are alike by themselves.
"""

import ast
import hashlib
import io
import tokenize
from array import array
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, fields, is_dataclass
from typing import Any

import numpy as np

from learnblock.language.tree.nodes import (
    Activate,
    Assign,
    Blank,
    Call,
    Comment,
    Deactivate,
    Def,
    ForEach,
    ForRange,
    Name,
    Program,
    PythonBlock,
    PythonLine,
    PythonPart,
    Raw,
    RawExpression,
    When,
)
from learnblock.language.tree.traversal import set_by

#: The tokens of a part, of which a program has one beginning at each token.
PART = 6
#: The share of parts from which on programs are shown side by side.
MUCH = 0.8
#: Programs with fewer parts of their own are too short to compare.
FEWEST = 12
#: The most pairs of programs that are listed.
MOST = 100
#: How many times as many pairs are kept before the best are chosen.
_KEPT = 10
#: How much a share that is rounded may be larger.
_ROUNDING = 0.001
_WHEN_NAMES = ("state_", "time_")


@dataclass(frozen=True, slots=True)
class Print:
    """What is compared of a program.

    Args:
        exact: the hash of its tree, without comments, blank lines and layout.
        renamed: the same, with its own names numbered in their order; other names and all numbers
            and texts are kept.
        parts: the hashes of its parts, with its own names numbered.
    """

    exact: str
    renamed: str
    parts: frozenset[int]


@dataclass(frozen=True, slots=True)
class Pair:
    """Two programs that are alike.

    Args:
        first: the index of one.
        second: the index of the other.
        kind: ``same``, ``renamed`` or ``alike``.
        share: the parts that both have, divided by those that either has.
    """

    first: int
    second: int
    kind: str
    share: float = 1.0


def print_of(program: Program) -> Print:
    """What is compared of a program."""
    own = _own_names(program)
    exact = [*_tokens(program, {})]
    numbers: dict[str, str] = {}
    numbered = [*_tokens(program, _Numbered(own, numbers))]
    starts = range(max(len(numbered) - PART + 1, 0))
    parts = frozenset(_number("\0".join(numbered[at : at + PART])) for at in starts)
    return Print(_hash(exact), _hash(numbered), parts)


@dataclass(frozen=True, slots=True)
class Alike:
    """The programs that are alike.

    Args:
        pairs: the pairs that are most alike, those first.
        total: how many pairs there are.
    """

    pairs: tuple[Pair, ...]
    total: int


def alike(prints: Sequence[Print | None], given: Print | None = None, most: int = MOST) -> Alike:
    """Find programs that are alike.

    Of programs that are the same except for names, only pairs with the first of them are listed.

    Args:
        prints: of each program; None where there is none.
        given: of the program that pupils started with; programs that are still the same are left
            out.
        most: how many pairs are listed at most.
    """
    kinds: dict[str, list[int]] = defaultdict(list)
    for index, fingerprint in enumerate(prints):
        if fingerprint is not None and (given is None or fingerprint.renamed != given.renamed):
            kinds[fingerprint.renamed].append(index)
    same = [pair for indexes in kinds.values() for pair in _same(indexes, prints)]
    given_parts = given.parts if given else frozenset()
    firsts = [indexes[0] for indexes in kinds.values()]
    owns = {
        index: fingerprint.parts - given_parts for index in firsts if (fingerprint := prints[index])
    }
    likely, total = _likely({i: own for i, own in owns.items() if len(own) >= FEWEST}, most)
    order = ("same", "renamed", "alike")
    pairs = sorted(
        [*same, *likely],
        key=lambda pair: (order.index(pair.kind), -pair.share, pair.first, pair.second),
    )
    return Alike(tuple(pairs[:most]), len(same) + total)


def _same(indexes: Sequence[int], prints: Sequence[Print | None]) -> Iterator[Pair]:
    first = prints[indexes[0]]
    for index in indexes[1:]:
        is_same = first is not None and prints[index] == first
        yield Pair(indexes[0], index, "same" if is_same else "renamed")


def _likely(owns: Mapping[int, frozenset[int]], most: int) -> tuple[list[Pair], int]:
    """At least the `most` pairs that share the most parts, and how many share much.

    Args:
        owns: the parts of each program, by its index.
        most: how many pairs are wanted.
    """
    indexes = [*owns]
    best: list[Pair] = []
    enough, total = MUCH, 0
    for place, shares in enumerate(_shares([*owns.values()])):
        total += int((shares >= MUCH).sum())
        for earlier in np.flatnonzero(shares >= enough).tolist():
            share = round(float(shares[earlier]), 3)
            best.append(Pair(indexes[earlier], indexes[place], "alike", share))
        if len(best) > _KEPT * most:
            best = sorted(best, key=lambda pair: (-pair.share, pair.first, pair.second))[:most]
            # It is compared with shares that are not rounded yet.
            enough = max(MUCH, best[-1].share - _ROUNDING)
    return best, total


def _shares(owns: Sequence[frozenset[int]]) -> Iterator["np.ndarray[Any, np.dtype[np.float64]]"]:
    """For each program, the share of parts that it has in common with each of those before it.

    Common parts are counted along the lists of the programs that have a part: comparing the
    programs two by two takes minutes for some thousands of them.
    """
    sizes = np.array([len(own) for own in owns])
    programs_with: dict[int, array[int]] = defaultdict(lambda: array("i"))
    for place, own in enumerate(owns):
        lists = [np.array(programs_with[part]) for part in own if part in programs_with]
        places = np.concatenate(lists) if lists else np.empty(0, np.int32)
        common = np.bincount(places, minlength=place)
        yield common / (sizes[:place] + len(own) - common)
        for part in own:
            programs_with[part].append(place)


class _Numbered(dict[str, str]):
    """Own names numbered by their first place; other names as they are.

    Args:
        own: the program's own names.
        numbers: the numbers so far.
    """

    def __init__(self, own: frozenset[str], numbers: dict[str, str]) -> None:
        super().__init__()
        self._own = own
        self._numbers = numbers

    def __missing__(self, name: str) -> str:
        for prefix in _WHEN_NAMES:
            if (rest := name.removeprefix(prefix)) != name and rest in self._own:
                return prefix + self[rest]
        if name not in self._own:
            return name
        return self._numbers.setdefault(name, f"name {len(self._numbers) + 1}")


def _named(name: str, names: Mapping[str, str]) -> str:
    return names[name] if isinstance(names, _Numbered) else name


def _tokens(value: object, names: Mapping[str, str]) -> Iterator[str]:
    """A program's parts in order: kinds of nodes, names, numbers and texts."""
    match value:
        case Comment() | Blank():
            return
        case Raw() | PythonLine() | RawExpression():
            yield type(value).__name__
            yield from _python_tokens(value.text, names)
        case PythonPart():
            yield type(value).__name__
            yield from _python_tokens(value.header, names)
            yield from _tokens(value.body, names)
        case _ if is_dataclass(value) and not isinstance(value, type):
            yield type(value).__name__
            for field in fields(value):
                if field.name in _NAMES.get(type(value), ()):
                    yield from _names_of(getattr(value, field.name), names)
                elif field.compare and field.name != "comment":
                    yield from _tokens(getattr(value, field.name), names)
        case tuple():
            for item in value:
                yield from _tokens(item, names)
            yield "end"
        case _:
            yield repr(value)


def _names_of(value: str | Iterable[str], names: Mapping[str, str]) -> Iterator[str]:
    for name in (value,) if isinstance(value, str) else value:
        yield _named(name, names)


#: The fields that hold names which a program may have chosen itself.
_NAMES: Mapping[type, tuple[str, ...]] = {
    Activate: ("name",),
    Call: ("name",),
    Deactivate: ("name",),
    Def: ("name", "parameters"),
    Name: ("name",),
    When: ("name",),
}


def _own_names(program: Program) -> frozenset[str]:
    """The names that a program gives to variables, functions, parameters and events."""
    return frozenset(_chosen(program))


def _chosen(value: object) -> Iterator[str]:
    match value:
        case Def():
            yield value.name
            yield from value.parameters
        case When():
            yield value.name
        case Assign() | ForEach() | ForRange():
            yield from set_by(value)
        case Raw() | PythonLine() | PythonBlock() | RawExpression():
            yield from _python_names(value.text)
    if isinstance(value, tuple):
        for item in value:
            yield from _chosen(item)
    elif is_dataclass(value) and not isinstance(value, type):
        for field in fields(value):
            yield from _chosen(getattr(value, field.name))


def _python_names(text: str) -> Iterator[str]:
    try:
        nodes = [*ast.walk(ast.parse(text.strip()))]
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return
    for node in nodes:
        match node:
            case ast.FunctionDef(name=name) | ast.ClassDef(name=name) | ast.arg(arg=name):
                yield name
            case ast.Name(id=name, ctx=ast.Store()) if name != "robot":
                yield name


_LAYOUT = frozenset({
    tokenize.COMMENT, tokenize.NL, tokenize.NEWLINE, tokenize.ENCODING, tokenize.ENDMARKER,
})  # fmt: skip


def _python_tokens(text: str, names: Mapping[str, str]) -> Iterator[str]:
    """The tokens of Python, without comments and layout; words where it is no valid Python."""
    try:
        tokens = [*tokenize.generate_tokens(io.StringIO(text).readline)]
    except (tokenize.TokenError, SyntaxError, ValueError):
        yield from text.split()
        return
    for token in tokens:
        if token.type in {tokenize.INDENT, tokenize.DEDENT}:
            yield tokenize.tok_name[token.type]
        elif token.type not in _LAYOUT:
            yield _named(token.string, names)


def _hash(tokens: Iterable[str]) -> str:
    text = "\0".join(tokens).encode("utf-8", "surrogatepass")
    return hashlib.sha256(text).hexdigest()


def _number(text: str) -> int:
    """A hash that is the same in every process."""
    return int.from_bytes(
        hashlib.blake2b(text.encode("utf-8", "surrogatepass"), digest_size=8).digest()
    )
