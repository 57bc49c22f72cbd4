"""The program of a project in all three views."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property, reduce

from learnblock.blocks import BlockConfiguration
from learnblock.errors import Diagnostic, LearnBlockError, ProgramError
from learnblock.i18n import Phrase
from learnblock.language import format as format_program
from learnblock.language import from_workspace, parse, recover
from learnblock.language.check.robots import asked, demands
from learnblock.language.edit.imports import imported, libraries_used, with_import
from learnblock.language.edit.rename import Sort, rename
from learnblock.language.python.robot_import import with_robot
from learnblock.language.tree.nodes import Program as Tree
from learnblock.language.workspace.blocks import Workspace
from learnblock.language.workspace.idle_blocks import idle_blocks
from learnblock.project.document.notations import (
    Blocks,
    Notations,
    Target,
    Written,
    derive,
    for_robot,
    read_python,
)
from learnblock.project.document.positions import Positions
from learnblock.project.document.problems import (
    mistakes_in_blocks,
    problem,
    problems,
    remarks_on_blocks,
)
from learnblock.project.document.renames import rename_between
from learnblock.project.document.views import Notation, Place, Problem, View
from learnblock.runtime.program import Program
from learnblock.wheels import Drivetrain

VIEWS: tuple[View, ...] = ("blocks", "blocktext", "python")
BYTE_ORDER_MARK = "\ufeff"


@dataclass(frozen=True)
class Unread:
    """A view with mistakes that prevent it from being parsed.

    Args:
        view: the name of the view.
        mistakes: its mistakes.
        text: its text, unless it shows blocks.
        workspace: its blocks.
    """

    view: View
    mistakes: tuple[Problem, ...]
    text: str = ""
    workspace: Workspace | None = None


@dataclass(frozen=True)
class Document:
    """A program in three notations; each edit creates a new document.

    The edited view remains as its author wrote it, and the other views follow. While it has syntax
    errors, the others keep the last program without errors.

    Args:
        target: the robot and skills that the program is for.
        origin: the view that was edited last.
        good: the last program that could be parsed.
        unread: the edited view if it can't be parsed.
        remarks: warnings about blocks that can be parsed.
    """

    target: Target
    origin: View
    good: Notations
    unread: Unread | None = None
    remarks: tuple[Problem, ...] = ()

    @classmethod
    def from_text(
        cls,
        blocktext: str,
        robot_module: str,
        configurations: Mapping[str, BlockConfiguration],
        workspace: Workspace | None = None,
        python: str | None = None,
        *,
        equipment: frozenset[str] | None = None,
        drivetrain: Drivetrain | None = None,
    ) -> "Document":
        """Restore a saved document.

        Args:
            blocktext: the program; if it can't be parsed, the other two keep the last valid one.
            robot_module: the module from which Python imports the robot.
            configurations: the known skills, by name.
            workspace: its blocks and their positions.
            python: the Python as its author wrote it.
            equipment: what the robot has; see `learnblock.senses.equipment`.
            drivetrain: what its wheels can do.
        """
        target = Target(robot_module, configurations, equipment, drivetrain)
        tree, mistakes = recover(blocktext)
        if mistakes:
            last = _last_good(target, tree, workspace, python)
            return last.with_text("blocktext", blocktext)
        document = _with_python(_laid_out(target, tree, blocktext, workspace), python)
        return document if document.unread else _with_unread_blocks(document, workspace)

    def with_text(self, notation: Notation, text: str) -> "Document":
        """Edit one of the texts."""
        text = text.removeprefix(BYTE_ORDER_MARK)
        try:
            good = self._read(notation, text)
        except ProgramError as error:
            mistakes = self._mistakes(notation, text, error.diagnostics)
            return replace(
                self, origin=notation, unread=Unread(notation, mistakes, text), remarks=()
            )
        return replace(self, origin=notation, good=good, unread=None, remarks=())

    def with_blocks(self, workspace: Workspace) -> "Document":
        """Edit the blocks."""
        try:
            read = from_workspace(workspace, self.target.configurations)
        except LearnBlockError as error:
            return self._unreadable(workspace, mistakes_in_blocks(error))
        remarks = remarks_on_blocks(read)
        if any(remark.severity == "error" for remark in remarks):
            return self._unreadable(workspace, remarks)
        blocks = Blocks(workspace, read.block_ids)
        good = derive(read.program, self.target, self.good, blocks=blocks)
        if read.program != self.good.tree:
            good = self._importing(self._renamed_throughout(good))
        elif self.unread and self.unread.view != "blocks":
            # Moving a block must not discard a text that has mistakes.
            return replace(self, good=good)
        return replace(self, origin="blocks", good=good, unread=None, remarks=remarks)

    def with_robot(
        self,
        module: str,
        equipment: frozenset[str] | None = None,
        drivetrain: Drivetrain | None = None,
    ) -> "Document":
        """Choose another robot."""
        target = replace(
            self.target, robot_module=module, equipment=equipment, drivetrain=drivetrain
        )
        unread = self.unread
        if unread and unread.view == "python":
            unread = replace(unread, text=with_robot(unread.text, module))
        return replace(self, target=target, good=for_robot(self.good, module), unread=unread)

    def renamed(self, sort: Sort, name: str, new: str) -> "Document":
        """Rename a variable, a function or a ``when`` everywhere.

        Raises:
            LearnBlockError: the new name is not allowed, or the program has mistakes.
        """
        self._refuse_unread("rename")
        return self._rewritten(rename(self.block_tree, sort, name, new))

    def with_import(self, library: str) -> "Document":
        """Import a library in the program.

        Raises:
            LearnBlockError: the program has mistakes.
        """
        self._refuse_unread("import")
        return self._rewritten(with_import(self.block_tree, library))

    def with_configurations(self, configurations: Mapping[str, BlockConfiguration]) -> "Document":
        """Read the program with a changed set of skills, which may affect its blocks."""
        return Document.from_text(
            self.blocktext,
            self.target.robot_module,
            configurations,
            self.workspace,
            self.python_by_hand,
            equipment=self.target.equipment,
            drivetrain=self.target.drivetrain,
        )

    def formatted(self) -> "Document":
        """Format the Block-Text in its canonical form.

        Raises:
            LearnBlockError: the program has mistakes.
        """
        self._refuse_unread("format")
        return self.with_text("blocktext", format_program(self.block_tree))

    def program(self, name: str, folder: str = "") -> Program:
        """The program to run; its lines are those of the Python view.

        Args:
            name: the name that its author uses.
            folder: the folder of the modules that it imports.
        """
        return Program(name, self.good.python.text, self.good.python.text, folder=folder)

    # The views.

    @property
    def blocktext(self) -> str:
        """The Block-Text that is shown."""
        unread = self.unread
        is_shown = unread is not None and unread.view == "blocktext"
        return unread.text if unread and is_shown else self.good.blocktext.text

    @property
    def python(self) -> str:
        """The Python that is shown."""
        unread = self.unread
        is_shown = unread is not None and unread.view == "python"
        return unread.text if unread and is_shown else self.good.python.text

    def text_of(self, view: View) -> str:
        """The text of a view; for blocks, `Notations.canonical` of the last valid program."""
        if view == "blocks":
            return self.good.canonical
        return self.blocktext if view == "blocktext" else self.python

    @property
    def workspace(self) -> Workspace:
        """The blocks that are shown."""
        if self.unread and self.unread.workspace is not None:
            return self.unread.workspace
        return self.good.blocks.workspace

    @property
    def python_by_hand(self) -> str | None:
        """The Python that is shown, unless it is exactly what LearnBlock generates."""
        read = self.unread is None or self.unread.view != "python"
        return None if read and not self.good.by_hand else self.python

    @property
    def stale(self) -> tuple[View, ...]:
        """The views that show the last good program."""
        if self.unread is None:
            return ()
        return tuple(view for view in VIEWS if view != self.unread.view)

    @cached_property
    def problems(self) -> tuple[Problem, ...]:
        """All errors and warnings."""
        if self.unread:
            others = self.unread.mistakes
        else:
            others = (*self.remarks, *problems(self.good, self.target))
        # A block that is still being built has one message at a time.
        marked = {other.block for other in others}
        idle = idle_blocks(self.workspace, self.target.configurations)
        return (
            *others,
            *(
                problem(diagnostic, "blocks", block)
                for block, diagnostic in idle
                if block not in marked
            ),
        )

    @cached_property
    def asked(self) -> tuple[str, ...]:
        """What answers the program's questions on the robot; see `robots.asked`."""
        demanded = demands(self.good.tree, self.target.configurations)
        return asked(demanded, self.target.equipment)

    @property
    def first_error(self) -> Problem | None:
        """The first error, which keeps the program from running; None if there is none."""
        return next((remark for remark in self.problems if remark.severity == "error"), None)

    def lacking(self, equipment: frozenset[str]) -> Phrase | None:
        """What a robot lacks for the program, once it is connected and its equipment is known."""
        error = self.with_robot(self.target.robot_module, equipment).first_error
        return self._said(error) if error and error.code == "missing-device" else None

    def require_no_errors(self) -> None:
        """Refuse a program with errors.

        Raises:
            LearnBlockError: the program has errors.
        """
        if error := self.first_error:
            phrase = self._said(error)
            raise LearnBlockError(phrase.code, **phrase.values)

    def _said(self, error: Problem) -> Phrase:
        """An error where the author looks: in the blocks, or on a line."""
        if self.origin == "blocks" or not error.line:
            problem = (self.origin == "blocks" and error.in_blocks) or error.message
            return Phrase("check-program-error", problem=problem)
        return Phrase("check-program-error-in-line", line=str(error.line), problem=error.message)

    @cached_property
    def block_tree(self) -> Tree:
        """The last good program, with spans in its Block-Text."""
        return self.good.blocktext.tree or parse(self.good.blocktext.text)

    def settled(self) -> "Document":
        """Compute the slow properties now, so that reading them later is fast."""
        _ = self.problems, self.places, self.workspace, self.asked
        return self

    # Positions.

    @cached_property
    def positions(self) -> Positions:
        """Where each statement is in the texts that are shown."""
        return Positions(self.good, self.blocktext, self.python)

    @property
    def places(self) -> tuple[Place, ...]:
        """Every statement in all three views."""
        return self.positions.places

    def block_at(self, python_line: int) -> str | None:
        """The innermost block in a line of the Python view; lines count from 1."""
        return self.positions.block_at("python", python_line)

    def python_line(self, block: str) -> int | None:
        """The first line of a block in the Python view; lines count from 1."""
        return self.positions.python_lines.get(block)

    # Reading.

    def _read(self, notation: Notation, text: str) -> Notations:
        if notation == "blocktext":
            return self._from_blocktext(parse(text), text, self.good)
        tree = read_python(text)
        return derive(tree, self.target, self.good, python=Written.by_author(text, tree))

    def _from_blocktext(self, tree: Tree, text: str, before: Notations) -> Notations:
        return derive(tree, self.target, before, blocktext=Written.by_author(text, tree))

    def _rewritten(self, tree: Tree) -> "Document":
        text = format_program(tree)
        good = self._from_blocktext(parse(text), text, self.good)
        return replace(self, origin="blocktext", good=good, unread=None, remarks=())

    def _renamed_throughout(self, good: Notations) -> Notations:
        """If a name was changed in the blocks, change it in raw Python and comments too."""
        change = rename_between(self.good.blocks.workspace, good.blocks.workspace)
        if self.unread or change is None or not change.is_left_in(good.blocktext.text):
            return good
        try:
            text = format_program(rename(self.block_tree, change.sort, change.name, change.new))
        except LearnBlockError:
            # It also occurs where only the author can change it.
            return good
        if change.is_left_in(text):
            return good
        return self._from_blocktext(parse(text), text, good)

    def _importing(self, good: Notations) -> Notations:
        """If a skill of a library was added, import that library."""
        configurations = self.target.configurations
        libraries = libraries_used(good.tree, configurations) - libraries_used(
            self.good.tree, configurations
        )
        missing = sorted(libraries - imported(good.tree))
        if self.unread or not missing:
            return good
        tree = reduce(with_import, missing, good.tree)
        text = format_program(tree)
        return self._from_blocktext(parse(text), text, good)

    def _unreadable(self, workspace: Workspace, mistakes: tuple[Problem, ...]) -> "Document":
        unread = Unread("blocks", mistakes, workspace=workspace)
        return replace(self, origin="blocks", unread=unread, remarks=())

    def _mistakes(
        self, notation: Notation, text: str, diagnostics: tuple[Diagnostic, ...]
    ) -> tuple[Problem, ...]:
        positions = self.positions.with_text(notation, text)
        return tuple(
            problem(diagnostic, notation, positions.block_at(notation, diagnostic.line))
            for diagnostic in diagnostics
        )

    def _refuse_unread(self, task: str) -> None:
        if self.unread:
            raise LearnBlockError("edit-errors-first", task=task)


def _laid_out(target: Target, tree: Tree, blocktext: str, workspace: Workspace | None) -> Document:
    """Lay out a program with its saved blocks, if these have the same meaning."""
    own_text = Written.by_author(blocktext, tree)
    if workspace is not None:
        try:
            read = from_workspace(workspace, target.configurations)
        except LearnBlockError:
            # These blocks are not a program, so lay out new ones.
            workspace = None
        else:
            remarks = remarks_on_blocks(read)
            if read.program == tree and not any(remark.severity == "error" for remark in remarks):
                blocks = Blocks(workspace, read.block_ids)
                good = derive(read.program, target, blocks=blocks, blocktext=own_text)
                return Document(target, "blocktext", good, remarks=remarks)
    good = derive(tree, target, blocktext=own_text, layout=workspace)
    return Document(target, "blocktext", good)


def _with_python(document: Document, python: str | None) -> Document:
    """Add the saved Python, if it has the same meaning or can't be parsed."""
    if python is None:
        return document
    other = document.with_text("python", python)
    return other if other.unread or _same(document, other) else document


def _with_unread_blocks(document: Document, workspace: Workspace | None) -> Document:
    """Add the saved blocks, if they can't be parsed."""
    if workspace is None or document.workspace is workspace:
        return document
    other = document.with_blocks(workspace)
    return other if other.unread or _same(document, other) else document


def _same(first: Document, second: Document) -> bool:
    # Compared as texts, because a tree that was parsed again may divide raw Python differently.
    return format_program(first.good.tree) == format_program(second.good.tree)


def _last_good(
    target: Target, recovered: Tree, workspace: Workspace | None, python: str | None
) -> Document:
    """The last program that could be parsed, if the saved Block-Text can't be."""
    text = format_program(recovered)
    tree, mistakes = recover(text)
    # Recovered parts may not make a complete program.
    text, tree = ("", Tree()) if mistakes else (text, tree)
    own_text = Written.by_author(text, tree)
    good = derive(tree, target, blocktext=own_text, layout=workspace)
    document = Document(target, "blocktext", good)
    if workspace is not None:
        document = _unless_unread(document, document.with_blocks(workspace))
    if python is not None:
        document = _unless_unread(document, document.with_text("python", python))
    return document


def _unless_unread(before: Document, after: Document) -> Document:
    return before if after.unread else after
