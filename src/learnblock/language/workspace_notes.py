"""What a block keeps beside what it shows, so that a program comes back from it as it was.

A block's `data` is JSON made of `Notes`. What the user has changed in the block since goes before:
a note that no longer agrees with its block is passed over.
"""

import re

import msgspec
from msgspec import Struct

from learnblock.language.nodes import Blank, Comment
from learnblock.language.workspace import Block, BlockComment


class Notes(Struct, omit_defaults=True):
    """What a block cannot show.

    Args:
        blank: there is a blank line above it.
        above: how many lines of its comment stand above it; None for all of them.
        ends: which of its parts the other lines stand behind; an ``if`` has a part for each
            condition and one for ``else``, any other block has one.
        number: how the number is spelled.
        quoted: a text that no field can show: what is shown, and how it is written.
        given: how many arguments are given by their place, if only with their defaults.
        keywords: which are given by their names.
        step: the step of a ``for`` is given, if only with its default.
        unfinished: the last line of Python has no line feed behind it.
        apart: there is a blank line above the ``return`` of a function.
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

    def data(self) -> str:
        """As a block keeps them."""
        return _ENCODER.encode(self).decode()


NO_NOTES = Notes()

Lead = tuple[Blank | Comment, ...]
Ends = tuple[str | None, ...]

_ENCODER = msgspec.json.Encoder()
_DECODER = msgspec.json.Decoder(Notes)
_LINE_END = re.compile(r"\r\n|\r|\n")
_UNWRITABLE = re.compile("[\x00\ud800-\udfff]")


def notes_of(block: Block) -> Notes:
    """A block's notes; `NO_NOTES` if its data is none of ours."""
    if block.data is None:
        return NO_NOTES
    try:
        return _DECODER.decode(block.data)
    except (msgspec.DecodeError, UnicodeEncodeError, RecursionError):
        return NO_NOTES


def writable(text: str) -> str:
    """A text without the characters that no program may hold."""
    return _UNWRITABLE.sub("\ufffd", text)


def comment_of(
    lead: Lead, ends: Ends, notes: Notes, previous: Block | None
) -> tuple[BlockComment | None, Notes]:
    """The bubble of a block with the comments above it and at the ends of its lines, and its notes.

    Args:
        lead: what stands above: a blank line, comments.
        ends: the comment behind each part, or None.
        notes: what else there is to note.
        previous: the block whose bubble it was.
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
    """What stands above a block, and behind each of its parts: the reverse of `comment_of`.

    Args:
        block: with its bubble.
        notes: the block's.
        parts: how many parts of it may have a comment behind them.
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
