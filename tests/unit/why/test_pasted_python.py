"""Answers about runs of Python from elsewhere."""

import pytest

from asked import answered, told
from logged_runs import logged_file

PASTED = """\
from functools import cache
from contextlib import nullcontext


def outer(n):
    def inner(k):
        doubled = k * 2
        return doubled

    return inner(n) + 1


@cache
def factorial(n):
    if n < 2:
        return 1
    rest = factorial(n - 1)
    return n * rest


try:
    bad = 1 / 0
except ZeroDivisionError as error:
    text = str(error)
finally:
    done = True
with nullcontext(3) as opened:
    inside = opened + 1
for n in range(3):
    if n == 5:
        break
else:
    ended = n
evens = [n for n in range(9) if n % 2 == 0]
result = factorial(4)
deep = outer(4)
print(text, done, inside, ended, evens, result, deep)
"""
ROBOT = "from learnblock.robots.ebo import Robot\n\nrobot = Robot()\n"


@pytest.fixture(scope="module", params=["", ROBOT], ids=["without a robot", "with a robot"])
def history_and_offset(request, tmp_path_factory):
    path = tmp_path_factory.mktemp("pasted") / "pasted.py"
    path.write_text(request.param + PASTED, encoding="utf-8")
    run = logged_file(path, "sim-ebo", world="empty", seconds=12, seed=0)
    return run.history, request.param.count("\n")


@pytest.mark.parametrize(
    ("question", "expected"),
    [
        ("why is text", [("why-set", 24), ("why-set", 23)]),
        ("why is done True?", [("why-set", 26)]),
        ("why is inside 4?", [("why-set", 28), ("why-set", 27)]),
        ("why is ended 2?", [("why-set", 33), ("why-set", 29)]),
        ("why is evens", [("why-set", 34)]),
        ("why is deep 9?", [("why-set", 36), ("why-returned", 10), ("why-returned", 8)]),
        ("why is result 24?", [("why-set", 35), ("why-returned", 18), ("why-given", 35)]),
    ],
    ids=["except", "finally", "with", "for else", "comprehension", "nested", "decorated"],
)
def test_a_value_that_was_set_there_is_explained(history_and_offset, question, expected):
    history, offset = history_and_offset
    found = told(answered(history, question))[: len(expected)]
    assert [(code, line - offset) for code, line in found] == expected
