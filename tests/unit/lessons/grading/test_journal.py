"""The journal keeps what is finished, however the grading ends."""

import pytest

from learnblock.errors import LearnBlockError
from learnblock.lessons.grading.journal import NAME, kept_only, opened_journal

ONE, OTHER = "0" * 32, "f" * 32


def test_a_result_is_there_again_after_a_restart(tmp_path):
    with opened_journal(tmp_path) as journal:
        journal.add(ONE, b'{"ended":"finished"}')
    with opened_journal(tmp_path) as journal:
        assert ONE in journal
        assert journal.result(ONE) == b'{"ended":"finished"}'
        assert journal.result(OTHER) is None


@pytest.mark.parametrize("cut", range(1, 60, 7))
def test_a_line_that_was_cut_off_is_left_out_and_written_again(tmp_path, cut):
    with opened_journal(tmp_path) as journal:
        journal.add(ONE, b"{}")
        journal.add(OTHER, b'{"ended":"finished"}')
    file = tmp_path / NAME
    file.write_bytes(file.read_bytes()[:-cut])
    with opened_journal(tmp_path) as journal:
        assert OTHER not in journal
        journal.add(OTHER, b'{"ended":"error"}')
    with opened_journal(tmp_path) as journal:
        assert journal.result(OTHER) == b'{"ended":"error"}'


def test_lines_that_are_none_of_ours_are_left_out(tmp_path):
    (tmp_path / NAME).write_bytes(b'nonsense\n["zz", {}]\n[1]\n')
    with opened_journal(tmp_path) as journal:
        assert len(journal) == 0


def test_two_gradings_cannot_use_one_folder_at_the_same_time(tmp_path):
    in_use = pytest.raises(LearnBlockError, match="Another grading")
    with opened_journal(tmp_path), in_use, opened_journal(tmp_path):
        pass


def test_only_the_results_of_some_pieces_are_kept(tmp_path):
    with opened_journal(tmp_path) as journal:
        journal.add(ONE, b'{"ended":"finished"}')
        journal.add(OTHER, b'{"ended":"error"}')
    kept_only(tmp_path, {ONE})
    with opened_journal(tmp_path) as journal:
        assert (journal.result(ONE), journal.result(OTHER)) == (b'{"ended":"finished"}', None)
        assert len(journal) == 1
