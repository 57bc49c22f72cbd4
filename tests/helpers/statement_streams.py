"""Programs whose lines Python's versions report differently, and the statements that begin.

Any Python runs this file, with nothing installed: it prints the streams as JSON.
"""

import contextlib
import json

from learnblock.runtime.lines import line_events

#: The source and the first line of each statement that begins, in order.
STREAMS = {
    "a lambda": ("f = lambda: 3\nf()\nf()", [1, 2, 3]),
    "the condition of a when": (
        "def when(c):\n    c()\n    return lambda f: f\n@when(lambda: 1)\ndef f():\n    pass\nf()",
        [1, 4, 2, 3, 5, 4, 5, 7, 6],
    ),
    "a lambda of several lines": ("f = lambda: (1 +\n    len('a') +\n    3)\nf()", [1, 4]),
    "a function in a line": ("def f(): return 1\nf()", [1, 2]),
    "the start of a class": ("class A:\n    x = 1\nA()", [1, 2, 3]),
    "the defaults of a function": (
        "def d(f):\n    return f\n@d\n@d\ndef f(\n    a,\n    b=len('a'),\n):\n    return a\nf(1)",
        [1, 3, 4, 5, 4, 2, 3, 2, 5, 10, 9],
    ),
    "an annotation without a value": ("class A:\n    x: int\n    y: int = 2\nA()", [1, 3, 4]),
    "a list of one line": ("x = [i for i in range(3) if i]\ny = 1", [1, 2]),
    "a list of several lines": (
        "x = [\n    i\n    for i in range(3)\n    if i\n]\ny = 1",
        [1, 6],
    ),
    "a generator of several lines": ("x = sum(\n    i\n    for i in range(3)\n)\ny = 1", [1, 5]),
    "a call of several lines": ("x = max(\n    1,\n    max(2, 3),\n)\ny = 1", [1, 5]),
    "a choice of several lines": ("x = (1\n    if len('')\n    else 2)\ny = 1", [1, 4]),
    "a condition of several lines": (
        "x = 0\nwhile (x < 2\n    and len('a')):\n    x += 1\n"
        "if not (x or\n    x):\n    y = 2\nz = 1",
        [1, 2, 4, 2, 4, 2, 5, 8],
    ),
    "a with of several lines": (
        "with c() as a, \\\n     c() as b:\n    x = 1\ny = 1",
        [1, 3, 1, 4],
    ),
    "a for in a line": ("for i in range(3): x = i\ny = 1", [1, 2]),
    "a while in a line": ("x = 0\nwhile x < 3: x += 1\ny = 1", [1, 2, 3]),
    "an endless loop in a line": (
        "n = iter('ab')\ntry:\n    while True: next(n)\nexcept StopIteration:\n    y = 1",
        [1, 2, 3, 4, 5],
    ),
    "an endless loop around one statement": (
        "n = iter('ab')\ntry:\n    while True:\n        next(\n            n)\n"
        "except StopIteration:\n    y = 1",
        [1, 2, 3, 4, 3, 4, 3, 4, 6, 7],
    ),
    "two statements in a line": ("x = 1; y = (\n    2); z = 3\nw = 1", [1, 3]),
    "a function that calls itself": (
        "def f(n):\n    return n and (f(n - 1)\n        or 1)\nf(2)",
        [1, 4, 2, 2, 2],
    ),
    "a generator that is resumed": (
        "def g():\n    while True:\n        yield (\n            1)\n"
        "n = g()\nfor i in range(2):\n    next(n)",
        [1, 5, 6, 7, 2, 3, 6, 7, 2, 3, 6],
    ),
    "a match": (
        "for x in (1, 2):\n    match x:\n        case 1 if len(\n            'a') > 1:\n"
        "            y = 1\n        case _:\n            y = 2\nz = 1",
        [1, 2, 3, 6, 7, 1, 2, 3, 6, 7, 1, 8],
    ),
    "an except of several lines": (
        "try:\n    int('a')\nexcept (KeyError,\n        ValueError) as e:\n    x = 1\n"
        "finally:\n    y = 1",
        [1, 2, 3, 5, 7],
    ),
}


def stream(source: str) -> list[int]:
    """Run a program and return the statements that begin."""
    statements: list[int] = []
    code = compile(source, "program.py", "exec")
    with line_events(code, source, statements.append):
        exec(code, {"__name__": "program", "c": contextlib.nullcontext})  # noqa: S102 - our own
    return statements


if __name__ == "__main__":
    print(json.dumps({name: stream(source) for name, (source, _) in STREAMS.items()}))  # noqa: T201
