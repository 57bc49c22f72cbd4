"""Functions that call each other, also two thousand of them in a row."""

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from learnblock.blocks import builtin
from learnblock.language import check, parse, to_python
from learnblock.language.check.call_graph import callers_of, recursive
from modules import reachable

NAMES = "abcdefg"
graphs = st.fixed_dictionaries({name: st.sets(st.sampled_from(NAMES)) for name in NAMES})
LONG = 2000


@given(graphs)
def test_a_recursive_function_reaches_itself(calls):
    assert recursive(calls) == {name for name in NAMES if name in reachable(calls, name)}


@given(graphs, st.sets(st.sampled_from(NAMES)))
def test_callers_reach_what_they_call(calls, names):
    expected = {name for name in NAMES if not names.isdisjoint({name, *reachable(calls, name)})}
    assert callers_of(names, calls) == expected


def chain(last):
    functions = [f"def f{i}():\n    f{i + 1}()\nend\n" for i in range(LONG)]
    return parse("\n".join([*functions, f"def f{LONG}():\n    {last}\nend\n", "f0()\n"]))


def codes(program, python=None):
    return {found.code for found in check(program, builtin(), python=python)}


@pytest.mark.parametrize(
    ("last", "code"),
    [("x = missing", "unknown-name"), ("print(x)\n    x = 1", "unset-variable")],
)
def test_a_long_chain_of_functions_is_followed_to_its_end(last, code):
    assert codes(chain(last)) == {code}


def test_a_long_circle_of_functions_has_no_end():
    assert codes(chain("f0()")) == {"calls-itself"}


def test_a_long_chain_to_a_loop_never_returns():
    program = chain("forever:\n        function.sleep(1)\n    end")
    after = parse("x = 1\n").items
    program = replace(program, items=(*program.items, *after))
    assert "unreachable" in codes(program)


def test_a_long_chain_in_python_is_followed_to_its_end():
    program = chain("print(x)\n    x = 1")
    assert "python-slip" in codes(program, to_python(program).text)
