"""The position of an error in the files of the user's folder that programs use, such as skills."""

import os
import stat
from collections.abc import Iterator
from contextlib import suppress
from functools import cached_property
from types import FrameType, TracebackType

from learnblock.storage.home import home
from learnblock.storage.skill_files import LARGEST

#: A file and a line of it; "" and 0 for none.
Place = tuple[str, int]
NOWHERE: Place = ("", 0)
#: The folders of files that programs use.
_FOLDERS = ("skills", "libraries")
#: Without waiting for the other end of a pipe, and not through a link. Windows has neither.
_CAREFULLY = getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_NOFOLLOW", 0)


def own_files() -> frozenset[str]:
    """The files of the user's folder in which a program's error can be."""
    folders = (home().absolute() / name for name in _FOLDERS)
    with suppress(OSError):
        return frozenset(str(path) for folder in folders for path in folder.rglob("*.py"))
    return frozenset()


def quoted(file: str, line: int) -> str:
    """The text of a line of a file; "" if there is none, or if it isn't a regular file."""
    # It may have been deleted since.
    with suppress(OSError), open(file, "rb", opener=_opened) as opened:
        if stat.S_ISREG(os.fstat(opened.fileno()).st_mode):
            lines = opened.read(LARGEST).decode("utf-8-sig", "replace").splitlines()
            return "".join(lines[max(0, line - 1) : line]).strip()
    return ""


def own_place(error: BaseException) -> Place:
    """The innermost position of an error or its causes."""
    is_own = _Own()
    for cause in _with_causes(error):
        if isinstance(cause, SyntaxError) and is_own(cause.filename or ""):
            return cause.filename or "", max(0, cause.lineno or 0)
        places = [place for place in _places(cause.__traceback__) if is_own(place[0])]
        if places:
            return places[-1]
    return NOWHERE


def own_frame(frame: FrameType | None) -> Place:
    """The innermost position among a frame and its callers."""
    is_own = _Own()
    while frame is not None and not is_own(frame.f_code.co_filename):
        frame = frame.f_back
    return NOWHERE if frame is None else (frame.f_code.co_filename, frame.f_lineno)


def _opened(file: str, flags: int) -> int:
    return os.open(file, flags | _CAREFULLY)


def _with_causes(error: BaseException) -> Iterator[BaseException]:
    """An error and the chain of its causes, each once."""
    seen: set[int] = set()
    cause: BaseException | None = error
    while cause is not None and id(cause) not in seen:
        seen.add(id(cause))
        yield cause
        cause = cause.__cause__


def _places(step: TracebackType | None) -> Iterator[Place]:
    while step is not None:
        yield step.tb_frame.f_code.co_filename, step.tb_lineno
        step = step.tb_next


class _Own:
    """Whether `own_files` has a file; it looks at the folders once, and only if it has to."""

    def __init__(self) -> None:
        self._folder = str(home().absolute())

    def __call__(self, filename: str) -> bool:
        return filename.startswith(self._folder) and filename in self._files

    @cached_property
    def _files(self) -> frozenset[str]:
        return own_files()
