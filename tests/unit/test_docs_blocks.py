"""Every example in Block-Text of the docs is shown as blocks, too."""

import re
from xml.etree import ElementTree

import msgspec
import pytest

from learnblock import language
from learnblock.blocks.known import all_configurations
from learnblock.blocks.palette import palette
from places import ROOT

#: If a test of this file fails, run `scripts/docs-blocks`.
PICTURES = ROOT / "docs/images/blocks"
PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]
EXAMPLE = re.compile(
    r"(?:^!\[[^\]\n]+\]\((\S+)\)\n\n)?^```blocktext.*?\n(.*?)^```$", re.MULTILINE | re.DOTALL
)
EXAMPLES = [
    (page, *example) for page in PAGES for example in EXAMPLE.findall(page.read_text("utf-8"))
]
CONFIGURATIONS = all_configurations()
PALETTE = palette(CONFIGURATIONS, "en")
SVG = "{http://www.w3.org/2000/svg}"


def first_words(definition):
    """Return what a block begins with; what follows may be folded."""
    message = re.sub(
        r"%{BKY_(\w+)}", lambda word: PALETTE["messages"][word[1]], definition["message0"]
    )
    return re.split(r"%\d+", message)[0].strip()


WORDS = {definition["type"]: first_words(definition) for definition in PALETTE["definitions"]}


def types_of(text):
    """Return the types of the blocks of a program."""
    workspace = language.to_workspace(language.parse(text), CONFIGURATIONS).workspace
    return set(re.findall(r'"type":"(\w+)"', msgspec.json.encode(workspace).decode()))


def drawn(page, address):
    return ElementTree.parse(page.parent / address)  # noqa: S314 - we wrote it


def test_no_picture_is_left_over():
    named = {(page.parent / address).resolve() for page, address, _ in EXAMPLES}
    assert named == {*PICTURES.iterdir()}


@pytest.mark.parametrize(("page", "address", "text"), EXAMPLES)
def test_the_picture_before_an_example_shows_it(page, address, text):
    title = drawn(page, address).findtext(f"{SVG}title")
    assert title == language.format(language.parse(text))


@pytest.mark.parametrize(("page", "address", "text"), EXAMPLES)
def test_the_picture_has_the_words_that_its_blocks_have_today(page, address, text):
    shown = " ".join(element.text or "" for element in drawn(page, address).iter(f"{SVG}text"))
    words = {WORDS.get(kind, "") for kind in types_of(text)} - {""}
    assert words
    assert [word for word in words if word not in shown.replace("\xa0", " ")] == []
