"""An instrumented program does the same in the same lines, and tells what it does."""

import contextlib

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from instrumented import execute
from learnblock.runtime.lines import line_events
from learnblock.runtime.log import instrumenting
from learnblock.runtime.log.instrumenting import NOTING, instrument
from learnblock.runtime.log.nodes import Kind
from statement_streams import STREAMS

#: Notes nothing.
SILENT = {
    **dict.fromkeys(NOTING, {}.get),
    instrumenting.CONDITION: lambda _, value: bool(value),
    instrumenting.LOOP: lambda _, value: bool(value),
}


def lines_of(source):
    """The statements that begin while the instrumented program runs."""
    seen = []
    code = compile(instrument(source).tree, "program.py", "exec")
    variables = {"__name__": "program", "c": contextlib.nullcontext, **SILENT}
    with line_events(code, source, seen.append):
        exec(code, variables)  # noqa: S102 - our own programs
    return seen


@pytest.mark.parametrize("name", STREAMS)
def test_an_instrumented_program_runs_through_the_same_statements(name):
    source, expected = STREAMS[name]
    assert lines_of(source) == expected


@pytest.mark.parametrize(
    "source",
    [
        "def f(a, *b, **c):\n    'text'\n    global x\n    x = a\n    return x\ny = f(1, 2, d=3)",
        "def g():\n    yield 1\n    yield 2\nx = [*g()]",
        "class A:\n    def f(self):\n        return self\nx = A().f() is not None",
        "x, (y, z) = 1, (2, 3)\n[a, *b] = [4, 5, 6]",
        "x = [1, 2]\nx[0] += 5\nx[1:] = [7]\nx.append(8)\ny = x.pop()",
        "x = {'a': 1}\nx['b'] = 2\nx.update(c=3)\ndel x['a']",
        "x = 0\nfor i, j in zip('ab', [1, 2]):\n    x += j\nelse:\n    x = -x",
        "x = 3\nwhile x:\n    x -= 1\n    if x == 1:\n        break\nelse:\n    x = 9",
        "x = [i * 2 for i in range(4) if i % 2]\ny = (lambda a: a + 1)(2)\nz = f'{x} {y!r:>5}'",
        "try:\n    1 / 0\nexcept ZeroDivisionError as e:\n    x = str(e)\nfinally:\n    y = 2",
        "x: int = 4\ny: str\nassert x == 4\nz = 1 if x > 3 else 2",
        "def f(n):\n    if n < 1:\n        return 0\n    return n + f(n - 1)\nx = f(20)",
        "def f():\n    x = 1\n    def g():\n        nonlocal x\n        x += 1\n        return x\n"
        "    return g()\ny = f()",
        "x = 5\nmatch x:\n    case 5 if x > 4:\n        y = 1\n    case _:\n        y = 2",
        "x = y = 1\nx, y = y + 1, x\nz = not x and y or 3",
    ],
)
def test_an_instrumented_program_ends_with_the_same_variables(source):
    plain = execute(source, {}, told=False)
    told = execute(source, dict(SILENT))
    kinds = (int, str, list, tuple, dict)
    kept = {name: value for name, value in plain.items() if isinstance(value, kinds)}
    assert {name: told[name] for name in kept if name != "__builtins__"} == {
        name: value for name, value in kept.items() if name != "__builtins__"
    }


def test_an_error_is_in_the_same_line():
    source = "x = 1\ndef f(a):\n    if a:\n        return 1 / 0\nf(\n    x)"
    with pytest.raises(ZeroDivisionError) as raised:
        execute(source, dict(SILENT))
    own = [one for one in raised.traceback if str(one.path).endswith("program.py")]
    assert [one.lineno + 1 for one in own] == [5, 4]


def test_nodes_know_what_they_are_in_and_what_they_read_and_write():
    source = "x = 0\ndef step(n):\n    global x\n    while x < n:\n        x += 1\nstep(3)"
    nodes = instrument(source).nodes
    kinds = [node.kind for node in nodes]
    assert kinds == [
        Kind.ASSIGN,
        Kind.FUNCTION,
        Kind.WHILE,
        Kind.NAME,
        Kind.NAME,
        Kind.ASSIGN,
        Kind.CALL,
    ]
    _, step, loop, _, _, add, call = nodes
    assert (step.name, step.parameters, step.line, step.end) == ("step", ("n",), 2, 5)
    assert (loop.function, loop.control, loop.reads, loop.end) == (1, -1, ("x", "n"), 5)
    assert (add.control, add.branch, add.writes, add.text) == (2, True, ("x",), "x += 1")
    assert (call.name, call.base, call.function) == ("step", "", -1)


def test_the_condition_of_a_when_carries_its_name():
    source = "@robot.when(lambda: robot.is_front_obstacle(90))\ndef bump():\n    pass"
    condition, _, when, _ = instrument(source).nodes
    assert (condition.kind, condition.name) == (Kind.WHEN, "bump")
    assert (when.kind, when.is_when) == (Kind.FUNCTION, True)


@settings(deadline=None)
@given(st.text(alphabet="abx= +-()[]:\n 01.\t'\"#,*", max_size=60))
def test_any_text_is_instrumented_or_is_no_python(source):
    try:
        compile(source, "program.py", "exec")
    except (SyntaxError, ValueError, MemoryError, RecursionError, OverflowError):
        return
    compile(instrument(source).tree, "program.py", "exec")
