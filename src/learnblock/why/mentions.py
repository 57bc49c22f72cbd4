"""Finds what the words of a question mention of a program: printed texts, values, names."""

import re
from collections.abc import Iterable, Iterator, Sequence
from itertools import takewhile

from learnblock.runtime.log.nodes import Kind, Node
from learnblock.why.history import EventHistory
from learnblock.why.vocabulary import Concept, concept, plain, translated

#: The number of letters in the root of a word.
_ROOT = 4
_WORD = re.compile(r"[^\W_]+")
_CAMEL = re.compile(r"(?<=[a-z0-9])(?=[A-Z])")
_TEXT = re.compile(r"[\"'](.*?)[\"']")


def words_of(text: str) -> frozenset[str]:
    """The words of a text of a program, its names in parts."""
    return frozenset(map(root, _WORD.findall(plain(_CAMEL.sub(" ", text)))))


def root(word: str) -> str:
    """A word without the end of its plural, in English if its translation is known."""
    for singular in (word, word.removesuffix("s"), word.removesuffix("es")):
        if singular in translated():
            return translated()[singular]
    return word.removesuffix("s") if len(word) > 3 else word


def content(tokens: Iterable[str]) -> frozenset[str]:
    """The words of a question that may be about the program itself."""
    return frozenset(
        root(token)
        for token in tokens
        if token.isdigit() or concept(token) not in (Concept.FILLER, Concept.NOT, Concept.KEEP)
    )


def names_in(tokens: Iterable[str]) -> frozenset[str]:
    """The words of a question that only the program can explain: names, values, colours."""
    own = (None, Concept.COLOUR)
    return frozenset(root(token) for token in tokens if token.isdigit() or concept(token) in own)


def printed_text(history: EventHistory, keywords: frozenset[str]) -> str | None:
    """The printed text that has most of some words; None if none has any."""
    texts = dict.fromkeys(str(line["print"]) for line in history.recorded.lines if "print" in line)
    return _most(((text, words_of(text)) for text in reversed([*texts])), keywords)


def prints(history: EventHistory) -> Iterator[Node]:
    """The calls that print."""
    for node in history.nodes:
        if node.kind is Kind.CALL and node.name == "print" and not node.base:
            yield node


def print_with(history: EventHistory, keywords: frozenset[str]) -> str | None:
    """The text of a line that prints most of some words; None if none has any."""
    texts = [(node.text, words_of(node.text)) for node in prints(history)]
    text = _most(iter(texts), keywords)
    quoted = _TEXT.search(text) if text else None
    return quoted[1] if quoted else None


def line_with(history: EventHistory, keywords: frozenset[str]) -> int | None:
    """The node of a call whose name, values or function mention most of some words."""
    calls = [
        (str(number), words_of(node.text) | words_of(_function(history, node)))
        for number, node in enumerate(history.nodes)
        if node.kind is Kind.CALL
    ]
    best = _most(iter(calls), keywords)
    return int(best) if best is not None else None


def variable_with(history: EventHistory, tokens: Sequence[str]) -> str | None:
    """The variable that a question names; None if it names none."""
    names = {plain(name.removesuffix("_")): name for name in history.writes if name != "robot"}
    return next((names[token] for token in tokens if token in names), None)


def when_with(history: EventHistory, tokens: Sequence[str]) -> str | None:
    """The `when` with a name like a word of a question, such as searching and search."""
    for node in history.nodes:
        if node.is_when and any(_is_akin(token, plain(node.name)) for token in tokens):
            return node.name
    return None


def _is_akin(word: str, name: str) -> bool:
    """Whether two words have the same root."""
    pairs = zip(word, name, strict=False)
    shared = sum(1 for _ in takewhile(lambda pair: pair[0] == pair[1], pairs))
    return shared >= _ROOT and shared >= min(len(word), len(name)) - 1


def _function(history: EventHistory, node: Node) -> str:
    return history.nodes[node.function].name if node.function >= 0 else ""


def _most(texts: Iterator[tuple[str, frozenset[str]]], keywords: frozenset[str]) -> str | None:
    counted = [(len(have & keywords), text) for text, have in texts]
    most = max((count for count, _ in counted), default=0)
    return next((text for count, text in counted if count == most), None) if most else None
