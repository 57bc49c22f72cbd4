"""Lessons as files."""

from learnblock.lessons.opened import OpenLesson
from learnblock.storage.archive import zipped


def pack(opened: OpenLesson) -> bytes:
    """A lesson as a ``.lblesson``: the same bytes for the same content."""
    return zipped(opened.files)
