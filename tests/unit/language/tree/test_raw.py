from hypothesis import given
from hypothesis import strategies as st

from learnblock.language.tree import raw

LINES = st.lists(
    st.sampled_from(["", " ", "\t", "end", " end # x", "\\", "\\end", "x", "  x", "\r", "end\r"])
).map("\n".join)


def test_a_line_that_reads_end_is_escaped():
    assert ["    if x:", r"    \end"] == raw.written("if x:\nend\n", "    ")


def test_ordinary_lines_are_not_escaped():
    assert ["  x", "", "    y"] == raw.written("x\n\n  y\n", "  ")


def test_the_indentation_of_a_block_is_removed():
    assert "x\n  y\n" == raw.read("      x\n        y\n")


@given(LINES | st.text(), st.sampled_from(["", "    ", "\t"]))
def test_raw_python_survives_byte_for_byte(text, indent):
    written = "".join(line + "\n" for line in raw.written(text, indent))
    assert text == raw.read(written)
