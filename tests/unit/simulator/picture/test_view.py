import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from learnblock.simulator.picture.view import HEADER, MARGIN, WIDTH, fitted, round_step

sides = st.floats(200, 10000)
places = st.lists(st.tuples(st.floats(-5000, 5000), st.floats(-5000, 5000)), max_size=4)
NOWHERE = np.empty((0, 2))


@given(sides, sides, places, st.booleans())
def test_floor_and_path_are_on_the_page_below_the_title(width, height, path, bar):
    view = fitted((width, height), np.array(path).reshape(-1, 2), bar=bar)
    for x, y in view.all([*path, (width / 2, height / 2), (-width / 2, -height / 2)]):
        assert MARGIN <= x <= WIDTH - MARGIN
        assert HEADER <= y <= HEADER + view.plot[1]


def test_north_is_up_and_east_is_right():
    view = fitted((2000, 2000), NOWHERE, bar=True)
    (x, y), (east, _), (_, north) = view.all([(0, 0), (100, 0), (0, 100)])
    assert east == pytest.approx(x + 100 * view.scale)
    assert north == pytest.approx(y - 100 * view.scale)


def test_a_heading_turns_an_outline_clockwise():
    view = fitted((2000, 2000), NOWHERE, bar=True)
    [nose] = view.placed([(100, 0)], 10, 20, heading=90)
    assert view.at(10, -80) == pytest.approx(nose)
    [left] = view.placed([(0, 100)], 10, 20, heading=90)
    assert view.at(110, 20) == pytest.approx(left)


@given(st.floats(1e-3, 1e6))
def test_a_round_step_is_the_next_one_two_or_five(least):
    step = round_step(least)
    assert least * 0.999 <= step <= least * 2.51
    assert f"{step:e}"[0] in "125"
