"""Crashes while a pupil types; `restarts.py` makes more of them."""

import random

import pytest

from browser.restarts import KINDS, play

pytestmark = pytest.mark.certain


def test_what_was_typed_survives_a_kill_of_browser_and_server(browser, tmp_path):
    chance = random.Random(1)  # noqa: S311 - repeatable, not secret
    for one in play(browser.browser_type, tmp_path, chance, KINDS):
        assert (one.lost_saved, one.lost) == ((), ()), one
