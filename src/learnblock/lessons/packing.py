"""Lessons as files."""

from learnblock.lessons.archive import zipped
from learnblock.lessons.opened import OpenLesson


def pack(opened: OpenLesson) -> bytes:
    """A lesson as a ``.lblesson``: the same bytes for the same content."""
    return zipped(opened.files)
