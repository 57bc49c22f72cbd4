"""The program of a project at one moment, in all three views."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property, reduce

from learnblock.blocks import BlockConfiguration
from learnblock.errors import Diagnostic, FileError, LearnBlockError, ProgramError
from learnblock.language import format as format_program
from learnblock.language import from_workspace, parse, recover
from learnblock.language.extents import Extent, moved
from learnblock.language.imports import imported, libraries_used, with_import
from learnblock.language.nodes import Program as Tree
from learnblock.language.rename import Sort, rename
from learnblock.language.workspace import Workspace
from learnblock.runtime.program import Program
from learnblock.server.messages import Notation, Place, Problem, View
from learnblock.server.program.notations import Notations, Target, read_python, with_robot
from learnblock.server.program.problems import owners, problem, problems
from learnblock.server.program.renames import rename_between

VIEWS: tuple[View, ...] = ("blocks", "blocktext", "python")


@dataclass(frozen=True)
class Unread:
    """A view that cannot be read as it is.

    Args:
        view: which.
        mistakes: why.
        text: what it shows, unless it shows blocks.
        workspace: the blocks that it shows.
    """

    view: View
    mistakes: tuple[Problem, ...]
    text: str = ""
    workspace: Workspace | None = None


@dataclass(frozen=True)
class Document:
    """A program in three notations; each edit makes a new one.

    What was edited stays as its author wrote it, and the other views follow. While it has mistakes
    of form the others keep the last program without any.

    Args:
        target: what the program is written for.
        origin: the view that was edited last.
        good: the last program that could be read.
        unread: the edited view if it cannot be read.
        remarks: what is to be said of blocks that can.
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
        devices: frozenset[str] | None = None,
    ) -> "Document":
        """The document that was saved so.

        Args:
            blocktext: the program; if it cannot be read, the other two say what was read last.
            robot_module: the module that Python imports the robot from.
            configurations: the skills there are, by name.
            workspace: its blocks and where they lie.
            python: its Python as its author wrote it.
            devices: what the robot has, as ``Type:KEY``.
        """
        target = Target(robot_module, configurations, devices)
        tree, mistakes = recover(blocktext)
        if mistakes:
            last = _last_good(target, tree, workspace, python)
            return last.with_text("blocktext", blocktext)
        document = _with_python(_laid_out(target, tree, blocktext, workspace), python)
        return document if document.unread else _with_unread_blocks(document, workspace)

    def with_text(self, notation: Notation, text: str) -> "Document":
        """One of the texts was edited."""
        try:
            good = self._read_blocktext(text) if notation == "blocktext" else self._read(text)
        except ProgramError as error:
            mistakes = self._mistakes(notation, text, error.diagnostics)
            return replace(
                self, origin=notation, unread=Unread(notation, mistakes, text), remarks=()
            )
        return replace(self, origin=notation, good=good, unread=None, remarks=())

    def with_blocks(self, workspace: Workspace) -> "Document":
        """The blocks were edited."""
        try:
            read = from_workspace(workspace, self.target.configurations)
        except LearnBlockError as error:
            return self._unreadable(workspace, _mistakes_of_blocks(error))
        said = tuple(problem(one, "blocks", block) for block, one in read.problems)
        if any(one.severity == "error" for one in said):
            return self._unreadable(workspace, said)
        if read.program != self.good.tree:
            good = Notations.of_blocks(read.program, read.block_ids, workspace, self.target)
            good = self._importing(self._renamed_throughout(good))
            return replace(self, origin="blocks", good=good, unread=None, remarks=said)
        good = self.good.with_blocks(read.program, read.block_ids, workspace)
        if self.unread and self.unread.view != "blocks":
            # Who moves a block while a text has mistakes does not want to lose that text.
            return replace(self, good=good)
        return replace(self, origin="blocks", good=good, unread=None, remarks=said)

    def with_robot(self, module: str, devices: frozenset[str] | None = None) -> "Document":
        """Another robot was chosen."""
        target = replace(self.target, robot_module=module, devices=devices)
        unread = self.unread
        if unread and unread.view == "python":
            unread = replace(unread, text=with_robot(unread.text, module))
        return replace(self, target=target, good=self.good.for_robot(module), unread=unread)

    def renamed(self, sort: Sort, name: str, new: str) -> "Document":
        """A variable, a function or a ``when`` has another name, everywhere.

        Raises:
            LearnBlockError: the new name will not do, or the program has mistakes.
        """
        self._refuse_unread("a name can be changed")
        return self._rewritten(rename(self.block_tree, sort, name, new))

    def with_import(self, library: str) -> "Document":
        """The program imports a library.

        Raises:
            LearnBlockError: the program has mistakes.
        """
        self._refuse_unread("a library can be imported")
        return self._rewritten(with_import(self.block_tree, library))

    def with_configurations(self, configurations: Mapping[str, BlockConfiguration]) -> "Document":
        """Other skills are there than before, so that it may show other blocks and problems."""
        return Document.from_text(
            self.blocktext,
            self.target.robot_module,
            configurations,
            self.workspace,
            self.python_by_hand,
            devices=self.target.devices,
        )

    def formatted(self) -> "Document":
        """The Block-Text has its canonical form.

        Raises:
            LearnBlockError: the program has mistakes.
        """
        self._refuse_unread("the program can be formatted")
        return self.with_text("blocktext", format_program(self.block_tree))

    def program(self, name: str, folder: str = "") -> Program:
        """What is run; its lines are those of the Python view.

        Args:
            name: the name its author knows it by.
            folder: where its own modules are imported from.
        """
        return Program(name, self.good.python.text, self.good.python.text, folder=folder)

    # The views.

    @property
    def blocktext(self) -> str:
        """The Block-Text that is shown."""
        unread = self.unread
        shown = unread is not None and unread.view == "blocktext"
        return unread.text if unread and shown else self.good.blocktext.text

    @property
    def python(self) -> str:
        """The Python that is shown."""
        unread = self.unread
        shown = unread is not None and unread.view == "python"
        return unread.text if unread and shown else self.good.python.text

    @property
    def workspace(self) -> Workspace:
        """The blocks that are shown."""
        if self.unread and self.unread.workspace is not None:
            return self.unread.workspace
        return self.good.workspace

    @property
    def python_by_hand(self) -> str | None:
        """The Python as it is shown, if it is not just what we would write."""
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
        """What is wrong or doubtful."""
        if self.unread:
            return self.unread.mistakes
        return (*self.remarks, *problems(self.good, self.target))

    @property
    def has_errors(self) -> bool:
        """Whether it cannot be run."""
        return any(one.severity == "error" for one in self.problems)

    @cached_property
    def block_tree(self) -> Tree:
        """The last good program; its spans lie in its Block-Text."""
        return self.good.blocktext.tree or parse(self.good.blocktext.text)

    # Places.

    @cached_property
    def places(self) -> tuple[Place, ...]:
        """Every statement in all three views."""
        found: dict[str, Place] = {}
        rows = zip(
            self.good.blocks(), self._extents("blocktext"), self._extents("python"), strict=True
        )
        for block, blocktext, python in rows:
            if block is not None:
                # A comment is of the same block as the statement below it, which comes later.
                found[block] = Place(block, *blocktext, *python)
        return tuple(found.values())

    def block_at(self, python_line: int) -> str | None:
        """The innermost block that stands in a line of the Python view, from 1."""
        owner = self._python_owners
        index = owner[python_line] if 0 < python_line < len(owner) else None
        return None if index is None else self.good.blocks()[index]

    def python_line(self, block: str) -> int | None:
        """The first line of a block in the Python view, from 1."""
        return self._python_lines.get(block)

    @cached_property
    def _python_lines(self) -> dict[str, int]:
        return {place.block: place.python for place in self.places if place.python}

    @cached_property
    def _python_owners(self) -> list[int | None]:
        return owners(self._extents("python"))

    def _extents(self, notation: Notation) -> tuple[Extent, ...]:
        written = self.good.blocktext if notation == "blocktext" else self.good.python
        if self.unread and self.unread.view == notation:
            return moved(written.extents, written.text, self.unread.text)
        return written.extents

    # Reading.

    def _read_blocktext(self, text: str) -> Notations:
        tree = parse(text)
        if tree == self.good.tree:
            return self.good.with_blocktext(tree, text)
        return Notations.of_blocktext(tree, text, self.target, self.good.workspace)

    def _read(self, python: str) -> Notations:
        tree = read_python(python)
        if tree == self.good.tree:
            return self.good.with_python(tree, python)
        return Notations.of_python(tree, python, self.target, self.good.workspace)

    def _rewritten(self, tree: Tree) -> "Document":
        text = format_program(tree)
        notations = Notations.of_blocktext(parse(text), text, self.target, self.good.workspace)
        return replace(self, origin="blocktext", good=notations, unread=None, remarks=())

    def _renamed_throughout(self, good: Notations) -> Notations:
        """If a name was changed in the blocks, what these left behind follows."""
        change = rename_between(self.good.workspace, good.workspace)
        if self.unread or change is None or not change.is_left_in(good.blocktext.text):
            return good
        try:
            text = format_program(rename(self.block_tree, change.sort, change.name, change.new))
        except LearnBlockError:
            # It stands where only its author can change it.
            return good
        if change.is_left_in(text):
            return good
        return Notations.of_blocktext(parse(text), text, self.target, good.workspace)

    def _importing(self, good: Notations) -> Notations:
        """If a skill of a library was put in, the program imports that library."""
        known = self.target.configurations
        used = libraries_used(good.tree, known) - libraries_used(self.good.tree, known)
        missing = sorted(used - imported(good.tree))
        if self.unread or not missing:
            return good
        tree = reduce(with_import, missing, good.tree)
        text = format_program(tree)
        return Notations.of_blocktext(parse(text), text, self.target, good.workspace)

    def _unreadable(self, workspace: Workspace, mistakes: tuple[Problem, ...]) -> "Document":
        unread = Unread("blocks", mistakes, workspace=workspace)
        return replace(self, origin="blocks", unread=unread, remarks=())

    def _mistakes(
        self, notation: Notation, text: str, diagnostics: tuple[Diagnostic, ...]
    ) -> tuple[Problem, ...]:
        written = self.good.blocktext if notation == "blocktext" else self.good.python
        owner = owners(moved(written.extents, written.text, text))
        blocks = self.good.blocks()

        def block(line: int) -> str | None:
            index = owner[line] if line < len(owner) else None
            return None if index is None else blocks[index]

        return tuple(problem(one, notation, block(one.line)) for one in diagnostics)

    def _refuse_unread(self, what: str) -> None:
        if self.unread:
            raise LearnBlockError(f"{what} once the program has no mistakes: correct them first")


def _laid_out(target: Target, tree: Tree, blocktext: str, workspace: Workspace | None) -> Document:
    """A program with the blocks with which it was saved, as far as these say the same."""
    if workspace is not None:
        try:
            read = from_workspace(workspace, target.configurations)
        except LearnBlockError:
            # Blocks that no program has: they are laid out anew.
            workspace = None
        else:
            if read.program == tree and not read.problems:
                blocks = (read.program, read.block_ids, workspace)
                notations = Notations.of_blocks(*blocks, target).with_blocktext(tree, blocktext)
                return Document(target, "blocktext", notations)
    notations = Notations.of_blocktext(tree, blocktext, target, workspace)
    return Document(target, "blocktext", notations)


def _with_python(document: Document, python: str | None) -> Document:
    """With the Python with which it was saved, if that says the same or cannot be read."""
    if python is None:
        return document
    other = document.with_text("python", python)
    return other if other.unread or _same(document, other) else document


def _with_unread_blocks(document: Document, workspace: Workspace | None) -> Document:
    """With the blocks with which it was saved, if these cannot be read."""
    if workspace is None or document.workspace is workspace:
        return document
    other = document.with_blocks(workspace)
    return other if other.unread or _same(document, other) else document


def _same(one: Document, other: Document) -> bool:
    # Compared as texts, since raw Python may be divided otherwise in a tree that was read anew.
    return format_program(one.good.tree) == format_program(other.good.tree)


def _last_good(
    target: Target, recovered: Tree, workspace: Workspace | None, python: str | None
) -> Document:
    """What was read last when a document was saved with a Block-Text that cannot be read."""
    text = format_program(recovered)
    tree, mistakes = recover(text)
    # Not all that can be recovered makes a program by itself.
    text, tree = ("", Tree()) if mistakes else (text, tree)
    notations = Notations.of_blocktext(tree, text, target, workspace)
    document = Document(target, "blocktext", notations)
    if workspace is not None:
        document = _unless_unread(document, document.with_blocks(workspace))
    if python is not None:
        document = _unless_unread(document, document.with_text("python", python))
    return document


def _unless_unread(before: Document, after: Document) -> Document:
    return before if after.unread else after


def _mistakes_of_blocks(error: LearnBlockError) -> tuple[Problem, ...]:
    if isinstance(error, FileError):
        return tuple(problem(one, "blocks") for one in error.diagnostics)
    return (Problem(code="blocks", message=str(error), severity="error", view="blocks"),)
