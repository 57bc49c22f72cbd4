"""What the types of values show before the run, compared with what Python does in the run."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from learnblock.language import check, format, parse, to_python  # noqa: A004
from learnblock.language.tree.nodes import (
    Assign,
    Binary,
    Call,
    Compare,
    Constant,
    Index,
    List,
    Name,
    Number,
    Perform,
    Program,
    String,
    Unary,
)

ATOMS = st.one_of(
    st.sampled_from(["1", "2", "0.5"]).map(Number),
    st.sampled_from(["a", "3"]).map(String),
    st.sampled_from([True, False]).map(Constant),
    st.sampled_from([(), (Number("1"),), (String("a"),)]).map(List),
    st.sampled_from(["x", "y"]).map(Name),
)


def expressions(inner):
    return st.one_of(
        st.builds(Binary, st.sampled_from(["+", "-", "*", "/", "%"]), inner, inner),
        st.builds(
            lambda operator, left, right: Compare((operator,), (left, right)),
            st.sampled_from(["<", ">="]),
            inner,
            inner,
        ),
        st.builds(Unary, st.sampled_from(["-", "+"]), inner),
        st.builds(Index, inner, inner),
        st.builds(
            lambda name, value: Call(name, (value,)),
            st.sampled_from(["len", "sqrt", "upper", "str", "abs", "sum"]),
            inner,
        ),
    )


VALUES = st.recursive(ATOMS, expressions, max_leaves=6)


@st.composite
def programs(draw):
    """Programs that set two variables and work something out."""
    return Program(
        (
            Assign(Name("x"), "=", draw(ATOMS.filter(lambda node: not isinstance(node, Name)))),
            Assign(Name("y"), "=", draw(ATOMS.filter(lambda node: node != Name("y")))),
            Assign(Name("y"), draw(st.sampled_from(["=", "+="])), draw(VALUES)),
            Perform(Call("str", (draw(VALUES),))),
        )
    )


@pytest.mark.filterwarnings("ignore::SyntaxWarning")
@given(programs())
def test_what_is_reported_as_an_error_ends_the_program(program):
    text = format(program)
    errors = [one for one in check(parse(text), {}) if one.severity == "error"]
    python = to_python(program).text.partition("Robot()")[2]
    if errors:
        with pytest.raises((TypeError, AttributeError, ZeroDivisionError, ValueError, IndexError)):
            exec(f"import math, random, statistics\n{python}", {})  # noqa: S102


@pytest.mark.parametrize(
    "program",
    [
        'n = input("?")\nn = int(n)\nrepeat n: print(n) end\n',
        'x = None\nx = input("?")\nprint(x + 1)\n',
        'def f(n): return n + 1 end\nn = "a"\nprint(f(2), n)\n',
        'x = "a"\npython:\n    x = 3\nend\nprint(x + 1)\n',
        'import "mine"\nx = "a"\nprint(x - 1)\n',
        "def str(x): return 3 end\nprint(str(2) + 4)\n",
        'print("ab" * 3, "%s" % 4, 3 * [1], True + 1)\n',
        "a = b\nb = a\n",
    ],
)
def test_what_may_work_is_not_reported(program):
    assert "wrong-type" not in [one.code for one in check(parse(program), {})]


def test_text_added_to_a_list_in_place_works_but_is_hardly_meant():
    found = check(parse('names = []\nnames += "Ada"\nprint(names)\n'), {})
    assert [(one.code, one.severity, one.line) for one in found] == [("wrong-type", "warning", 2)]


def test_the_types_of_a_long_chain_of_variables_are_uncertain():
    chain = "".join(f"x{number} = x{number + 1}\n" for number in range(50))
    found = check(parse(f'{chain}x50 = "a"\nprint(x0 - 1)\n'), {})
    assert "wrong-type" not in [one.code for one in found]


@pytest.mark.parametrize(
    "text",
    [
        "repeat 10 / 2:\n    print(1)\nend\n",
        "repeat 2 * (10 / 2):\n    print(1)\nend\n",
        "repeat sqrt(9):\n    print(1)\nend\n",
        "for i from 0 to 10 / 2:\n    print(i)\nend\n",
        "print([1, 2][2 / 2])\n",
        "print(random(1, 10 / 2))\n",
    ],
)
def test_a_value_with_decimals_is_no_whole_number(text):
    assert ["check-decimals"] == [one.message.code for one in check(parse(text), {})]


@pytest.mark.parametrize(
    "count", ["10 // 2", "int(10 / 2)", "round(10 / 2)", "len([1]) + 2", "0xE"]
)
def test_a_whole_number_may_be_calculated(count):
    assert [] == check(parse(f"repeat {count}:\n    print(1)\nend\n"), {})
