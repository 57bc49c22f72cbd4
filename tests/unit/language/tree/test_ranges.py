import pytest
from hypothesis import given
from hypothesis import strategies as st

from learnblock.language import parse
from learnblock.language.blocktext.format import format as format_program
from learnblock.language.tree.nodes import Assign, Binary, Name, Number, Program, Unary
from learnblock.language.tree.ranges import beyond, direction, last

ENDS = st.recursive(
    st.sampled_from([Number("0"), Number("1"), Number("7"), Number("1.5"), Name("n")]),
    lambda inner: (
        st.builds(Unary, st.just("-"), inner)
        | st.builds(Binary, st.sampled_from("+-"), inner, st.just(Number("1")) | inner)
    ),
    max_leaves=4,
)


def expression(text):
    return parse(f"x = {text}\n").items[0].value


def text(node):
    return format_program(Program((Assign(Name("x"), "=", node),))).removeprefix("x = ").strip()


@given(ENDS, st.sampled_from([1, -1]))
def test_the_last_number_is_restored_from_pythons_end(stop, way):
    # -0 has no separate end: it is the same number as 0.
    assert stop == last(beyond(stop, way), way)


@pytest.mark.parametrize(
    ("stop", "way", "end"),
    [
        ("10", 1, "11"),
        ("-1", 1, "0"),
        ("0", -1, "-1"),
        ("n", 1, "n + 1"),
        ("n - 1", 1, "n"),
        ("n + 1", -1, "n"),
        ("2.5", 1, "2.5 + 1"),
    ],
)
def test_the_end_is_one_after_the_last_number(stop, way, end):
    assert end == text(beyond(expression(stop), way))


def test_a_constant_step_gives_the_direction():
    assert (1, 1, -1, 0) == (
        direction(None),
        direction(Number("2")),
        direction(Unary("-", Number("2"))),
        direction(Name("n")),
    )
