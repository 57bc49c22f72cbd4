from collections.abc import Iterable

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from learnblock import language
from learnblock.language import parse
from learnblock.lessons.mutants import mutants
from places import ROOT

EXAMPLES = sorted((ROOT / "examples").glob("*.bt"))
SQUARE = """main:
    repeat 4:
        function.drive_distance(200)
        function.turn_90_right()
    end
    function.stop_bot()
end
"""


def kinds(source: str) -> set[str]:
    return {one.what.partition(": ")[2] for one in mutants(source) if ";" not in one.what}


@pytest.mark.sample(6)
@pytest.mark.parametrize("file", EXAMPLES, ids=lambda file: file.stem)
def test_there_are_at_least_forty_distinct_mutants_of_every_example(file):
    found = [one.source for one in mutants(file.read_text())]
    assert len(set(found)) == len(found) >= 40


@pytest.mark.sample(6)
@pytest.mark.parametrize("file", EXAMPLES, ids=lambda file: file.stem)
def test_every_mutant_can_be_read_and_is_not_the_program_itself(file):
    text = file.read_text()
    for one in mutants(text):
        assert language.format(parse(one.source)) == one.source != language.format(parse(text))


def test_the_same_program_always_has_the_same_mutants():
    assert list(mutants(SQUARE)) == list(mutants(SQUARE))


@settings(max_examples=5)
@given(st.integers(min_value=1))
def test_a_seed_changes_only_the_order_of_single_mistakes(seed):
    def single(found: Iterable[object]) -> set[object]:
        return {one for one in found if ";" not in one.what}

    assert single(mutants(SQUARE, seed)) == single(mutants(SQUARE))


@pytest.mark.parametrize(
    "mistake",
    [
        "number 4 one less",
        "number 4 one more",
        "number 200 negated",
        "number 200 doubled",
        "turn_90_left instead of turn_90_right",
        "statement missing",
        "statement twice",
        "statements swapped",
        "last statement outside the loop",
        "next statement in the loop",
        "loop missing",
        "everything forever",
    ],
)
def test_a_square_gets_each_typical_mistake(mistake):
    assert mistake in kinds(SQUARE)


@pytest.mark.parametrize(
    ("source", "mistake"),
    [
        ("main:\n    while x < 3 and y:\n        x += 1\n    end\nend\n", "'and' is 'or'"),
        ("main:\n    while x < 3:\n        x += 1\n    end\nend\n", "'<' is '>'"),
        ("main:\n    while x < 3:\n        x += 1\n    end\nend\n", "'-=' instead of '+='"),
        ('main:\n    print("hello")\nend\n', "text with a letter missing"),
        ("when a = x:\n    deactivate a\nend\n", "activate and deactivate confused"),
        ("main:\n    if x:\n        a()\n    else:\n        b()\n    end\nend\n", "'else' swapped"),
        ("main:\n    wait until x\nend\n", "a wait of a second instead"),
        ("main:\n    function.is_tag(8)\nend\n", "number 8 one less"),
        ("main:\n    function.move_straight()\nend\n", "advSpeed negated"),
    ],
)
def test_a_construct_gets_its_mistake(source, mistake):
    assert mistake in kinds(source)
