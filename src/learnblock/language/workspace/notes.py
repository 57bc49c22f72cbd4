"""Details that a block stores but does not show, so that programs survive the conversion.

The `data` of a block is `Notes` as JSON. Later changes by the user take precedence: a note that no
longer matches its block is ignored.
"""

import re

import msgspec
from msgspec import Struct

from learnblock.language.tree.nodes import Blank, Comment
from learnblock.language.workspace.blocks import Block, BlockComment


class Notes(Struct, omit_defaults=True):
    """The details of a program that a block cannot show.

    Args:
        blank: whether there is a blank line above it.
        above: how many lines of its comment are above it; None for all of them.
        ends: the parts with a comment line at the end; an ``if`` has a part for each
            condition and one for ``else``, any other block has one.
        number: the spelling of the number.
        quoted: a string that no field can show: as shown, and as written in the program.
        given: the number of positional arguments, including those equal to their defaults.
        keywords: the names of the keyword arguments.
        step: whether a ``for`` has a step even though it equals the default.
        unfinished: whether the last line of Python has no line feed.
        apart: whether there is a blank line above the ``return`` of a function.
        python: each line of Python as its author wrote it, such as its quotes.
    """

    blank: bool = False
    above: int | None = None
    ends: tuple[int, ...] = ()
    number: str | None = None
    quoted: tuple[str, str] | None = None
    given: int = 0
    keywords: tuple[str, ...] = ()
    step: bool = False
    unfinished: bool = False
    apart: bool = False
    python: tuple[str, ...] = ()

    def data(self) -> str:
        """As JSON."""
        return _ENCODER.encode(self).decode()


NO_NOTES = Notes()

Lead = tuple[Blank | Comment, ...]
Ends = tuple[str | None, ...]

_ENCODER = msgspec.json.Encoder()
_DECODER = msgspec.json.Decoder(Notes)
_LINE_END = re.compile(r"\r\n|\r|\n")
_UNWRITABLE = re.compile("[\x00\ud800-\udfff]")


def notes_of(block: Block) -> Notes:
    """The notes of a block; `NO_NOTES` if its data is anything else."""
    if block.data is None:
        return NO_NOTES
    try:
        return _DECODER.decode(block.data)
    except (msgspec.DecodeError, UnicodeEncodeError, RecursionError):
        return NO_NOTES


def writable(text: str) -> str:
    """A string without the characters that are not allowed in programs."""
    return _UNWRITABLE.sub("\ufffd", text)


def comment_of(
    lead: Lead, ends: Ends, notes: Notes, previous: Block | None
) -> tuple[BlockComment | None, Notes]:
    """The comment bubble of a block and its notes.

    Args:
        lead: the blank line and the comments above the statement.
        ends: the comment at the end of each part, or None.
        notes: the other notes of the block.
        previous: the block that had the bubble before.
    """
    if lead and type(lead[0]) is Blank:
        notes = msgspec.structs.replace(notes, blank=True)
    above = [note.text for note in lead if type(note) is Comment]
    places = tuple([place for place, end in enumerate(ends) if end is not None])
    lines = above + [end for end in ends if end is not None]
    if not lines:
        return None, notes
    if places or lines == [""]:
        notes = msgspec.structs.replace(notes, above=len(above), ends=places)
    text = "\n".join(lines)
    old = None if previous is None else previous.comment
    if old is None:
        return BlockComment(text), notes
    return BlockComment(text, old.pinned, old.width, old.height), notes


def comments_in(block: Block, notes: Notes, parts: int) -> tuple[Lead, Ends]:
    """The comments above a block and at the end of each part: the reverse of `comment_of`.

    Args:
        block: the block with its bubble.
        notes: the notes of the block.
        parts: the number of its parts that may have a comment at the end.
    """
    blank: Lead = (Blank(),) if notes.blank else ()
    if block.comment is None:
        return blank, (None,) * parts
    lines = [writable(line).strip() for line in _LINE_END.split(block.comment.text)]
    ends: list[str | None] = [None] * parts
    if not _agrees(notes, lines, parts):
        return blank + tuple(map(Comment, lines if any(lines) else ())), tuple(ends)
    above = len(lines) - len(notes.ends)
    for place, line in zip(notes.ends, lines[above:], strict=True):
        ends[place] = line
    return blank + tuple(map(Comment, lines[:above])), tuple(ends)


def _agrees(notes: Notes, lines: list[str], parts: int) -> bool:
    return (
        notes.above is not None
        and notes.above >= 0
        and notes.above + len(notes.ends) == len(lines)
        and len(set(notes.ends)) == len(notes.ends)
        and all(0 <= place < parts for place in notes.ends)
    )
