"""The limits of one person: one table, which the docs show."""

import re
from pathlib import Path

from learnblock.classroom.limits import LIMITS

PAGE = Path(__file__).parents[3] / "docs" / "class.md"


def test_the_docs_show_the_table():
    section = PAGE.read_text("utf-8").partition("\n## Limits\n")[2].partition("\n## ")[0]
    rows = [
        tuple(map(str.strip, line.strip("|").split("|")))
        for line in section.splitlines()
        if line.startswith("|")
    ]
    assert rows[2:] == [tuple(limit) for limit in LIMITS]


def test_each_limit_is_there_once():
    assert len({limit.what for limit in LIMITS}) == len(LIMITS)
    assert all(re.search(r"\d", limit.most) for limit in LIMITS)
