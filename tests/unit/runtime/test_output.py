import pytest
from hypothesis import given
from hypothesis import strategies as st

from learnblock.runtime.output import LONGEST_LINE, LineStream


def written(*texts):
    lines = []
    writer = LineStream(lines.append)
    for text in texts:
        assert writer.write(text) == len(text)
    writer.finish()
    return lines


def test_lines_are_passed_on_whole_with_their_ends():
    assert written("a\nb", "c\n", "d") == ["a\n", "bc\n", "d"]


@given(st.lists(st.text("ab\n", max_size=9), max_size=9))
def test_nothing_is_lost(texts):
    lines = written(*texts)
    assert "".join(texts) == "".join(lines)
    assert all(line.endswith("\n") for line in lines[:-1])


def test_a_long_line_comes_in_parts():
    lines = written("x" * (2 * LONGEST_LINE + 5))
    assert [len(line) for line in lines] == [LONGEST_LINE, LONGEST_LINE, 5]


def test_print_writes_to_it():
    lines = []
    print("a", 1, file=LineStream(lines.append), flush=True)
    assert lines == ["a 1\n"]


def test_an_unfinished_line_is_passed_on_only_by_flush():
    told = []
    writer = LineStream(told.append, lambda: told.append("seen"))
    writer.write("a")
    assert told == []
    writer.flush()
    assert told == ["a", "seen"]
    writer.flush()
    assert told == ["a", "seen"]


def test_only_text_can_be_written():
    with pytest.raises(TypeError, match="must be str, not bytes"):
        LineStream(print).write(b"x")
