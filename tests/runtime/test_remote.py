"""The child's side of the conversation, when signals arrive in the midst of it."""

import threading

import pytest

from learnblock.errors import ProgramStopped
from learnblock.runtime.remote import Turn


def test_a_signal_in_the_midst_of_a_message_is_raised_at_its_end():
    turn, stopped = Turn(), ProgramStopped("stopped")
    turn.take()
    assert turn.postpones(stopped)
    with pytest.raises(ProgramStopped) as raised:
        turn.give_back()
    assert raised.value is stopped


def test_a_signal_while_nobody_speaks_is_raised_at_once():
    turn = Turn()
    with turn:
        pass
    assert not turn.postpones(ProgramStopped("stopped"))


def test_a_signal_while_the_turn_could_not_be_had_is_not_lost():
    turn, stopped = Turn(), ProgramStopped("stopped")
    with turn:
        assert turn.postpones(stopped)
        with pytest.raises(ProgramStopped):
            turn.take(wait=False)


def test_a_signal_may_interrupt_what_describes_a_variable():
    turn = Turn()
    with turn:
        turn.forbidden_to = threading.get_ident()
        assert not turn.postpones(ProgramStopped("stopped"))
