"""Numbers with as many decimals as a sentence needs to be true."""

import operator

import pytest
from hypothesis import given
from hypothesis import strategies as st

from asked import answered, run_of
from learnblock.why.decimals import FEW, decimals, is_compared_exactly, rounded

OPERATORS = {
    "==": operator.eq,
    "!=": operator.ne,
    "<": operator.lt,
    "<=": operator.le,
    ">": operator.gt,
    ">=": operator.ge,
}


@pytest.mark.parametrize(
    ("condition", "values", "was_true", "count"),
    [
        ("x == 0.3", {"x": 0.1 + 0.2}, False, 17),
        ("x != 0.3", {"x": 0.1 + 0.2}, True, 17),
        ("x < 2", {"x": 1.999}, True, 3),
        ("x > 2 and y", {"x": 2.0004, "y": True}, True, 4),
        ("x == 0.5", {"x": 0.5}, True, FEW),
        ("x + 1 > 2", {"x": 1.0001}, True, 4),
        ("x == y", {"x": 0.1 + 0.2, "y": 0.3}, False, 17),
        ("robot.get_min_distance() < 115", {"robot.get_min_distance()": 114.999}, True, 3),
        ("unknown(x) == 1", {"x": 1.0}, False, FEW),
        ("not a condit", {"x": 1.0}, False, FEW),
        ("x / 0 > 1", {"x": 1.0}, False, FEW),
    ],
)
def test_a_condition_is_told_with_enough_decimals(condition, values, was_true, count):
    assert decimals(condition, values, was_true=was_true) == count


@given(
    st.floats(-1e6, 1e6, allow_nan=False),
    st.floats(-1e6, 1e6, allow_nan=False),
    st.sampled_from(sorted(OPERATORS)),
)
def test_the_shown_number_never_contradicts_the_condition(value, limit, sign):
    was_true = OPERATORS[sign](value, limit)
    count = decimals(f"x {sign} {limit!r}", {"x": value}, was_true=was_true)
    assert OPERATORS[sign](rounded(value, count), limit) == was_true


def test_only_equality_is_exact():
    assert is_compared_exactly("a and x == 1")
    assert not is_compared_exactly("x <= 1")
    assert not is_compared_exactly("x ===")


@pytest.mark.parametrize("question", ["why did it not show joy", "why is it sad"])
def test_an_answer_tells_that_decimals_are_only_nearly_stored(tmp_path, question):
    program = (
        "x = 0.1 + 0.2\nif x == 0.3:\n    function.expressJoy()\nelse:\n"
        "    function.expressSadness()\nend\n"
    )
    given_answer = answered(run_of(tmp_path, program, seconds=2), question)
    text = " ".join(given_answer.words("en"))
    assert "x was 0.30000000000000004" in text
    assert "x was 0.3:" not in text
    assert "why-decimals" in [one.phrase.code for one in given_answer.sentences]


def test_a_time_is_on_its_side_of_a_limit(tmp_path):
    program = "while not elapsedTime(2):\n    function.sleep(0.501)\nend\nfunction.expressJoy()\n"
    text = " ".join(answered(run_of(tmp_path, program, seconds=5), "show joy").words("en"))
    assert "had run for 2 s, more than 2 s" not in text
    assert "more than 2 s" in text
