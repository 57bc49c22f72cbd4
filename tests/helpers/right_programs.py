"""Programs made from a lesson's solution that solve the task all the same, each with its reason.

`tests/cases/mutants.toml` has those of `learnblock.lessons.mutants`, `tests/cases/swaps.toml` those
of `learnblock.lessons.swaps`.
"""

import tomllib
from fnmatch import fnmatchcase
from functools import cache
from typing import Any

from places import ROOT


@cache
def known(table: str) -> list[dict[str, Any]]:
    """The differences of a table with which a task is solved all the same."""
    differences: list[dict[str, Any]] = tomllib.loads(
        (ROOT / "tests" / "cases" / f"{table}.toml").read_text("utf-8")
    )["accepted"]
    return differences


def is_right(table: str, lesson: str, step: int, what: str) -> bool:
    """Whether the task is solved with all differences of a program, together or each of them."""
    patterns = [
        pattern
        for entry in known(table)
        if entry["lesson"] == lesson and entry.get("step", step) == step
        for pattern in entry["what"]
    ]
    return what in patterns or all(
        any(fnmatchcase(part, pattern) for pattern in patterns) for part in what.split("; ")
    )
