"""What a program does is noted in few events, in batches, and never without end."""

import builtins as builtins_of_python

import msgspec
import pytest

from instrumented import execute
from learnblock.client.clock import WallClock
from learnblock.runtime.log import noting
from learnblock.runtime.log.events import Op, batch_problem
from learnblock.runtime.log.noting import Noting
from learnblock.runtime.log.snapshots import snapshot
from learnblock.runtime.messages import LARGEST_LOGGED


class World:
    """A clock that tells the log its time, as that of a simulated robot."""

    def __init__(self, notes):
        self.instant = 0
        self._notes = notes

    def sleep(self, steps):
        self.instant += steps
        self._notes.woke(self.instant)


def noted(source, **names):
    """Run a program with a log; return its events and its variables."""
    batches = []
    notes = Noting(lambda first, last, events: batches.append((first, last, events)))
    world = World(notes)
    builtins = {**vars(builtins_of_python)}
    notes.install(builtins)
    notes.use_clock(world)
    variables = {"__builtins__": builtins, "sleep": world.sleep, **names}
    execute(source, variables)
    notes.flush()
    events = [tuple(event) for _, _, data in batches for event in msgspec.msgpack.decode(data)]
    return events, variables


def ops(events):
    return [Op(event[0]) for event in events]


def test_a_condition_is_noted_with_its_operands():
    events, _ = noted("x = 3\nif x > 2:\n    y = 1")
    assert events == [
        (Op.AT, 0),
        (Op.WRITE, 0, 3, 0),
        (Op.OPERAND, 2, 3),
        (Op.CONDITION, 1, True),
        (Op.WRITE, 3, 1, 0),
    ]


def test_a_call_of_a_function_is_noted_from_its_call_to_its_result():
    events, _ = noted("def f(a):\n    return a + 1\nx = f(2)")
    assert ops(events[1:]) == [Op.CALLS, Op.ENTER, Op.RETURN, Op.LEAVE, Op.RESULT, Op.WRITE]
    assert events[2][2] == [2]
    assert events[-1][2] == 3


def test_turns_that_are_alike_are_counted():
    events, _ = noted("i = iter([1] * 50 + [0])\nwhile next(i):\n    sleep(2)\nx = 1")
    [counted] = [event for event in events if event[0] == Op.REPEATED]
    turns, ticks = counted[2:]
    conditions = [event for event in events if event[0] == Op.CONDITION]
    assert turns + len(conditions) == 51
    passed = sum(event[1] for event in events if event[0] == Op.PASSED)
    assert passed + ticks == 100


def test_turns_that_differ_in_time_are_kept():
    events, _ = noted("for n in [1, 2, 3, 4]:\n    sleep(n)")
    assert Op.REPEATED not in ops(events)
    assert [event[1] for event in events if event[0] == Op.PASSED] == [1, 2, 3, 4]


def test_what_a_program_does_at_one_moment_is_kept_up_to_a_limit():
    source = "x = 0\nwhile x < 100000:\n    x += 1\nsleep(1)\ny = x"
    events, variables = noted(source)
    assert variables["y"] == 100000
    assert len(events) < noting.MOST_AT_ONE_TIME + 50
    after = ops(events)[ops(events).index(Op.GAP) :]
    assert after[-2:] == [Op.PASSED, Op.WRITE]


def test_equal_turns_without_end_at_one_moment_are_given_up():
    source = "n = iter(range(100000))\nwhile next(n, None) is not None:\n    pass"
    events, _ = noted(source)
    assert len(events) < noting.MOST_AT_ONE_TIME + 50


def test_recursion_ends_with_the_programs_own_error():
    with pytest.raises(RecursionError):
        noted("def f(n):\n    return f(n + 1)\nf(0)")


def test_two_names_of_one_list_have_the_same_identity():
    events, _ = noted("a = [1]\nb = a\nc = [1]")
    a, b, c = (event[3] for event in events if event[0] == Op.WRITE)
    assert a == b != c


def test_a_batch_says_when_it_begins():
    batches = []
    notes = Noting(lambda *batch: batches.append(batch))
    notes.woke(5)
    notes.skill("turn", (90,), {})
    notes.woke(9)
    notes.skill_end("turn")
    notes.flush()
    [(first, last, data)] = batches
    assert (first, last) == (0, 9)
    assert msgspec.msgpack.decode(data) == [
        [Op.AT, 0],
        [Op.PASSED, 5],
        [Op.SKILL, "turn", [90]],
        [Op.PASSED, 4],
        [Op.SKILL_END, "turn"],
    ]


def test_a_real_robots_turns_are_alike_whatever_time_they_take():
    batches = []
    notes = Noting(lambda *batch: batches.append(batch))
    builtins = {**vars(builtins_of_python)}
    notes.install(builtins)
    notes.use_clock(WallClock())
    times = iter([1, 2, 4, 7, 11, 16])

    def go():
        ticks = next(times, 0)
        notes.woke(100 + ticks)
        return ticks > 0

    execute("while go():\n    pass", {"__builtins__": builtins, "go": go})
    notes.flush()
    events = msgspec.msgpack.decode(batches[0][2])
    assert [event[2] for event in events if event[0] == Op.REPEATED] == [4]


@pytest.mark.parametrize(
    ("value", "kept"),
    [
        (3, 3),
        (2**70, {"is": "int"}),
        ("a" * 200, "a" * 97 + "..."),
        ("\udc80", "\\udc80"),
        ([1, [2, [3, [4]]]], [1, [2, {"is": "list"}]]),
        (list(range(100)), [*range(20), {"more": 80}]),
        ({"a": [1]}, {"pairs": [["a", [1]]]}),
        (object(), {"is": "object"}),
    ],
)
def test_a_snapshot_is_small_and_plain(value, kept):
    assert snapshot(value) == kept


def test_a_snapshot_does_not_change_with_its_list():
    values = [1, 2]
    kept = snapshot(values)
    values.append(3)
    assert kept == [1, 2]


def test_too_many_events_are_sent_in_several_batches_in_their_order():
    sent = []
    noting = Noting(lambda *batch: sent.append(batch))
    for number in range(3000):
        noting.sent(str(number), "x" * 100)
        if number % 100 == 0:
            noting.woke(number + 1)
    noting.flush()
    assert max(len(events) for _, _, events in sent) <= LARGEST_LOGGED
    assert {batch_problem(events) for _, _, events in sent} == {""}
    ends = [time for first, last, _ in sent for time in (first, last)]
    assert ends == sorted(ends)
    read = [event for _, _, events in sent for event in msgspec.msgpack.decode(events)]
    assert [event[1] for event in read if event[0] == Op.SENT] == [*map(str, range(3000))]
