"""Every yes/no block reads as a part of the blocks that ask it."""

import json
import re
from pathlib import Path

import pytest

from learnblock.blocks.definitions import definitions
from learnblock.blocks.labels import spoken, translated
from learnblock.blocks.schema.configuration import BlockConfiguration, Parameter
from learnblock.blocks.schema.loading import builtin
from learnblock.blocks.translation import translation

ROOT = Path(__file__).parents[3]
CASES = ROOT / "tests/cases/sentences"
PAGE = ROOT / "frontend/src/views/blocks/words"
LANGUAGES = ("en", "es")

QUESTIONS = [block for block in builtin().values() if block.returns == "boolean"]
#: The blocks of the language that answer yes or no, with what stands in their places.
OWN = {"LB_STATE": "blink", "LB_ELAPSED_TIME": "5"}
#: What asks: words of ours, or of the page.
ASKING = (
    "CONTROLS_IF_MSG_IF",
    "CONTROLS_WHILEUNTIL_OPERATOR_WHILE",
    "CONTROLS_WHILEUNTIL_OPERATOR_UNTIL",
    "LB_WAIT_UNTIL",
    "LB_WHEN_CONDITION",
    "LOGIC_NEGATE_TITLE",
)
#: Joins that no reader would say, by language.
WRONG_JOINS = {
    # A verb without its subject, a statement after "not", two negations, "not only".
    "en": (
        r"\b(if|until|when|while|not) (see|hear|is|are|am|do|does|has|have)\b",
        r"\b(if|until|when|while|not) \S+( \S+)? (is|are)\b",
        r"\bnot (no|not|any|only|I|a|an|the)\b",
    ),
    # "Until" takes no plain statement, "no" precedes a verb, and two negations are none.
    "es": (
        r"\bhasta que (?!sea cierto que )",
        r"\bno (?!(hay|veo|voy|giro|estoy|está|han|he|tengo|llevo|es|me)\b)",
        r"\bno \S+ (alg|ning)",
        r"\bque (alg|ning)",
    ),
}


def words_of_page(language: str) -> dict[str, str]:
    own = json.loads((PAGE / f"{language}.json").read_text(encoding="utf-8"))
    return {**own, **translation(language)}


def asked(language: str, code: str, question: str) -> str:
    frame = words_of_page(language)[code]
    return frame.replace("%1", question) if "%1" in frame else f"{frame} {question}"


def value(parameter: Parameter, language: str) -> object:
    if parameter.choices:
        names = parameter.choice_names.get(parameter.choices[0], {})
        return translated(names, language, parameter.choices[0])
    return 8 if parameter.default in (None, "") else parameter.default


def filled(block: BlockConfiguration, language: str) -> str:
    values = {parameter.name: value(parameter, language) for parameter in block.parameters}
    return spoken(block, language, values)


def questions(language: str) -> dict[str, str]:
    own = {code: translation(language)[code].replace("%1", OWN[code]) for code in OWN}
    return {block.name: filled(block, language) for block in QUESTIONS} | own


def composed(language: str) -> str:
    parts = []
    for name, question in questions(language).items():
        lines = [name, question, *(asked(language, code, question) for code in ASKING)]
        parts.append("\n    ".join(lines))
    return "\n\n".join(parts) + "\n"


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_question_asked_by_every_block_reads_as_in_the_file(language):
    assert composed(language) == (CASES / f"{language}.txt").read_text(encoding="utf-8")


@pytest.mark.parametrize("language", LANGUAGES)
def test_no_question_mark_is_in_a_sentence(language):
    assert re.findall(r".*[?¿].*", composed(language)) == []


@pytest.mark.parametrize("language", LANGUAGES)
def test_no_block_joins_a_question_wrongly(language):
    wrong = "|".join(WRONG_JOINS[language])

    assert [line for line in composed(language).splitlines() if re.search(wrong, line)] == []


@pytest.mark.parametrize("language", LANGUAGES)
def test_an_empty_place_for_a_question_is_no_question(language):
    assert not re.search(r"[?¿]", translation(language)["LB_SLOT_QUESTION"])


@pytest.mark.parametrize("language", LANGUAGES)
def test_all_blocks_that_answer_yes_or_no_are_read(language):
    answers = {one["type"] for one in definitions({}, language) if one.get("output") == "Boolean"}

    assert answers == {code.lower() for code in OWN} | {"lb_in", "lb_compare_chain"}
