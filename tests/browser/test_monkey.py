"""A short life of the monkey; `tests/browser/monkey.py` lets it live for as long as one likes."""

from browser.monkey import live


def test_the_page_bears_a_monkey(browser, tmp_path):
    diary = live(browser, tmp_path, seed=1, seconds=20)
    assert diary.failure is None, diary
    assert diary.answers
