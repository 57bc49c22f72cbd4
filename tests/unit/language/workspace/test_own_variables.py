"""A variable that only one function uses is its own, if the page has made the function so."""

import msgspec
import pytest

from learnblock.language import format as format_program
from learnblock.language import from_workspace, parse, to_python, to_workspace
from learnblock.language.workspace.own_variables import MARK
from workspaces import CONFIGURATIONS, blocks

FACTORIAL = """\
def factorial(n):
    if n < 2:
        return 1
    end
    rest = n - 1
    smaller = factorial(rest)
    return n * smaller
end

main:
    print(factorial(5))
end
"""
LOCAL = FACTORIAL.replace("rest =", "local rest =").replace("smaller =", "local smaller =")


def made(text):
    """The blocks of a program whose functions the page has made."""
    workspace = to_workspace(parse(text), CONFIGURATIONS).workspace
    for block in definitions(workspace):
        block.extraState = {**(block.extraState or {}), MARK: True}
    return workspace


def definitions(workspace):
    return [first for first, *_ in workspace.stacks if first.type.startswith("procedures_def")]


def read(workspace):
    found = from_workspace(workspace, CONFIGURATIONS)
    assert not found.problems
    return found.program


def is_marked(workspace):
    return [bool((block.extraState or {}).get(MARK)) for block in definitions(workspace)]


def function(*lines, elsewhere="f()"):
    body = "\n".join(f"    {line}" for line in lines)
    return f"def f():\n{body}\nend\n\nmain:\n    {elsewhere}\nend\n"


def test_each_call_of_a_function_has_variables_of_its_own(capsys):
    program = read(made(FACTORIAL))
    assert format_program(program) == LOCAL
    python = to_python(program).text
    assert "global" not in python
    exec(python.partition("Robot()\n")[2], {})  # noqa: S102 - our own program
    assert capsys.readouterr().out == "120\n"


def test_a_function_that_the_page_has_not_made_so_shares_its_variables():
    workspace = to_workspace(parse(FACTORIAL), CONFIGURATIONS).workspace
    assert format_program(read(workspace)) == FACTORIAL


@pytest.mark.parametrize(
    "text",
    [
        function("x = 1", "print(x)", elsewhere="print(x)"),
        function("x = x + 1", elsewhere="f()"),
        function("print(x)", "x = 1", elsewhere="f()"),
        function("if pi() > 3:", "x = 1", "end", "print(x)", elsewhere="f()"),
        function("x = 1", "print(`x`)", elsewhere="f()"),
        function("x += 1", elsewhere="f()"),
    ],
    ids=[
        "used elsewhere",
        "needs its value before",
        "read before it is set",
        "set in some calls only",
        "used in Python",
        "only changed",
    ],
)
def test_a_variable_whose_value_may_come_from_elsewhere_stays_shared(text):
    assert read(made(text)) == parse(text)


@pytest.mark.parametrize("opener", ["repeat 3:", "if pi() > 3:", "forever:"])
def test_a_variable_of_a_part_is_local_if_that_part_sets_it_first(opener):
    rest = ("x += 2", "print(x)", "end")
    program = read(made(function(opener, "x = 1", *rest)))
    assert program == parse(function(opener, "local x = 1", *rest))


def test_blocks_of_an_edited_program_look_as_before_and_mean_what_the_text_says():
    before = made(FACTORIAL)
    text = LOCAL.replace("n - 1", "n - 2")
    after = to_workspace(parse(text), CONFIGURATIONS, before).workspace
    assert format_program(read(after)) == text
    assert is_marked(after) == [True]
    assert not [block for block in blocks(after) if block.type == "lb_set_local"]
    kept = {block.id for block in blocks(before, shadows=False)}
    assert kept <= {block.id for block in blocks(after)}


@pytest.mark.parametrize(
    ("old", "new"),
    [("local rest", "rest"), ("factorial(5)", "rest"), ("local rest = n", "local rest = rest")],
    ids=["shared", "used elsewhere", "read first"],
)
def test_a_text_that_means_something_else_is_kept_and_ends_the_automatic_choice(old, new):
    before = made(FACTORIAL)
    text = LOCAL.replace(old, new)
    after = to_workspace(parse(text), CONFIGURATIONS, before).workspace
    assert format_program(read(after)) == text
    assert is_marked(after) == [False]


def test_blocks_that_are_read_are_not_changed():
    workspace = made(FACTORIAL)
    copy = msgspec.json.encode(workspace)
    program = read(workspace)
    assert to_workspace(program, CONFIGURATIONS, workspace).workspace == workspace
    assert msgspec.json.encode(workspace) == copy
