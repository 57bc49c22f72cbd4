"""The files of a grading: the table and the page, each replaced at once when it is complete."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TextIO

from learnblock.lessons.grading.grading import Grading
from learnblock.lessons.grading.page import Page
from learnblock.lessons.grading.table import write_table

TABLE, PAGE = "results.csv", "results.html"


def write_results(grading: Grading, folder: Path, language: str, *, lesson: str) -> None:
    """Write the table and the page.

    Args:
        grading: the grading; what is not finished is shown as such.
        folder: where to.
        language: of the page.
        lesson: what the teacher called the lesson.
    """
    plan = grading.plan
    checks = plan.opened.step(plan.step).check
    # Spreadsheets take UTF-8 for another encoding without its mark.
    with _replaced(folder / TABLE, "utf-8-sig") as file:
        write_table(file, plan.step, checks, grading.rows())
    with _replaced(folder / PAGE, "utf-8") as file:
        Page(grading, language, lesson).write(file)


@contextmanager
def _replaced(path: Path, encoding: str) -> Iterator[TextIO]:
    part = path.with_name(f".{path.name}.part")
    with part.open("w", encoding=encoding, errors="replace", newline="") as file:
        yield file
    part.replace(path)
