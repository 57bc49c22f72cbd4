"""What calls of skills make the wheels do."""

import pytest

from learnblock.runtime.log.instrumenting import instrument
from learnblock.why.steering import may_do, movement_of


def node(call):
    return instrument(call).nodes[0]


@pytest.mark.parametrize(
    ("call", "movement"),
    [
        ("robot.turn(90)", "spin-right"),
        ("robot.turn(-90)", "spin-left"),
        ("robot.set_move(-60, 0)", "back"),
        ("robot.set_move(x, 0)", "forward"),
        ("robot.move_straight(-5)", "back"),
        ("robot.stop_bot()", "stand"),
        ("robot.expressJoy()", None),
    ],
)
def test_a_call_moves_the_robot_by_its_name_and_numbers(call, movement):
    assert movement_of(node(call)) == movement


def test_a_question_need_not_tell_a_curve_from_turning_on_the_spot():
    assert may_do(node("robot.move_left()"), "spin-left")
    assert may_do(node("robot.turn(20)"), "")
    assert not may_do(node("robot.stop_bot()"), "")
