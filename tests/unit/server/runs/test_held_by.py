"""Why a program is held before a line."""

import pytest

from learnblock.server.runs.playing import Playing


class Played:
    def python_line(self, block):
        return {"b5": 5, "b7": 7}.get(block)


class Run:
    """Takes the commands of the debugger."""

    def pause(self):
        pass

    resume = step = step_over = pause

    def set_breakpoints(self, lines):
        pass


def playing(**options):
    return Playing(Played(), Run(), None, breakpoints=frozenset({5}), **options)


def test_a_breakpoint_is_the_reason_even_after_a_step():
    one = playing()
    one.step(over=False)
    assert one.held_by(5) == "breakpoint"


@pytest.mark.parametrize("over", [True, False])
def test_after_a_step_the_step_is_the_reason(over):
    one = playing()
    one.step(over=over)
    assert one.held_by(6) == "step"


def test_a_program_that_is_paused_is_held_for_that():
    one = playing()
    one.step(over=False)
    one.pause()
    assert one.held_by(6) == "pause"


def test_a_program_that_begins_with_a_step_is_held_for_that():
    assert playing(paused=True).held_by(1) == "step"


def test_breakpoints_that_are_set_while_it_runs_count():
    one = playing()
    one.set_breakpoints(["b7"])
    assert [one.held_by(5), one.held_by(7)] == ["pause", "breakpoint"]
