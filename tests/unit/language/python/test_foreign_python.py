"""Python that was written elsewhere: the scores of the standard library's turtle programs.

The floors may only rise; `scripts/bench foreign_python` prints the scores.
"""

import pytest

from python_scores import TURTLEDEMO, scores_of

STATEMENTS_IN_BLOCKS = 99.9
SOCKETS_IN_BLOCKS = 99.9
FILES_WITHOUT_GREY = 21


@pytest.fixture(scope="module")
def scores():
    return scores_of(sorted(TURTLEDEMO.glob("*.py")))


def test_unedited_files_come_back_byte_for_byte(scores):
    assert scores.kept == scores.files


def test_files_mean_the_same_by_way_of_block_text(scores):
    assert scores.same == scores.files


def test_most_of_their_statements_and_values_are_blocks(scores):
    assert scores.in_blocks >= STATEMENTS_IN_BLOCKS
    assert scores.sockets_in_blocks >= SOCKETS_IN_BLOCKS
    assert scores.ungrey >= FILES_WITHOUT_GREY
