import pytest
from hypothesis import given
from hypothesis import strategies as st

from learnblock.simulator.picture import time_bar
from learnblock.simulator.picture.svg import SvgText


@given(st.floats(0, 1000), st.floats(0.1, 3600))
def test_a_few_times_are_named_and_all_are_within_the_run(start, span):
    times = time_bar.ticks(start, start + span)
    assert 2 <= len(times) <= time_bar.TICKS + 1
    assert all(start - 0.01 * span <= time <= start + 1.01 * span for time in times)


def test_times_are_labelled_in_seconds_from_below():
    texts = [s for s in time_bar.drawn(0, 12, (10, 100), 300) if isinstance(s, SvgText)]
    labels = {text.text: text.place[1] for text in texts if text.text != "time"}
    assert ["0 s", "2 s", "4 s", "6 s", "8 s", "10 s", "12 s"] == list(labels)
    assert labels["0 s"] - labels["12 s"] == pytest.approx(300)


def test_a_run_of_no_time_still_has_a_bar():
    assert "0 s" in [s.text for s in time_bar.drawn(0, 0, (10, 100), 300) if isinstance(s, SvgText)]
