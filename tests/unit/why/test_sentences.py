"""Sentences of an answer."""

from learnblock.why.sentences import FIRST, Draft, quoted
from logged_runs import logged_text

PROGRAM = "# A comment.\nif function.is_bumped():  # near\n    function.stop_bot()\nend\n"


def test_a_line_is_quoted_without_what_every_line_has(tmp_path):
    history = logged_text(tmp_path, PROGRAM, seconds=1, seed=0).history
    assert quoted(history, 2) == "if is_bumped()"
    assert quoted(history, 3) == "stop_bot()"
    assert quoted(history, 99) == ""


def test_a_fact_is_told_once_and_the_least_important_ones_are_behind(tmp_path):
    history = logged_text(tmp_path, PROGRAM, seconds=1, seed=0).history
    telling = Draft(history)
    for line in (3, 3, 2, 1, 4, 5, 6):
        telling.say_of_line("why-ran", line)
    answer = telling.answer()
    assert [one.line for one in answer.sentences] == [3, 2, 1, 4]
    assert len(answer.sentences) == FIRST
    assert [one.line for one in answer.more] == [5, 6]
    assert answer.lines == (3, 2, 1, 4)
