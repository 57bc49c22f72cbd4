"""The marks of a step as a table for spreadsheets and learning platforms."""

import csv
import io
import time
from collections.abc import Iterator

from learnblock.classroom.marking import Marking
from learnblock.lessons.grading.table import harmless
from learnblock.lessons.texts import in_language

#: Spreadsheets take UTF-8 for another encoding without its mark.
ENCODING = "utf-8-sig"
_PLAIN = (
    "pupil", "lesson", "step", "stars", "tries", "mark", "note", "handed_in",
    "handed_back", "state",
)  # fmt: skip


def marks(marking: Marking, lesson: str, step: int) -> bytes:
    """The marks of all pupils, one a row, with empty cells for who has not handed in.

    Raises:
        LearnBlockError: there is no such lesson or step.
    """
    return _written([_PLAIN, *_rows(marking, lesson, step)])


def marks_for_moodle(marking: Marking, lesson: str, step: int, language: str) -> bytes:
    """The marks as Moodle imports grades: an empty cell there would delete a grade.

    Raises:
        LearnBlockError: there is no such lesson or step.
    """
    listed = marking.listed(lesson, step)
    title = f"{in_language(listed.title, language)} {step}"
    rows = [(line.name, "", line.mark, line.note) for line in listed.lines if line.mark]
    return _written([("First name", "Email address", title, f"{title} feedback"), *rows])


def _rows(marking: Marking, lesson: str, step: int) -> Iterator[tuple[object, ...]]:
    listed = marking.listed(lesson, step)
    for line in listed.lines:
        file = marking.file(line.pupil, lesson, step)
        stars = line.stars if line.checked else ""
        times = (_time(file.at), _time(file.back[-1].at) if file.back else "")
        remarks = (line.mark, line.note)
        yield (line.name, lesson, step, stars, line.tries, *remarks, *times, line.state)
    for pupil in listed.without:
        yield (pupil.name, lesson, step, "", "", "", "", "", "", pupil.state)


def _written(rows: list[tuple[object, ...]]) -> bytes:
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    for row in rows:
        writer.writerow([harmless(cell) if isinstance(cell, str) else cell for cell in row])
    return text.getvalue().encode(ENCODING, "replace")


def _time(seconds: float) -> str:
    return time.strftime("%Y-%m-%d %H:%M", time.localtime(seconds))
