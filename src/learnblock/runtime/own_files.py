"""The position of an error in the files of the user's folder, such as skills."""

from collections.abc import Iterator
from pathlib import Path
from types import FrameType, TracebackType

from learnblock.storage.home import home

#: A file and a line of it; "" and 0 for none.
Place = tuple[str, int]
NOWHERE: Place = ("", 0)


def own_place(error: BaseException) -> Place:
    """The innermost position of an error or its causes."""
    folder = home().absolute()
    for one in _with_causes(error):
        if isinstance(one, SyntaxError) and _is_within(folder, one.filename or ""):
            return one.filename or "", one.lineno or 0
        places = [place for place in _places(one.__traceback__) if _is_within(folder, place[0])]
        if places:
            return places[-1]
    return NOWHERE


def own_frame(frame: FrameType | None) -> Place:
    """The innermost position among a frame and its callers."""
    folder = home().absolute()
    while frame is not None and not _is_within(folder, frame.f_code.co_filename):
        frame = frame.f_back
    return NOWHERE if frame is None else (frame.f_code.co_filename, frame.f_lineno)


def _with_causes(error: BaseException) -> Iterator[BaseException]:
    """An error and the chain of its causes, each once."""
    seen: set[int] = set()
    one: BaseException | None = error
    while one is not None and id(one) not in seen:
        seen.add(id(one))
        yield one
        one = one.__cause__


def _places(step: TracebackType | None) -> Iterator[Place]:
    while step is not None:
        yield step.tb_frame.f_code.co_filename, step.tb_lineno
        step = step.tb_next


def _is_within(folder: Path, filename: str) -> bool:
    return Path(filename).is_absolute() and Path(filename).is_relative_to(folder)
