"""Turns on the child's side of the link, when signals arrive during a message."""

import threading

import pytest

from learnblock.errors import ProgramStopped
from learnblock.runtime.turn import Turn


def test_a_signal_during_a_message_is_raised_at_its_end():
    turn, stopped = Turn(), ProgramStopped("stopped")
    turn.take()
    assert turn.postpone(stopped)
    with pytest.raises(ProgramStopped) as raised:
        turn.give_back()
    assert raised.value is stopped


def test_a_signal_outside_a_turn_is_raised_at_once():
    turn = Turn()
    with turn:
        pass
    assert not turn.postpone(ProgramStopped("stopped"))


def test_a_signal_while_the_turn_is_taken_is_not_lost():
    turn, stopped = Turn(), ProgramStopped("stopped")
    with turn:
        assert turn.postpone(stopped)
        with pytest.raises(ProgramStopped):
            turn.take(wait=False)


def test_a_signal_may_interrupt_the_description_of_a_variable():
    turn = Turn()
    with turn:
        turn.forbidden_to = threading.get_ident()
        assert not turn.postpone(ProgramStopped("stopped"))
