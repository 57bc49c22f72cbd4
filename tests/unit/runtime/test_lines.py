import sys
import threading

import pytest

from learnblock.client.clock import WallClock
from learnblock.runtime.lines import (
    MOST_LINES_AT_ONE_TIME,
    LineBudget,
    depth,
    line_events,
    program_frame,
    start_line_events,
    without_line_events,
)
from learnblock.runtime.turn import Turn
from learnblock.testing import VirtualClock


def lines_of(source, **names):
    seen = []
    code = compile(source, "program.py", "exec")
    with line_events(code, source, seen.append):
        exec(code, names)  # noqa: S102 - our own
    return seen


@pytest.mark.parametrize(
    ("source", "expected"),
    [
        ("x = 1\ny = 2", [1, 2]),
        ("x = 0\nwhile x < 2:\n    x += 1", [1, 2, 3, 2, 3, 2]),
        ("for i in range(2):\n    x = i\ny = 0", [1, 2, 1, 2, 1, 3]),
        ("def f():\n    return 1\nf()\nf()", [1, 3, 2, 4, 2]),
        ("def f():\n    def g():\n        return 2\n    return g()\nf()", [1, 5, 2, 4, 3]),
        ("if True:\n    x = 1\nelse:\n    x = 2", [1, 2]),
        ("class A:\n    x = 1\n    def f(self):\n        pass\nA().f()", [1, 2, 3, 5, 4]),
        ("try:\n    1 / 0\nexcept ZeroDivisionError:\n    x = 1", [1, 2, 3, 4]),
    ],
)
def test_each_line_is_reported_before_it_runs(source, expected):
    assert lines_of(source) == expected


def test_lines_of_other_files_are_not_reported():
    assert lines_of("import textwrap\ntextwrap.dedent(' a')") == [1, 2]


def test_lines_of_other_threads_are_not_reported():
    def start(function):
        thread = threading.Thread(target=function)
        thread.start()
        thread.join()

    assert lines_of("def f():\n    x = 1\nstart(f)", start=start) == [1, 3]


def test_after_the_end_nothing_is_reported():
    seen = []
    source = "def f():\n    pass"
    code = compile(source, "program.py", "exec")
    names = {}
    with line_events(code, source, seen.append):
        exec(code, names)  # noqa: S102 - our own
    names["f"]()
    assert seen == [1]


def test_line_events_may_begin_while_the_program_runs_in_a_function():
    seen = []
    source = "def main():\n    begin()\n    x = 1\nmain()\ny = 2"
    code = compile(source, "program.py", "exec")
    stops = []

    def begin():
        stops.append(start_line_events(code, source, seen.append, sys._getframe()))

    exec(code, {"begin": begin})  # noqa: S102 - our own
    stops[0]()
    assert seen == [3, 5]


def test_a_statement_in_which_line_events_begin_is_not_reported_again():
    seen, stops = [], []
    source = "def f():\n    begin(\n        1,\n    )\n    x = 1\nf()\ny = 2"
    code = compile(source, "program.py", "exec")

    def begin(_):
        stops.append(start_line_events(code, source, seen.append, sys._getframe()))

    exec(code, {"begin": begin})  # noqa: S102 - our own
    stops[0]()
    assert seen == [5, 7]


def test_an_error_of_the_listener_reaches_the_program():
    def fail(number):
        raise KeyboardInterrupt

    code = compile("x = 1", "program.py", "exec")
    with pytest.raises(KeyboardInterrupt), line_events(code, "x = 1", fail):
        exec(code, {})  # noqa: S102 - our own


def test_the_depth_is_the_number_of_calls_in_a_file():
    depths = []
    source = "def f(n):\n    note()\n    if n: f(n - 1)\nnote()\nf(2)"
    code = compile(source, "program.py", "exec")
    exec(code, {"note": lambda: depths.append(depth("program.py"))})  # noqa: S102 - our own
    assert depths == [1, 2, 3, 4]


def test_a_program_that_does_not_run_has_no_frame():
    assert program_frame("program.py", sys._getframe()) is None


def test_a_budget_limits_the_lines_at_one_time():
    clock, seen = VirtualClock(), []
    budget = LineBudget(clock, seen.append)
    for _ in range(2):
        for number in range(MOST_LINES_AT_ONE_TIME + 50):
            budget(number)
        clock.sleep(1)
    assert seen == 2 * list(range(MOST_LINES_AT_ONE_TIME))


def test_a_budget_says_which_lines_are_beyond_it():
    beyond = []
    budget = LineBudget(VirtualClock(), lambda _: None, beyond=beyond.append)
    for number in range(MOST_LINES_AT_ONE_TIME + 2):
        budget(number)
    assert beyond == [MOST_LINES_AT_ONE_TIME, MOST_LINES_AT_ONE_TIME + 1]


def test_a_budget_counts_by_tenths_of_a_second_in_real_time():
    class Flowing(WallClock):
        now = 0.0

        def time(self):
            return self.now

    clock, seen = Flowing(), []
    budget = LineBudget(clock, seen.append)
    for now in (0.0, 0.05, 0.11):
        clock.now = now
        for _ in range(MOST_LINES_AT_ONE_TIME):
            budget(1)
    assert len(seen) == 2 * MOST_LINES_AT_ONE_TIME


def test_a_call_that_runs_only_other_code_hides_nothing_of_the_program():
    seen = []

    def skill(function=None):
        return function and function()

    quiet = without_line_events(skill, lambda args, _kwargs: not args)
    source = "def f():\n    x = 1\nquiet()\nquiet(f)\nquiet()\nx = 2"
    code = compile(source, "program.py", "exec")
    with line_events(code, source, seen.append):
        exec(code, {"quiet": quiet})  # noqa: S102 - our own

    assert seen == [1, 3, 4, 2, 5, 6]


def test_line_events_go_on_after_a_call_that_hides_them_has_failed():
    seen = []

    def skill():
        raise ValueError

    quiet = without_line_events(skill, lambda *_: True)
    source = "try:\n    quiet()\nexcept ValueError:\n    x = 1\nx = 2"
    code = compile(source, "program.py", "exec")
    with line_events(code, source, seen.append):
        exec(code, {"quiet": quiet})  # noqa: S102 - our own

    assert seen == [1, 2, 3, 4, 5]


def test_a_budget_passes_on_no_lines_of_a_thread_that_describes_a_variable():
    clock, seen, turn = VirtualClock(), [], Turn()
    budget = LineBudget(clock, seen.append, turn)
    budget(1)
    turn.forbidden_to = threading.get_ident()
    budget(2)
    thread = threading.Thread(target=budget, args=(3,))
    thread.start()
    thread.join()
    turn.forbidden_to = None
    budget(4)
    assert seen == [1, 3, 4]
