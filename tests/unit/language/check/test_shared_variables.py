"""The check says where a shared variable surprises, and only there."""

import pytest

from learnblock.blocks import builtin
from learnblock.language import check, from_python, parse


def reported(text):
    """The line and the message of each shared variable that should be local."""
    found = check(parse(text), builtin())
    return [(one.line, one.message.code) for one in found if one.code == "shared-variable"]


def function(name, *lines):
    return f"def {name}:\n" + "".join(f"    {line}\n" for line in lines) + "end\n"


COUNTING = ("i = 0", "while i < 4:", "    print(i)", "    i += 1", "end")


@pytest.mark.parametrize(
    "after",
    [
        ("print(factorial(n - 1))", "return k"),
        ("return factorial(n - 1) * k",),
        ("return [factorial(n - 1), k]",),
        ("print(`[factorial(m) for m in [n - 1]]`)", "print(k)"),
    ],
)
def test_what_a_function_needs_after_it_has_called_itself_should_be_local(after):
    text = function("factorial(n)", "if n == 0:", "    return 1", "end", "k = n", *after)
    assert [(5, "check-shared-in-recursion")] == reported(text + "print(factorial(5))\n")
    assert [] == reported(text.replace("    k = n", "    local k = n") + "print(factorial(5))\n")


def test_a_counter_of_a_function_that_calls_itself_in_its_loop_should_be_local():
    text = function("tree(n)", "i = 0", "while i < n:", "    tree(n - 1)", "    i += 1", "end")
    assert [(2, "check-shared-in-recursion")] == reported(text + "tree(3)\n")


def test_a_function_may_call_itself_through_another_one():
    text = function("even(n)", "k = n", "odd(n - 1)", "print(k)") + function(
        "odd(n)", "if n > 0:", "    even(n - 1)", "end"
    )
    assert [(2, "check-shared-in-recursion")] == reported(text + "even(4)\n")


@pytest.mark.parametrize(
    "text",
    [
        # Used before the call, or set again after it.
        function("f(n)", "k = n", "return k * f(n - 1)"),
        function("f(n)", "k = n", "f(n - 1)", "k = n", "print(k)"),
        function("f(n)", "rest = f(n - 1)", "rest *= n", "return rest"),
        function("f(n)", "result = n", "result *= f(n - 1)", "return result"),
        # Meant for all calls: it is counted, or read where the function is called.
        "total = 0\n" + function("f(n)", "total += n", "f(n - 1)", "print(total)"),
        function("f(n)", "k = n", "f(n - 1)", "k = k + 1") + "f(3)\nprint(k)\n",
        # The inner call sets the same value, or answers with it.
        function("f(n)", "speed = 40", "f(n - 1)", "print(speed)"),
        function("f(n)", "k = n", "g(n)", "print(k)") + function("g(n)", "k = 2 * n", "f(n - 1)"),
        # Of the function itself: parameters and loop variables.
        function("f(n)", "f(n - 1)", "for i from 1 to n:", "    f(i)", "    print(n + i)", "end"),
        # Python may do anything with it.
        function("f(n)", "k = n", "f(n - 1)", "`k, j = 1, 2`", "print(k)"),
    ],
)
def test_a_variable_that_all_calls_may_share_is_not_reported(text):
    assert [] == reported(text)


@pytest.mark.parametrize(
    ("loop", "line"),
    [
        ("i = 0\nwhile i < 3:\n    square()\n    i += 1\nend\n", 10),
        ("i = 0\nrepeat 3:\n    square()\n    i = i + 1\nend\n", 10),
        ("for i from 1 to 3:\n    square()\n    print(i)\nend\n", 9),
        (function("dance()", "i = 0", "while i < 3:", "    square()", "    i += 1", "end"), 11),
    ],
)
def test_a_counter_should_be_local_if_a_loop_that_calls_its_function_has_it_too(loop, line):
    text = function("square()", *COUNTING) + loop
    (found,) = [one for one in check(parse(text), builtin()) if one.code == "shared-variable"]
    assert (2, "check-shared-counter", str(line)) == (
        found.line,
        found.message.code,
        found.message.values["line"],
    )


@pytest.mark.parametrize(
    "text",
    [
        # A function that starts the count again, and one that counts for others.
        function("reset()", "i = 0") + "i = 0\nwhile i < 9:\n    reset()\n    i += 1\nend\n",
        function("count()", *COUNTING) + "i = 0\ncount()\nprint(i)\n",
        function("step()", "i += 1") + "i = 0\nwhile i < 9:\n    step()\nend\n",
        # One loop after the other.
        function("square()", *COUNTING) + "square()\ni = 0\nwhile i < 3:\n    i += 1\nend\n",
        function("square()", *COUNTING) + "for i from 1 to 3:\n    square()\nend\n",
    ],
)
def test_a_counter_that_two_parts_mean_to_share_is_not_reported(text):
    assert [] == reported(text)


def test_a_counter_should_be_local_if_another_event_counts_with_its_name():
    seen = "when seen = function.is_any_tag():\n    i += 1\nend\n"
    near = "when near = function.is_front_obstacle():\n{}end\n"
    counting = near.format("".join(f"    {line}\n" for line in COUNTING))
    resetting = near.format("    i = 0\n    print(i)\n")
    assert [(6, "check-shared-by-events")] == reported("i = 0\n" + seen + counting)
    assert [] == reported("i = 0\n" + seen + resetting)
    assert [] == reported(seen + counting.replace("near = function.is_front_obstacle()", "start"))


def test_what_python_declares_global_is_reported_at_the_line_that_sets_it():
    text = (
        "def tree(n):\n    global k\n    k = n\n    if n > 0:\n        tree(n - 1)\n    print(k)\n"
        "\n\ntree(3)\n"
    )
    (found,) = check(from_python(text), builtin(), python=text)
    assert (3, "check-shared-in-recursion-python") == (found.line, found.message.code)


@pytest.mark.parametrize(("value", "lines"), [("k", []), ("k + 0", []), ("n", [3])])
def test_a_variable_whose_own_value_is_used_belongs_to_others_too(value, lines):
    body = ("if n > 0:", f"    k = {value}", "    f(n - 1)", "    print(k)", "end")
    text = "k = 1\n" + function("f(n)", *body) + "f(3)\n"
    assert lines == [line - 1 for line, _ in reported(text)]
