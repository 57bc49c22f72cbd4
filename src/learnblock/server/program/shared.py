"""A program that several pages edit at the same time: their edits are merged."""

from collections.abc import Callable
from dataclasses import dataclass, replace

from learnblock.language import format as format_program
from learnblock.language import recover
from learnblock.language.edit.merge import merge
from learnblock.language.workspace.blocks import Workspace
from learnblock.server import messages
from learnblock.server.messages import View
from learnblock.server.program.document import Document
from learnblock.server.program.notations import Written, derive
from learnblock.server.program.revisions import Revisions
from learnblock.server.program.shown import Shown

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
        alone: the program with the edit, but without what others have changed since.
        lost: a program with a change that `document` lacks, so it must be kept elsewhere.
    """

    document: Document
    alone: Document
    lost: Document | None = None


def merged(now: Document, edit: Edit, *, keeps_unread: bool = False) -> Merged:
    """Merge an edit into a program: texts line by line, and blocks statement by statement.

    Args:
        now: the program as others have left it.
        edit: the edit.
        keeps_unread: whether a text that can't be parsed yet is kept if another view is edited,
            because another user is writing it.
    """
    found = _merged(now, edit)
    return _with_unread_text(now, found) if keeps_unread else found


def base_of(now: Document, content: Content) -> str | None:
    """What to give as the base of an edit of `content`; None for blocks that can't be parsed."""
    if isinstance(content, str):
        return content
    document = now.with_blocks(content)
    return None if _is_unread(document, "blocks") else document.text_of("blocks")


def _merged(now: Document, edit: Edit) -> Merged:
    alone = edit.made_on(now)
    if edit.base == now.text_of(edit.view):
        return Merged(alone, alone)
    if edit.base is None or _is_unread(alone, "blocks"):
        return _preferred(now, alone, edit)
    if edit.view == "blocks":
        base, theirs, ours = (_program(one) for one in (edit.base, now, alone))
    else:
        base, theirs, ours = edit.base, now.text_of(edit.view), alone.text_of(edit.view)
    found = merge(base, *((theirs, ours) if edit.wins else (ours, theirs)))
    both = _rewritten(alone if edit.view == "blocks" else now, edit, found.text)
    if both.unread and not (_is_unread(alone, edit.view) or _is_unread(now, edit.view)):
        # Each edit gives a valid program, but both together do not.
        return _preferred(now, alone, edit)
    lost = now if edit.wins else alone
    return Merged(both, alone, lost if found.is_conflict else None)


def _preferred(now: Document, alone: Document, edit: Edit) -> Merged:
    return Merged(alone, alone, lost=now) if edit.wins else Merged(now, alone, lost=alone)


def _program(written: str | Document) -> str:
    """A program in the canonical form of Block-Text."""
    tree = recover(written)[0] if isinstance(written, str) else written.good.tree
    return format_program(tree)


def _rewritten(document: Document, edit: Edit, text: str) -> Document:
    """The document with a merged text in the edited view."""
    if not isinstance(edit.content, Workspace):
        return replace(edit, content=text).made_on(document)
    tree, mistakes = recover(text)
    if mistakes:
        return document.with_text("blocktext", text)
    written = Written.by_author(text, tree)
    return replace(document, good=derive(tree, document.target, document.good, blocktext=written))


def _with_unread_text(now: Document, after: Merged) -> Merged:
    """Keep the text of `now` that can't be parsed, and let it follow the edit of another view."""
    unread = now.unread
    if unread is None or unread.view == "blocks" or after.document.unread:
        return after
    was, becomes = (
        one.good.blocktext.text if unread.view == "blocktext" else one.good.python.text
        for one in (now, after.document)
    )
    found = merge(was, becomes, unread.text)
    document = after.document.with_text(unread.view, found.text)
    return replace(after, document=document, lost=now if found.is_conflict else after.lost)


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
        self._unread_by: Shown | None = None

    @property
    def document(self) -> Document:
        """The current program."""
        return self.revisions.document

    def merge(self, edit: Edit, by: Shown | None = None) -> Merged:
        """Merge an edit.

        Args:
            edit: the edit.
            by: the program as shown by the page that made the edit; None for another program.
        """
        keeps_unread = by is None or self._unread_by is not by
        found = merged(self.document, edit, keeps_unread=keeps_unread)
        self.change(lambda _: found.document)
        unread = found.document.unread
        if unread is None or unread.view == edit.view:
            self._unread_by = by
        if by and not (edit.view == "blocks" and found.alone.unread):
            # An edit of blocks that can't be parsed has no text; the next one has the same base.
            by.left(edit.view, found.alone.text_of(edit.view))
        return found

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

    def update(self, page: Shown) -> messages.Document:
        """Return the message that brings a page up to date."""
        now = self.revisions
        return page.update(now.document, now.number, can_undo=now.can_undo, can_redo=now.can_redo)
