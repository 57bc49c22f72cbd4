"""Python from elsewhere: steps, breakpoints, variables beside a line, the lines of errors."""

import pytest

from learnblock.runtime.debugger import Debugger
from learnblock.runtime.ending import How
from learnblock.runtime.process import ThreadWorker
from listener import Listener

#: The lines of the robot above each program.
ABOVE = 2
METHOD = """\
class Stack:
    def __init__(self, items):
        self.items = items

    def pop(self):
        last = self.items.pop()
        return last

top = Stack([1, 2]).pop()
"""
TRY = """\
try:
    x = 1 / 0
except ZeroDivisionError as error:
    text = str(error)
else:
    text = ""
finally:
    done = 1
"""
WITH = """\
from contextlib import nullcontext
with nullcontext(3) as x:
    y = x + 1
z = y
"""
FOR_ELSE = """\
for x in [1, 2]:
    pass
else:
    y = x
"""
GENERATOR = """\
def squares(n):
    for x in range(n):
        yield x * x

total = sum(squares(2))
"""
NESTED = """\
def outer(n):
    def inner(k):
        return k * n
    return inner(2)

outer(3)
"""
RECURSION = """\
def factorial(n):
    if n < 2:
        return 1
    rest = factorial(n - 1)
    return n * rest

factorial(2)
"""
COMPREHENSION = """\
def evens(n):
    found = [x for x in range(n)
             if x % 2 == 0]
    return found

evens(4)
"""


class Stepper(Listener):
    """Stops before a line, then takes single steps."""

    def __init__(self, line):
        super().__init__()
        self.lines, self.local, self.shared = [], [], []
        self.debugger = Debugger([line + ABOVE])

    def held(self, line, variables):
        self.lines.append(line - ABOVE)
        self.local.append(variables.local)
        self.shared.append(variables.shared)
        self.debugger.step()


@pytest.fixture
def stepped(run):
    def stepped(source, line):
        stepper = Stepper(line)
        result = run(source, debugger=stepper.debugger, watcher=stepper, worker=ThreadWorker)
        assert result.how is How.FINISHED
        return stepper

    return stepped


@pytest.mark.parametrize(
    ("source", "breakpoint_", "lines"),
    [
        pytest.param(METHOD, 9, [9, 3, 6, 7], id="into the methods of a class"),
        pytest.param(TRY, 2, [2, 3, 4, 8], id="from try to except and finally"),
        pytest.param(WITH, 3, [3, 2, 4], id="out of with"),
        pytest.param(FOR_ELSE, 2, [2, 1, 2, 1, 4], id="to the else of a loop"),
        pytest.param(GENERATOR, 5, [5, 2, 3, 2, 3, 2], id="into a generator"),
        pytest.param(NESTED, 6, [6, 2, 4, 3], id="into a nested function"),
        pytest.param(RECURSION, 7, [7, 2, 4, 2, 3, 5], id="through a recursion"),
    ],
)
def test_steps_follow_python(stepped, source, breakpoint_, lines):
    assert stepped(source, breakpoint_).lines == lines


@pytest.mark.parametrize(
    ("source", "line", "local"),
    [
        pytest.param(METHOD, 7, {"last": "2"}, id="a method"),
        pytest.param(NESTED, 3, {"k": "2", "n": "3"}, id="a nested function"),
        pytest.param(RECURSION, 5, {"n": "2", "rest": "1"}, id="a recursion"),
        pytest.param(GENERATOR, 3, {"n": "2", "x": "0"}, id="a generator"),
        pytest.param(COMPREHENSION, 4, {"found": "[0, 2]", "n": "4"}, id="a comprehension"),
    ],
)
def test_local_variables_are_shown_beside_a_paused_line(stepped, source, line, local):
    first = stepped(source, line).local[0]
    assert {name: first[name] for name in local} == local


@pytest.mark.parametrize(
    ("source", "line", "name", "value"),
    [
        pytest.param(TRY, 8, "text", "'division by zero'", id="finally"),
        pytest.param(WITH, 3, "x", "3", id="with"),
        pytest.param(FOR_ELSE, 4, "x", "2", id="the else of a loop"),
    ],
)
def test_variables_of_the_program_are_shown_beside_a_paused_line(
    stepped, source, line, name, value
):
    assert stepped(source, line).shared[0][name] == value


@pytest.mark.parametrize(
    ("source", "line"),
    [
        (METHOD.replace("last = self", "last = 1 / 0 and self"), 6),
        (TRY.replace("done = 1", "done = 1 / 0"), 8),
        (GENERATOR.replace("x * x", "x / 0"), 3),
        (NESTED.replace("k * n", "k / 0"), 3),
    ],
    ids=["a method", "finally", "a generator", "a nested function"],
)
def test_an_error_names_its_line(run, source, line):
    result = run(source)
    assert result.how is How.ERROR
    assert result.ending.line == line + ABOVE
