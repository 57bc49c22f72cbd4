"""Any moment of a run: its line, its variables, its functions and what had happened."""

import pytest

from learnblock.why.moments import Mark, Moments, shown
from logged_runs import logged_example, logged_text

COUNTING = """\
x = 0
numbers = [1]

def add(n):
    x = x + n
    function.sleep(1)
    return x
end

main:
    for i from 0 to 2:
        y = add(i)
        append(numbers, y)
        print(y)
    end
end
"""


@pytest.fixture(scope="module")
def counting(tmp_path_factory):
    return Moments(logged_text(tmp_path_factory.mktemp("counting"), COUNTING).history)


def test_variables_are_those_of_the_moment(counting):
    values = [counting.at(time).shared for time in (0.5, 1.5, 2.5, 3)]
    assert [one["x"] for one in values] == ["0", "1", "3", "3"]
    assert [one.get("y") for one in values] == [None, "0", "1", "3"]
    assert [one["numbers"] for one in values] == ["[1]", "[1, 0]", "[1, 0, 1]", "[1, 0, 1, 3]"]


def test_the_functions_that_run_are_listed_with_their_own_variables(counting):
    moment = counting.at(1.5)
    assert moment.stack == ("add",)
    assert moment.local == {"n": "1"}
    assert counting.at(3).stack == ()


def test_the_line_is_the_one_that_runs(counting):
    assert "sleep" in counting.text_at(1.5)
    assert "for" in counting.text_at(3)


def test_output_is_that_of_the_moment(counting):
    assert [counting.at(time).printed for time in (0.5, 1, 2, 3)] == [0, 2, 4, 6]


def test_a_variable_changes_where_it_gets_another_value(counting):
    # `x = x + 0` gives it the same one.
    assert len(counting.changed("x")) == 3
    assert counting.changed("nothing") == ()


def test_marks_say_what_stands_out(counting):
    assert [mark.text for mark in counting.marks if mark.kind == "print"] == ["0", "1", "3"]


def test_bumps_and_goals_are_marked(tmp_path):
    text = (
        "main:\n    function.expressJoy()\n    function.move_straight(300)\n"
        "    function.sleep(9)\nend\n"
    )
    moments = Moments(logged_text(tmp_path, text).history)
    assert [mark.kind for mark in moments.marks] == ["emotion", "bump"]
    goals = Moments(logged_example("first/bump.bt", "sim-ebo", world="bumper").history).marks
    assert "goal" in {mark.kind for mark in goals}
    assert list(goals) == sorted(goals, key=lambda mark: mark.time)


def test_whens_are_active_from_their_condition_on(tmp_path):
    text = (
        "ready = 0\n"
        "when late = ready > 0:\n    function.sleep(1)\nend\n"
        "when start:\n    function.sleep(2)\n    ready = 1\nend\n"
    )
    moments = Moments(logged_text(tmp_path, text, seconds=4).history)
    assert moments.at(1).whens["late"] == (False, 0.0)
    assert moments.at(3).whens["late"] == (True, 1.0)
    assert Mark(2.0, "when", "late") in moments.marks


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (1.5, "1.5"),
        ("a", "'a'"),
        ([1, [True]], "[1, [True]]"),
        ([1, {"more": 3}], "[1, ... 3 more]"),
        ({"is": "object"}, "<object>"),
        ({"pairs": [["a", 1]]}, "{'a': 1}"),
    ],
)
def test_a_snapshot_is_shown_as_python_would(value, text):
    assert shown(value) == text
