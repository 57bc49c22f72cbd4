"""A program that several pages edit at the same time: their edits are merged."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property

from learnblock.language.edit.merge import merge
from learnblock.language.workspace.blocks import Workspace
from learnblock.project.document.document import BYTE_ORDER_MARK, Document
from learnblock.project.document.revisions import Revisions
from learnblock.project.document.views import View

#: What a view shows: a text, or blocks.
Content = str | Workspace


@dataclass(frozen=True)
class Edit:
    """An edit of one view.

    Args:
        view: the edited view.
        content: its text, or its blocks, after the edit.
        base: the text that was edited, for blocks as `Document.text_of` gives it; None if unknown.
        wins: whether it wins where others have changed the same line.
    """

    view: View
    content: Content
    base: str | None
    wins: bool = True

    def made_on(self, document: Document) -> Document:
        """The document after the edit, whatever it was made on."""
        if isinstance(self.content, Workspace):
            return document.with_blocks(self.content)
        assert self.view != "blocks"  # noqa: S101 - only blocks are a workspace
        return document.with_text(self.view, self.content)


@dataclass(frozen=True)
class Merged:
    """A program after an edit.

    Args:
        document: the program.
        left: the text that the edit alone has left in its view, see `Document.text_of`; None for
            blocks that can't be parsed.
        lost: a program with a change that `document` lacks, so it must be kept elsewhere.
    """

    document: Document
    left: str | None
    lost: Document | None = None


def merged(now: Document, edit: Edit, *, keeps_unread: bool = False) -> Merged:
    """Merge an edit into a program: texts line by line, and blocks statement by statement.

    Args:
        now: the program as others have left it.
        edit: the edit.
        keeps_unread: whether a text that can't be parsed yet is kept if another view is edited,
            because another user is writing it.
    """
    result = _Merging(now, edit).merged()
    return _with_unread_text(now, result) if keeps_unread else result


def base_of(now: Document, content: Content) -> str | None:
    """What to give as the base of an edit of `content`; None for blocks that can't be parsed."""
    return content if isinstance(content, str) else _text_of_blocks(now.with_blocks(content))


@dataclass(frozen=True)
class _Merging:
    """An edit, and the program as others have left it."""

    now: Document
    edit: Edit

    def merged(self) -> Merged:
        base, ours = self.edit.base, self.ours
        if self.theirs in (base, ours):
            return Merged(self.alone, ours)
        both = None if base is None or ours is None else self._both(base, ours)
        return both or self._preferred()

    @property
    def theirs(self) -> str:
        """The text that others have left in its view."""
        return self.now.text_of(self.edit.view)

    @cached_property
    def alone(self) -> Document:
        """The program with the edit, but without what others have changed since.

        Of a text that is merged it is seldom needed, and slow: the text has to be parsed.
        """
        return self.edit.made_on(self.now)

    @property
    def ours(self) -> str | None:
        """The text that the edit has left in its view; None for blocks that can't be parsed."""
        content = self.edit.content
        if isinstance(content, str):
            return content.removeprefix(BYTE_ORDER_MARK)
        return _text_of_blocks(self.alone)

    def _both(self, base: str, ours: str) -> Merged | None:
        """Both changes; None if each gives a valid program, but both together do not."""
        view, wins = self.edit.view, self.edit.wins
        merged = merge(base, *((self.theirs, ours) if wins else (ours, self.theirs)))
        both = self._with(merged.text)
        if both.unread and not any(
            _is_unread(document, view) for document in (self.now, self.alone)
        ):
            return None
        lost = self._overruled if merged.is_conflict else None
        return Merged(both, ours, lost)

    def _with(self, text: str) -> Document:
        """The program with a merged text in the edited view."""
        if self.edit.view != "blocks":
            return self.now.with_text(self.edit.view, text)
        both = self.alone.with_text("blocktext", text)
        return both if both.unread else replace(self.alone, good=both.good)

    def _preferred(self) -> Merged:
        preferred = self.alone if self.edit.wins else self.now
        return Merged(preferred, self.ours, self._overruled)

    @property
    def _overruled(self) -> Document:
        return self.now if self.edit.wins else self.alone


def _text_of_blocks(document: Document) -> str | None:
    return None if _is_unread(document, "blocks") else document.text_of("blocks")


def _with_unread_text(now: Document, after: Merged) -> Merged:
    """Keep the text of `now` that can't be parsed, and let it follow the edit of another view."""
    unread = now.unread
    if unread is None or unread.view == "blocks" or after.document.unread:
        return after
    was, becomes = (
        program.good.blocktext.text if unread.view == "blocktext" else program.good.python.text
        for program in (now, after.document)
    )
    merged = merge(was, becomes, unread.text)
    document = after.document.with_text(unread.view, merged.text)
    return replace(after, document=document, lost=now if merged.is_conflict else after.lost)


def _is_unread(document: Document, view: str) -> bool:
    return document.unread is not None and document.unread.view == view


class SharedProgram:
    """The current program, with undo and redo, and the revisions that edits are based on.

    Its methods can be slow for long programs.

    Args:
        document: the program.
    """

    def __init__(self, document: Document) -> None:
        self.revisions = Revisions(document)
        #: Who wrote the text that can't be parsed, if there is one.
        self._unread_by: object = None

    @property
    def document(self) -> Document:
        """The current program."""
        return self.revisions.document

    def merge(self, edit: Edit, by: object = None) -> Merged:
        """Merge an edit.

        Args:
            edit: the edit.
            by: who made the edit, such as a page; None for another program.
        """
        keeps_unread = by is None or self._unread_by is not by
        result = merged(self.document, edit, keeps_unread=keeps_unread)
        self.change(lambda _: result.document)
        unread = result.document.unread
        if unread is None or unread.view == edit.view:
            self._unread_by = by
        return result

    def change(self, edit: Callable[[Document], Document]) -> None:
        """Change the program.

        Raises:
            LearnBlockError: the edit is impossible; nothing has changed.
        """
        self.revisions.push(edit(self.document).settled())

    def replace(self, edit: Callable[[Document], Document]) -> None:
        """Change the program without a step of undo, for example when the robot changes."""
        self.revisions.replace(edit(self.document).settled())

    def undo(self) -> None:
        """Undo the last edit, if there is one."""
        self.revisions.undo()
        self.document.settled()

    def redo(self) -> None:
        """Redo the last undone edit, if there is one."""
        self.revisions.redo()
        self.document.settled()
