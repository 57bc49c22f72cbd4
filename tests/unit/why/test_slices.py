"""The causes of an event: data and control."""

import pytest

from learnblock.runtime.log.events import Op
from learnblock.runtime.log.nodes import Kind
from learnblock.why.slices import Slices
from logged_runs import logged_text


def sliced(folder, program):
    return Slices(logged_text(folder, program, world="empty", seconds=5, seed=0).history)


def events(slices, op, line):
    """The events of an operation on a line."""
    history = slices.history
    return [
        index
        for index, event in enumerate(history.events)
        if event[0] == op and history.line(event[1]) == line
    ]


def line(slices, event):
    return slices.history.line(slices.history.events[event][1])


def test_the_last_write_of_a_name_is_found(tmp_path):
    slices = sliced(tmp_path, "x = 1\nx = 2\nfunction.sleep(1)\nx = 3\n")
    last = len(slices.history.events) - 1
    assert line(slices, slices.last_write("x", last)) == 4
    assert line(slices, slices.last_write("x", slices.history.at(0.5))) == 2


def test_a_parameter_is_not_the_variable_of_the_same_name(tmp_path):
    slices = sliced(tmp_path, "x = 1\ndef f(x):\n    x = x + 1\n    return x\nend\ny = f(5)\n")
    last = len(slices.history.events) - 1
    assert line(slices, slices.last_write("x", last)) == 1
    [returned] = events(slices, Op.RETURN, 4)
    assert line(slices, slices.last_write("x", returned)) == 3


def test_a_list_is_changed_through_another_name(tmp_path):
    slices = sliced(tmp_path, "a = [1]\nb = a\nappend(b, 2)\n")
    last = len(slices.history.events) - 1
    changed = slices.changed_through(slices.last_write("a", last), last)
    assert line(slices, changed) == 3
    assert line(slices, slices.aliased(changed, "b")) == 2


def test_a_result_leads_to_its_return(tmp_path):
    slices = sliced(
        tmp_path, "def f(n):\n    if n > 1: return 1 end\n    return 2\nend\ny = f(0)\n"
    )
    [result] = [
        event for event in events(slices, Op.RESULT, 5) if slices.history.node(event).name == "f"
    ]
    assert line(slices, slices.returned(result)) == 3


def test_the_parts_of_a_condition_are_those_of_its_own_turn_only(tmp_path):
    slices = sliced(
        tmp_path,
        "i = 0\nwhile i < 3 and not function.is_bumped():\n    i += 1\n    print(i)\nend\n",
    )
    for asked in events(slices, Op.CONDITION, 2):
        names = [slices.history.node(part).name for part in slices.parts(asked)]
        assert names in (["i", "is_bumped"], ["i"])


def test_a_statement_is_controlled_by_its_condition(tmp_path):
    slices = sliced(tmp_path, "x = 4\nif x > 3:\n    function.turn_left()\nend\n")
    commands = slices.of_base
    assert line(slices, slices.control(commands[0])) == 2


def test_a_break_ends_the_loop_before_a_statement(tmp_path):
    slices = sliced(tmp_path, "forever:\n    if 1 < 2: break end\nend\nprint(1)\n")
    [printed] = events(slices, Op.RESULT, 4)
    [loop] = slices.loops_ended(printed)
    jump = slices.jump_from(slices.history.events[loop][1], loop, printed)
    assert slices.history.node(jump).kind is Kind.BREAK


@pytest.mark.parametrize("name", ["x", "y"])
def test_what_was_never_written_has_no_write(tmp_path, name):
    slices = sliced(tmp_path, "function.sleep(0.1)\n")
    assert slices.last_write(name, len(slices.history.events) - 1) == -1


def test_the_change_of_a_counter_reads_its_value_before(tmp_path):
    slices = sliced(tmp_path, "n = 0\nrepeat 3:\n    n += 1\nend\n")
    write = slices.last_write("n", len(slices.history.events) - 1)
    assert line(slices, write) == 3
    assert line(slices, slices.write_before(write, "n")) == 1
