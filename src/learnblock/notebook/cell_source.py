"""What a cell runs as Python: itself, or what magics in it run."""

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass

#: Lines that IPython leaves out.
_BLANK = re.compile(r"(?:[ \t]*\n)*")
#: A line that is timed by itself, and the first line of a cell that a magic runs.
_TIMED = re.compile(r"\s*%time\s+(?P<code>.+)")
_MAGIC = re.compile(r"%%(?P<name>\w+)")
#: Magics whose measurements would change if a cell noted its steps.
_MEASURING = frozenset({"timeit"})


@dataclass(frozen=True, slots=True)
class CellPart:
    """A part of a cell that is compiled at once.

    Args:
        source: its Python.
        above: how many lines of the cell are above it.
    """

    source: str
    above: int


def cell_parts(cell: str, transform: Callable[[str], str], above: int = 0) -> Iterator[CellPart]:
    """What a cell may run.

    Args:
        cell: as it was typed.
        transform: makes Python of IPython's commands; it raises a SyntaxError if it can't.
        above: how many lines are above it, if it is a part of another cell.

    Raises:
        SyntaxError: a part is not valid in IPython.
    """
    blank = _BLANK.match(cell)
    start = blank.end() if blank else 0
    above += cell.count("\n", 0, start)
    cell = cell[start:]
    magic = _MAGIC.match(cell)
    if magic is None:
        yield CellPart(transform(cell), above)
        for number, line in enumerate(cell.split("\n")):
            if timed := _TIMED.match(line):
                yield CellPart(transform(timed["code"]), above + number)
    elif magic["name"] not in _MEASURING:
        body = cell.partition("\n")[2]
        yield from cell_parts(body, transform, above + 1)
