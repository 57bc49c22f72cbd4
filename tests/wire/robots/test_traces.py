"""The trace of a real robot stays small, however often its program polls a sensor."""

import json

import pytest

from emulated import reachable
from learnblock.why.moments import Moments
from learnblock.why.steps import Steps, To
from logged_runs import logged_text

LOOP = "forever:"
ASKS = "if function.is_front_obstacle(100):"
DRIVES = "function.move_straight(40)"
POLLING = f"""\
main:
    {DRIVES}
    {LOOP}
        {ASKS}
            function.turn_right(30)
        else:
            {DRIVES}
        end
    end
end
"""


@pytest.fixture(scope="module", params=["ev3", "thymio"])
def logged(request, tmp_path_factory):
    with reachable(request.param, "empty"):
        return logged_text(tmp_path_factory.mktemp("polling"), POLLING, request.param, seconds=3)


def test_turns_of_a_polling_loop_are_counted(logged):
    lines = logged.recorded.lines
    turns = sum(line["times"] for line in lines if "repeated" in line)
    assert turns > 100
    assert sum(len(json.dumps(line)) for line in lines) < 50 * turns


def test_its_trace_has_a_version_of_its_own(logged):
    assert logged.recorded.conditions["versions"]["trace"] == 3


def test_one_can_still_go_from_line_to_line(logged):
    moments = Moments(logged.history)
    assert moments.text_at(2.9).strip() in (LOOP, ASKS, DRIVES)
    steps = Steps(logged.history, moments)
    place = steps.at(1.5)
    later = steps.go(1, place, To.LINE)
    assert later is not None
    assert steps.go(-1, later, To.LINE) <= place
