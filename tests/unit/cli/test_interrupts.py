"""Ctrl-C ends a command in order, whenever it is pressed."""

import signal

import pytest

from learnblock.cli.interrupts import served_until_ctrl_c, stopped_by_signals


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_service_ends_when_it_was_asked_to_before_it_began_to_wait(number, capsys):
    served = []

    def serve():
        with served_until_ctrl_c():
            signal.raise_signal(number)
            served.append("everything")

    with pytest.raises(KeyboardInterrupt):
        serve()
    assert served == ["everything"]
    assert capsys.readouterr().out == "Press Ctrl-C to stop.\n"


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_ends_a_run_in_the_runs_own_way_and_afterwards_means_what_it_did(number):
    before = signal.getsignal(number)
    asked = []
    with stopped_by_signals(lambda: asked.append(number)):
        signal.raise_signal(number)
    assert asked == [number]
    assert signal.getsignal(number) is before
