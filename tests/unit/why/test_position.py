"""Where the program was: in which call, in which loop."""

import pytest

from asked import run_of
from learnblock.runtime.log.events import Op
from learnblock.runtime.log.nodes import Kind
from learnblock.why.history import EventHistory
from learnblock.why.position import Position
from learnblock.why.recorded import Recorded
from learnblock.why.slices import Slices

REPEATED = """\
repeat 2:
    function.move_straight(80)
    function.sleep(2)
end
function.stop_bot()
function.sleep(10)
"""


@pytest.fixture(scope="module")
def history(tmp_path_factory):
    return run_of(tmp_path_factory.mktemp("run"), REPEATED)


def test_a_skill_that_still_lasts_is_the_one_whose_line_ran_last(history):
    standing = Position(Slices(history))
    lasting = history.uses[-1]
    assert lasting.node < 0
    assert history.line(standing.call_of(lasting)) == 6


def test_without_its_lines_a_skill_that_still_lasts_is_any_call_of_it(history):
    recorded = history.recorded
    lines = tuple(line for line in recorded.lines if "line" not in line)
    history = EventHistory(Recorded(recorded.program, recorded.nodes, recorded.batches, lines, {}))
    assert history.line(Position(Slices(history)).call_of(history.uses[-1])) in (3, 6)


def turns_of(history):
    return [index for index, event in enumerate(history.events) if event[0] == Op.TURN]


def test_a_loop_is_over_when_the_program_goes_on_behind_it(history):
    standing, last = Position(Slices(history)), turns_of(history)[-1]
    over = standing.over(last, len(history.events) - 1)
    assert history.time(over) == 4
    assert standing.over(last, over) == -1


def test_a_program_is_not_in_a_loop_that_it_did_not_come_to(history):
    loop = next(n for n, node in enumerate(history.nodes) if node.kind is Kind.FOR)
    assert Position(Slices(history)).loop(loop, turns_of(history)[-1]) == -1


def test_the_last_loop_of_a_program_is_over_with_it(tmp_path):
    history = run_of(tmp_path, "for x in [1, 2]:\n    function.sleep(x)\nend\n")
    turns = turns_of(history)
    last = len(history.events) - 1
    assert Position(Slices(history)).over(turns[-1], last) == last
