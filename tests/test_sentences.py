"""What the server says in English has words in the page's other languages."""

import ast
import json
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest

ROOT = Path(__file__).parent.parent
BOOKS = ROOT / "frontend/src/sentences"
LANGUAGES = [folder.name for folder in BOOKS.iterdir() if folder.is_dir()]
SLIPS = sorted((Path(__file__).parent / "cases" / "malformed").glob("*.txt"))
PLACE = re.compile(r"\{\d\}")
#: Where a sentence of ours may have been put together from two strings.
SEAM = re.compile(r"\{\d\}|[`:,]| in | uses | such as ")
PUT_TOGETHER = [
    f"there is no {kind} "
    for kind in (
        *("project", "example", "version", "world", "robot", "set of blocks"),
        *("block of your own", "deleted block"),
    )
]
LOCATED = re.compile(r"\S+?:\d+:\d+: [\w-]+ (.*)")


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_slip_that_a_beginner_makes_is_told_in_each_language(language):
    slips = {found[1] for file in SLIPS for found in LOCATED.finditer(file.read_text("utf-8"))}
    assert len(slips) > 30
    assert {slip for slip in slips if said(slip, language) == slip} == set()


@pytest.mark.parametrize("language", LANGUAGES)
def test_no_sentence_is_translated_that_nobody_says(language):
    own = [english for english, _ in phrases(language, but="foreign.json")]
    spoken = "\0".join((*literals(), *PUT_TOGETHER))
    assert {
        one for one in own if not all(words.strip() in spoken for words in SEAM.split(one))
    } == set()


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_value_of_a_sentence_keeps_its_place(language):
    assert {
        english
        for english, text in phrases(language, but="foreign.json")
        if {*PLACE.findall(english)} != {*PLACE.findall(text)}
    } == set()


def said(english: str, language: str) -> str:
    """As `said` of the page does."""
    for pattern, text in patterns(language):
        if found := pattern.fullmatch(english):
            return PLACE.sub(lambda place: said(found[int(place[0][1])], language), text)
    return english


@cache
def patterns(language: str) -> tuple[tuple[re.Pattern[str], str], ...]:
    ordered = sorted(phrases(language), key=lambda one: -len(PLACE.sub("", one[0])))
    return tuple(
        (re.compile("(.+?)".join(map(re.escape, PLACE.split(english))), re.DOTALL), text)
        for english, text in ordered
    )


def phrases(language: str, but: str = "") -> list[tuple[str, str]]:
    """The sentences of all files but one; ``foreign.json`` is what Python and the system say."""
    files = [file for file in (BOOKS / language).glob("*.json") if file.name != but]
    return [one for file in files for one in json.loads(file.read_text("utf-8")).items()]


def literals() -> Iterator[str]:
    """The strings in our sources, and in the worlds."""
    for world in (ROOT / "src/learnblock/simulator/worlds").glob("*.toml"):
        yield world.read_text("utf-8")
    for file in (ROOT / "src/learnblock").rglob("*.py"):
        for node in ast.walk(ast.parse(file.read_text("utf-8"))):
            if isinstance(node, ast.Constant) and isinstance(node.value, str):
                yield node.value
