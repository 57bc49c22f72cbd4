"""Going through a run: from line to line, event to event, turn to turn, change to change."""

import math

import pytest

from learnblock.runtime import child
from learnblock.runtime.log import noting
from learnblock.why.moments import Moments
from learnblock.why.steps import START, Steps, To
from logged_runs import logged_text

COUNTING = """\
x = 0
def add(n):
    function.sleep(0.5)
    x += n
end
main:
    repeat 2:
        x += 1
        add(2)
        print(x)
        function.sleep(1)
    end
    forever:
        function.sleep(0.1)
        if x > 100:
            x = 0
        end
    end
end
"""


@pytest.fixture(scope="module")
def history(tmp_path_factory):
    return logged_text(tmp_path_factory.mktemp("counting"), COUNTING, seconds=10).history


@pytest.fixture(scope="module")
def steps(history):
    return Steps(history, Moments(history))


def texts(history, steps, *, count, start=START, by=1, to=To.LINE, subject=""):
    """The lines of the places that one goes to, one after the other."""
    place, found = start, []
    for _ in range(count):
        place = steps.go(by, place, to, subject)
        line = steps.line_at(place)
        found.append(history.program.python.splitlines()[line - 1].strip())
    return found


def test_lines_of_one_moment_are_gone_through_one_by_one(history, steps):
    expected = [
        "x = 0",
        "for _ in range(2):",
        "x += 1",
        "add(2)",
        "robot.sleep(0.5)",
        "x += n",
        "print(x)",
        "robot.sleep(1)",
        "for _ in range(2):",
    ]
    first = texts(history, steps, count=10)[1:]
    assert first == expected
    last = steps.at(1.2)
    assert texts(history, steps, count=8, start=last, by=-1) == expected[-2::-1]


def test_there_is_nothing_before_the_first_line_and_behind_the_last(history, steps):
    assert steps.go(-1, START, To.LINE) is None
    assert steps.go(1, steps.at(history.end), To.LINE) is None


def test_events_are_finer_than_lines(steps):
    line = steps.go(1, steps.at(0.2), To.LINE)
    event = steps.go(1, steps.at(0.2), To.EVENT)
    assert event < line


def test_a_turn_is_one_of_the_loop_around_the_line(history, steps):
    assert steps.go(1, steps.at(0.2), To.TURN)[0] == 150
    outer = steps.go(1, steps.at(0.7), To.TURN)
    assert outer[0] == 150
    assert steps.go(-1, outer, To.TURN)[0] == 0
    inner = steps.go(1, steps.at(5.02), To.TURN)
    assert inner[0] == pytest.approx(510, abs=1)


def test_turns_that_were_alike_can_be_stepped_through_nevertheless(steps):
    place, ticks = steps.at(5), []
    for _ in range(4):
        place = steps.go(1, place, To.TURN)
        ticks.append(place[0])
    assert ticks == [510, 520, 530, 540]


@pytest.mark.parametrize("wakes", [26, 27, 28, 29])
def test_no_turn_is_left_out_where_a_part_of_the_log_ends(tmp_path, monkeypatch, wakes):
    class Parted(noting.Noting):
        wakes = 0

        def woke(self, ticks):
            self.wakes += 1
            if self.wakes == wakes:
                self.flush()
            super().woke(ticks)

    monkeypatch.setattr(noting, "LONGEST_WAIT", math.inf)
    monkeypatch.setattr(child, "Noting", Parted)
    history = logged_text(tmp_path, COUNTING, seconds=6).history
    steps = Steps(history, Moments(history))
    place, ticks = steps.at(5), []
    for _ in range(4):
        place = steps.go(1, place, To.TURN)
        ticks.append(place[0])
    assert ticks == [510, 520, 530, 540]


def test_a_change_is_where_a_variable_gets_another_value(steps):
    places = []
    place = START
    while place := steps.go(1, place, To.CHANGE, "x"):
        places.append(place[0])
    assert places == [0, 0, 50, 150, 200]
    assert steps.go(1, START, To.CHANGE, "nothing") is None


def test_a_mark_is_of_the_kind_that_is_asked_for(steps):
    assert steps.go(1, START, To.MARK, "print")[0] == 50
    assert steps.go(1, START, To.MARK, "bump") is None
    assert steps.go(1, START, To.MARK)[0] == 50


def test_a_run_of_a_block_is_one_of_its_lines(history, steps):
    line = next(
        number
        for number, text in enumerate(history.program.python.splitlines(), 1)
        if text.strip() == "x += 1"
    )
    places = [steps.go(1, steps.at(time), To.RUN, frozenset({line})) for time in (0.2, 2)]
    assert [place and place[0] for place in places] == [150, None]
