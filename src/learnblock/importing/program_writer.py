"""Write the blocks of an old project as a program in Block-Text, and remember their places."""

from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass, field

from learnblock.blocks import BlockConfiguration
from learnblock.errors import Diagnostic, ProjectError
from learnblock.i18n import Phrase
from learnblock.importing.line_writer import LineWriter, is_statement, shown
from learnblock.importing.project import BlockKind, OldBlock, OriginalProject
from learnblock.importing.report import Reporting

#: Blocks inside each other; Python itself allows 99.
DEEPEST = 90
#: The name of the block of an endless loop.
_FOREVER = "while True"
_CONDITIONAL = frozenset(("if", "elif", "while"))
_BRANCHES = frozenset(("elif", "else"))


@dataclass(frozen=True)
class ProgramPart:
    """A part of a program: its lines, and where its blocks were.

    Args:
        lines: Block-Text, from the header to `end`; of loose blocks only the blocks.
        block: the first block.
        name: what the part is called: ``def f``, ``when x``, ``main``; empty for loose blocks.
    """

    lines: tuple[str, ...]
    block: OldBlock
    name: str = ""


@dataclass
class OldProgramWriter:
    """Writes each block once.

    Args:
        project: the blocks.
        skills: the known skills, by name.
        reporting: collects what changes and what is missing.
        filename: for errors.
    """

    project: OriginalProject
    skills: Mapping[str, BlockConfiguration]
    reporting: Reporting
    filename: str
    written: set[str] = field(default_factory=set)

    def __post_init__(self) -> None:
        self.lines = LineWriter(self.project, self.skills, self.reporting)

    def parts(self) -> list[ProgramPart]:
        """The parts of the program, then the loose blocks."""
        parts: dict[str, ProgramPart] = {}
        loose: list[OldBlock] = []
        for root in self.roots():
            name = self.part_name(root)
            if not name or name in parts:
                loose.append(root)
                continue
            parts[name] = ProgramPart(tuple(self.part(name, root)), root, name)
            loose += self.chain(root.below)[:1]
        rest = [part for root in loose if (part := self.loose(root)).lines]
        self.report_left_out()
        return [*parts.values(), *rest]

    def report_left_out(self) -> None:
        """Report blocks that no other leads to, as in a circle."""
        for block in self.project.blocks.values():
            if block.id not in self.written and block.id not in self.lines.used:
                self.reporting.miss(Phrase("import-left-out", name=shown(block.name)))

    def roots(self) -> Iterator[OldBlock]:
        """The blocks that hang on no other, from the top of the canvas."""
        blocks = self.project.blocks.values()
        hanging = {other for block in blocks for other in (block.right, block.inside, block.below)}
        roots = [block for block in blocks if block.id not in hanging]
        return iter(sorted(roots, key=lambda block: (block.y, block.x)))

    def part_name(self, root: OldBlock) -> str:
        if root.name == "main" and root.kind == BlockKind.CONTROL:
            return "main"
        if root.name == "when" or root.kind == BlockKind.WHEN:
            return f"when {self.lines.names.legal(root.event or 'event')}"
        if root.kind == BlockKind.FUNCTION and root.holds_blocks:
            return f"def {self.lines.names.legal(root.name)}"
        return ""

    def part(self, name: str, root: OldBlock) -> Iterator[str]:
        self.written.add(root.id)
        header = f"{name}()" if name.startswith("def") else name
        if name.startswith("when") and root.right:
            condition = self.lines.condition(self.block(root.right), name)
            header = f"{name} = {condition}"
        yield f"{header}:"
        yield from self.body(root.inside, 1)
        yield "end"

    def loose(self, root: OldBlock) -> ProgramPart:
        if root.is_value and not root.holds_blocks:
            return ProgramPart((self.lines.line(root).text,), root)
        if self.part_name(root):
            self.reporting.change(Phrase("import-twice", name=self.part_name(root)))
            return ProgramPart(tuple(self.statements(root.inside, 1)), root)
        return ProgramPart(tuple(self.statements(root.id, 1)), root)

    # Statements.

    def body(self, first: str | None, depth: int) -> Iterator[str]:
        lines = list(self.statements(first, depth))
        yield from lines
        if all(line.startswith("#") for line in lines):
            yield "pass"

    def statements(self, first: str | None, depth: int) -> Iterator[str]:
        """The statements of a block and of those below it."""
        if depth > DEEPEST:
            message = Phrase("import-nested", limit=DEEPEST)
            raise ProjectError(self.filename, [Diagnostic("too-deep", message)])
        chain = self.chain(first)
        for place, block in enumerate(chain):
            above = chain[place - 1].name if place else ""
            below = chain[place + 1].name if place + 1 < len(chain) else ""
            if block.holds_blocks:
                yield from self.compound(block, above, below, depth)
            else:
                yield self.lines.statement(block)

    def compound(self, block: OldBlock, above: str, below: str, depth: int) -> Iterator[str]:
        yield from self.header(block, above)
        yield from self.body(block.inside, depth + 1)
        goes_on = block.name in {"if", "elif"} and below in _BRANCHES
        if not goes_on:
            yield "end"

    def header(self, block: OldBlock, above: str) -> Iterator[str]:
        """The line that begins a block with others inside it."""
        name, right = block.name, self.block(block.right)
        if name in _BRANCHES and above not in {"if", "elif"}:
            self.reporting.miss(Phrase("import-no-if", name=name))
            name = "if"
            right = right if block.name == "elif" else None
        if name == _FOREVER:
            yield "forever:"
        elif name == "else":
            yield "else:"
        elif block.name == "else":
            yield "if True:"
        elif name in _CONDITIONAL:
            yield f"{name} {self.lines.condition(right, name)}:"
        else:
            yield from self.other_header(block)

    def other_header(self, block: OldBlock) -> Iterator[str]:
        """A loop that only later versions have, or an unknown block."""
        text = self.lines.line(block).text
        if is_statement(f"{text}: pass end"):
            yield f"{text}:"
            return
        self.reporting.miss(Phrase("import-unread-line", text=shown(text)))
        yield f"# {' '.join(text.split())}"
        yield "if False:"

    # Blocks.

    def block(self, key: str | None) -> OldBlock | None:
        return None if key is None else self.project.blocks.get(key)

    def chain(self, first: str | None) -> list[OldBlock]:
        """A block and those below it, unless they are written already."""
        blocks: list[OldBlock] = []
        block = self.block(first)
        while block is not None and block.id not in self.written:
            self.written.add(block.id)
            blocks.append(block)
            block = self.block(block.below)
        return blocks


def undefined(parts: Collection[ProgramPart], names: Collection[str], word: str) -> list[str]:
    """The names of functions or events that parts use and none of them defines."""
    defined = {part.name for part in parts}
    return [name for name in names if f"{word} {name}" not in defined]
