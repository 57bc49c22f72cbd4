"""Why a run was over."""

import pytest

from asked import answered, run_of, told

WAITS = "function.stop_bot()\nfunction.sleep(3)\nfunction.move_straight(50)\nfunction.sleep(60)\n"


@pytest.fixture(scope="module")
def history(tmp_path_factory):
    return run_of(tmp_path_factory.mktemp("run"), WAITS)


def test_a_run_that_goes_on_is_not_said_to_have_been_stopped(history):
    given = answered(history, "at 6")
    assert told(given) == [("why-moved", 3), ("why-busy", 4), ("why-after", 2)]


def test_a_run_that_was_stopped_is_said_to_be_at_its_end(history):
    assert told(answered(history, "at 12"))[0] == ("why-time-limit", 0)
    assert told(answered(history, "why did the program end?"))[0] == ("why-time-limit", 0)


def test_an_error_is_not_told_of_a_moment_before_it(tmp_path):
    history = run_of(tmp_path, "function.stop_bot()\nfunction.sleep(5)\nprint(1 / 0)\n")
    assert "why-failed" not in dict(told(answered(history, "at 3")))
    assert told(answered(history, "at 5"))[0][0] != "why-busy"
    assert told(answered(history, "not line 3"))[0] == ("why-failed", 3)
