"""Several pages and an editor change one program; `together.py` lets them do more of it."""

import random

import pytest

from browser.together import drill

pytestmark = pytest.mark.certain


def test_three_pages_and_an_editor_end_with_one_program(browser, tmp_path):
    ended = drill(browser, tmp_path, random.Random(1), 100)  # noqa: S311 - repeatable, not secret
    assert ended.is_equal, ended
