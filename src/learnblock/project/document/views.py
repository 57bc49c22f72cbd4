"""The three views of a program, and what is at a place in each: statements and problems."""

from typing import Literal

from msgspec import Struct

from learnblock.i18n import Phrase

#: The limit of a program in characters: 6,000 lines. A longer one would keep other pages waiting.
LONGEST_TEXT = 250_000

Notation = Literal["blocktext", "python"]
View = Literal["blocks", "blocktext", "python"]


class Problem(Struct, frozen=True, omit_defaults=True):
    """An error or a warning.

    Args:
        code: the kind of problem, for scripts and help.
        message: what happened and what to do.
        severity: an error keeps the program from running.
        view: the text of `line` and `column`; `blocks` if only the block is known.
        line: the line, from 1; 0 for all of it.
        column: the column, from 1; 0 for the whole line.
        end_column: the column after the last character; 0 if unknown.
        block: the block it belongs to, if any.
        in_blocks: the message for a reader of blocks; None if it is the same.
    """

    code: str
    message: Phrase
    severity: Literal["error", "warning"]
    view: View
    line: int = 0
    column: int = 0
    end_column: int = 0
    block: str | None = None
    in_blocks: Phrase | None = None


class Place(Struct, frozen=True, array_like=True):
    """The position of a statement in each view; lines are counted from 1, and 0 means nowhere."""

    block: str
    blocktext: int
    blocktext_end: int
    python: int
    python_end: int
