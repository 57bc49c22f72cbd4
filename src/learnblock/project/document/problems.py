"""Find the problems of a program, and their positions in each of its views."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cached_property

from learnblock.errors import Diagnostic, FileError, LearnBlockError
from learnblock.i18n import Phrase
from learnblock.language import WorkspaceProgram, check, parse
from learnblock.language.tree.extents import Extent, every
from learnblock.language.tree.nodes import Expression, Item, Main, Program, Raw
from learnblock.language.tree.traversal import expressions, within
from learnblock.language.workspace.wording import in_blocks
from learnblock.project.document.notations import Notations, Target, Written
from learnblock.project.document.views import Problem, View


def problems(notations: Notations, target: Target) -> tuple[Problem, ...]:
    """The diagnostics of `check`, cached for each text."""
    blocktext, python = notations.blocktext.tree, notations.python.tree
    text = notations.python.text if python is not None else None
    diagnostics = _checked(
        blocktext or python or notations.tree, target, None if blocktext else text
    )
    if not diagnostics:
        return ()
    if blocktext is None:
        in_python = diagnostics
        blocktext = parse(notations.blocktext.text)
        diagnostics = _checked(blocktext, target)
    elif python is not None:
        in_python = _checked(python, target, text)
    located = _Located(notations, blocktext)
    first = [
        problem(diagnostic, "blocktext", located.block(diagnostic)) for diagnostic in diagnostics
    ]
    if python is None:
        return (*first, *map(located.in_python, diagnostics))
    return (*first, *_in_authors_python(notations, python, in_python))


def problem(diagnostic: Diagnostic, view: View, block: str | None = None) -> Problem:
    """A diagnostic of the text of one view."""
    return Problem(
        code=diagnostic.code,
        message=diagnostic.message,
        severity=diagnostic.severity,
        view=view,
        line=diagnostic.line,
        column=diagnostic.column,
        end_column=diagnostic.end_column,
        block=block,
        in_blocks=in_blocks(diagnostic.message) if block else None,
    )


def owners(extents: Iterable[Extent]) -> list[int | None]:
    """The index of the innermost statement at each line of a text; there is none at line 0."""
    extents = list(extents)
    innermost: list[int | None] = [None] * (max((last for _, last in extents), default=0) + 1)
    for index, (first, last) in enumerate(extents):
        if first:
            # Inner statements come later.
            innermost[first : last + 1] = [index] * (last + 1 - first)
    return innermost


def _checked(tree: Program, target: Target, python: str | None = None) -> list[Diagnostic]:
    return check(
        tree,
        target.configurations,
        target.equipment,
        target.importable,
        python=python,
        drivetrain=target.drivetrain,
    )


def _in_authors_python(
    notations: Notations, tree: Program, diagnostics: Iterable[Diagnostic]
) -> Iterator[Problem]:
    located = _Located(notations, tree)
    lines = notations.python.text.split("\n")
    for diagnostic in diagnostics:
        yield problem(_in_characters(diagnostic, lines), "python", located.block(diagnostic))


def _in_characters(diagnostic: Diagnostic, lines: Sequence[str]) -> Diagnostic:
    """A diagnostic with columns in characters: Python's syntax tree counts them in bytes."""
    if not 0 < diagnostic.line <= len(lines) or lines[diagnostic.line - 1].isascii():
        return diagnostic
    line = lines[diagnostic.line - 1].encode("utf-8", "surrogatepass")

    def characters(column: int) -> int:
        return len(line[: column - 1].decode("utf-8", "ignore")) + 1 if column else 0

    return Diagnostic(
        diagnostic.code,
        diagnostic.message,
        diagnostic.line,
        characters(diagnostic.column),
        characters(diagnostic.end_column),
        diagnostic.severity,
    )


class _Located:
    """Finds the statement, the block and the line of Python for each diagnostic of a tree.

    Args:
        notations: the program.
        tree: the same program with the spans of one of its texts.
    """

    def __init__(self, notations: Notations, tree: Program) -> None:
        self.notations = notations
        self.written = Written.by_author("", tree)
        self.statements = every(tree)
        self._inner: dict[int, Mapping[tuple[int, int, int], str]] = {}

    @cached_property
    def owners(self) -> list[int | None]:
        return owners(self.written.extents)

    @cached_property
    def originals(self) -> list[Item | Main]:
        """The same statement in the tree of the blocks."""
        return every(self.notations.tree)

    def in_python(self, diagnostic: Diagnostic) -> Problem:
        """A diagnostic of Block-Text at its line of the generated Python."""
        block = self.block(diagnostic)
        return Problem(
            code=diagnostic.code,
            message=self.message_in_python(diagnostic.message),
            severity=diagnostic.severity,
            view="python",
            line=self.python_line(diagnostic.line),
            block=block,
            in_blocks=in_blocks(diagnostic.message) if block else None,
        )

    def message_in_python(self, message: Phrase) -> Phrase:
        """A message in which the line of Block-Text, if any, is replaced by that of Python."""
        line = message.values.get("line")
        if not isinstance(line, str):
            return message
        return Phrase(message.code, **{**message.values, "line": str(self.python_line(int(line)))})

    def python_line(self, line: int) -> int:
        index = self.statement(line)
        if index is None:
            return 0
        first, last = self.notations.python.extents[index]
        if isinstance(self.statements[index], Raw):
            below = line - self.written.extents[index][0]
            # A program with only raw Python has no `# python` line above it.
            return min(first + below - (first == 1), last) or 1
        return first

    def block(self, diagnostic: Diagnostic) -> str | None:
        """The innermost block that a diagnostic is about."""
        index = self.statement(diagnostic.line)
        if index is None:
            return None
        where = (diagnostic.line, diagnostic.column, diagnostic.end_column)
        own = self.notations.blocks.ids.get(id(self.originals[index]))
        return self.inner(index).get(where, own)

    def inner(self, index: int) -> Mapping[tuple[int, int, int], str]:
        """The blocks of a statement's expressions, by line, column and end column or 0."""
        if index not in self._inner:
            self._inner[index] = dict(self._inner_blocks(index))
        return self._inner[index]

    def _inner_blocks(self, index: int) -> Iterator[tuple[tuple[int, int, int], str]]:
        ids = self.notations.blocks.ids
        pairs = zip(
            _expressions(self.statements[index]), _expressions(self.originals[index]), strict=False
        )
        # Of several at one place, the outermost is meant.
        for node, original in reversed(list(pairs)):
            if block := ids.get(id(original)):
                yield (node.span.line, node.span.column, node.span.end_column), block
                yield (node.span.line, node.span.column, 0), block

    def statement(self, line: int) -> int | None:
        return self.owners[line] if line < len(self.owners) else None


def _expressions(item: Item | Main) -> Iterable[Expression]:
    for expression in expressions(item):
        yield from within(expression)


def remarks_on_blocks(read: WorkspaceProgram) -> tuple[Problem, ...]:
    """The errors and warnings about blocks."""
    return tuple(problem(diagnostic, "blocks", block) for block, diagnostic in read.problems)


def mistakes_in_blocks(error: LearnBlockError) -> tuple[Problem, ...]:
    """The mistakes of blocks that are no program."""
    if isinstance(error, FileError):
        return tuple(problem(diagnostic, "blocks") for diagnostic in error.diagnostics)
    return (Problem(code="blocks", message=error.phrase, severity="error", view="blocks"),)
