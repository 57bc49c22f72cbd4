import keyword

import pytest
from hypothesis import given
from hypothesis import strategies as st

from learnblock.language.blocktext import names
from learnblock.language.blocktext.lexer import KEYWORDS

NAMES = st.sampled_from(
    ["x", "_", "__", "class", "class_", "class__", "robot", "range", "x_when", "x_when_when", "end"]
)
WORDS = NAMES.filter(lambda name: name not in KEYWORDS)


@given(WORDS)
def test_a_name_is_restored_from_python(name):
    assert name == names.from_python(names.to_python(name))


@given(NAMES)
def test_a_name_of_a_skill_is_restored_from_python(name):
    assert name == names.attribute_from_python(names.attribute_to_python(name))


@given(st.sets(WORDS), WORDS)
def test_a_when_is_restored_from_python_and_never_hides_a_variable(variables, name):
    clashing = names.clashes(variables)
    python = names.when_to_python(name, clashing)
    assert name == names.when_from_python(python, clashing)
    assert python not in {names.to_python(variable) for variable in variables}


@pytest.mark.parametrize("word", [*keyword.kwlist, "robot", "print", "math", "_"])
def test_names_that_generated_python_needs_are_renamed(word):
    assert word + "_" == names.to_python(word)
    assert names.from_python(word) is None


def test_keywords_of_block_text_are_not_names():
    assert names.from_python("end") is None
