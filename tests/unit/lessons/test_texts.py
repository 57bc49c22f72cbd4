"""The texts of a lesson."""

import pytest

from learnblock.lessons.texts import drawn_blocks


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("Drive.\n\n```blocks\nfunction.turn(90)\n```\n", ["function.turn(90)\n"]),
        ("``` blocks \na()\nb()\n``` \nand\n```blocks\nc()\n```", ["a()\nb()\n", "c()\n"]),
        ("```python\nx = 1\n```\n", []),
        ("```blocks\nnever closed", []),
        ("no blocks", []),
    ],
)
def test_blocks_are_found_in_markdown(text, found):
    assert list(drawn_blocks(text)) == found
