"""The values beside the lines of a program, at a place in its run."""

import pytest

from learnblock.why.moments import Moments
from learnblock.why.steps import START, Steps, To
from learnblock.why.values_there import values_there
from logged_runs import logged_text

PROGRAM = """\
limit = 500
seen = 0
def look(far):
    here = seen + far
    if function.get_min_distance() < far:
        seen += 1
    end
    function.sleep(1)
end
main:
    look(limit)
    look(2000)
end
"""


@pytest.fixture(scope="module")
def history(tmp_path_factory):
    return logged_text(tmp_path_factory.mktemp("looking"), PROGRAM).history


def beside(history, time, text):
    """The values at a time, by the text of their line, while the line with `text` runs."""
    lines = history.program.python.splitlines()
    line = next(number for number, one in enumerate(lines, 1) if text in one)
    found = values_there(history, Moments(history), history.at(time), line)
    return {(lines[one.line - 1].strip(), one.name): one.value for one in found}


def test_a_value_is_beside_the_line_that_gave_it(history):
    found = beside(history, 1.5, "sleep")
    assert found["here = seen + far", "here"] == "2000"
    assert found["def look(far):", "far"] == "2000"


def test_what_a_line_says_itself_is_not_repeated(history):
    assert ("limit = 500", "limit") not in beside(history, 0.5, "sleep")


def test_before_the_first_event_there_are_no_values(history):
    assert values_there(history, Moments(history), -1, 0) == []


def test_the_line_that_ran_shows_what_it_reads_measures_and_decides(history):
    moments = Moments(history)
    steps = Steps(history, moments)
    tick, event = steps.go(1, START, To.LINE)
    while "if " not in text_of(history, steps.line_at((tick, event))):
        tick, event = steps.go(1, (tick, event), To.LINE)
    line = steps.line_at((tick, event))
    found = [one for one in values_there(history, moments, event, line) if one.line == line]
    assert [one.name for one in found] == ["far", "get_min_distance()", ""]
    assert found[0].value == "500"
    assert found[-1].value == str(float(found[1].value) < 500)


def text_of(history, line):
    return history.program.python.splitlines()[line - 1]
