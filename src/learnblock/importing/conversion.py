"""Convert a project of the original LearnBlock: its program, and the places of its blocks."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field

import msgspec

from learnblock import language
from learnblock.blocks import BlockConfiguration
from learnblock.errors import Diagnostic, ProgramError, ProjectError
from learnblock.i18n import Phrase
from learnblock.importing.line_writer import is_statement, is_value, shown
from learnblock.importing.old_text import parse_old
from learnblock.importing.program_writer import OldProgramWriter, ProgramPart, undefined
from learnblock.importing.project import BlockKind, OldBlock, read_project
from learnblock.importing.report import ImportReport, Reporting
from learnblock.language.tree.nodes import Def, Main, Program, When
from learnblock.language.workspace.blocks import Block as NewBlock
from learnblock.language.workspace.blocks import Workspace

#: The ending of a project.
ENDING = ".blockProject"
#: Of a function that holds loose blocks while they are converted.
_LOOSE = "loose_blocks_"
#: The block of a part that had none.
_NOWHERE = OldBlock("", "", BlockKind.CONTROL)


@dataclass(frozen=True)
class Imported:
    """A program that was imported.

    Args:
        blocktext: the program.
        workspace: its blocks, where they were, and the loose ones; None if it was a text.
        report: what changed and what is missing.
    """

    blocktext: str
    workspace: Workspace | None
    report: ImportReport


#: Finds the ``.lb`` file of a library by the library's name; None if there is none.
FindLibrary = Callable[[str], bytes | None]


def import_project(
    data: bytes,
    filename: str,
    skills: Mapping[str, BlockConfiguration],
    find_library: FindLibrary = lambda _: None,
) -> Imported:
    """Import a ``.blockProject`` of versions 1 to 3 of the original LearnBlock.

    Args:
        data: the file.
        filename: for errors.
        skills: the known skills, by name.
        find_library: finds the libraries that the project imports.

    Raises:
        FileError: the file or a library is damaged, or has another type.
    """
    reporting = Reporting()
    project = read_project(data, filename)
    writer = OldProgramWriter(project, skills, reporting, filename)
    parts = writer.parts()
    loose = [part for part in parts if not part.name]
    main = [part for part in parts if part.name]
    libraries = _found(project.libraries, find_library, skills, reporting)
    main += _from_libraries(libraries, {part.name for part in main})
    main += _missing(writer, main)
    return _Conversion(filename, skills, reporting, tuple(main), tuple(loose)).imported()


def _last(path: str) -> str:
    """The last part of a path of any system."""
    return path.replace("\\", "/").rstrip("/").rpartition("/")[2] or path


def _found(
    names: Iterable[str],
    find_library: FindLibrary,
    skills: Mapping[str, BlockConfiguration],
    reporting: Reporting,
) -> Iterator[Program]:
    """The imported libraries."""
    for name in map(_last, names):
        data = find_library(name)
        if data is None:
            reporting.miss(Phrase("import-no-library", name=shown(name)))
        else:
            reporting.change(Phrase("import-library", name=shown(name)))
            yield parse_old(data, f"{shown(name)}.lb", skills, reporting)


def _from_libraries(libraries: Iterable[Program], names: set[str]) -> Iterator[ProgramPart]:
    """The functions of libraries, which become part of the program."""
    for function in (function for library in libraries for function in library.functions.values()):
        name = f"def {function.name}"
        if name not in names:
            names.add(name)
            yield ProgramPart(
                tuple(language.format(Program((function,))).splitlines()), _NOWHERE, name
            )


def _missing(writer: OldProgramWriter, parts: Sequence[ProgramPart]) -> Iterator[ProgramPart]:
    """Functions and events that the project uses but does not define, without content."""
    lines, reporting = writer.lines, writer.reporting
    for name in undefined(parts, tuple(lines.called), "def"):
        reporting.miss(Phrase("import-no-function", name=name))
        yield ProgramPart((f"def {name}():", "pass", "end"), _NOWHERE, f"def {name}")
    for name, condition in lines.heard.items():
        event = f"{name}_received" if undefined(parts, [name], "when") == [] else name
        reporting.change(Phrase("import-heard", event=event, condition=condition))
        header = f"when {event} = {condition}:"
        yield ProgramPart((header, "pass", "end"), _NOWHERE, f"when {event}")
    unheard = [event for event in lines.events if event not in lines.heard]
    for name in undefined(parts, unheard, "when"):
        reporting.miss(Phrase("import-no-event", name=name))
        yield ProgramPart((f"when {name}:", "pass", "end"), _NOWHERE, f"when {name}")


@dataclass
class _Conversion:
    filename: str
    skills: Mapping[str, BlockConfiguration]
    reporting: Reporting
    parts: tuple[ProgramPart, ...]
    loose: tuple[ProgramPart, ...]
    start: list[str] = field(default_factory=list)

    def imported(self) -> Imported:
        self.start += self.unset(self.parsed(self.text()))
        blocktext = self.text()
        program = self.parsed(blocktext)
        for diagnostic in language.check(program, self.skills):
            if diagnostic.severity == "error":
                line = str(diagnostic.line)
                self.reporting.miss(Phrase("file-at-line", line=line, problem=diagnostic.message))
        return Imported(language.format(program), self.workspace(), self.reporting.report())

    def text(self, *, with_loose: bool = False) -> str:
        lines = list(self.start)
        for part in self.ordered():
            lines += ["", *part.lines]
        if with_loose:
            for number, part in enumerate(self.loose):
                lines += [f"def {_LOOSE}{number}():", *_as_statements(part), "end"]
        return "\n".join(lines).lstrip("\n") + "\n"

    def ordered(self) -> list[ProgramPart]:
        """The parts: definitions before what uses them."""
        order = ("def", "when", "main")
        return sorted(self.parts, key=lambda part: order.index(part.name.split()[0]))

    def parsed(self, text: str) -> Program:
        try:
            return language.parse(text, self.filename)
        except ProgramError as error:
            first = error.diagnostics[0]
            raise ProjectError(self.filename, [Diagnostic("unreadable", first.message)]) from error

    def unset(self, program: Program) -> list[str]:
        """Set the variables that are read before they are set."""
        names: dict[str, None] = {}
        for diagnostic in language.check(program, self.skills):
            name = diagnostic.message.values.get("name")
            is_unset = diagnostic.code in {"unknown-name", "unset-variable"} and isinstance(
                name, str
            )
            if is_unset and name not in program.functions and name not in program.whens:
                names.setdefault(str(name))
        for name in names:
            self.reporting.change(Phrase("import-unset", name=name))
        return [f"{name} = 0" for name in names]

    # Blocks.

    def workspace(self) -> Workspace:
        program = self.parsed(self.text(with_loose=True))
        conversion = language.to_workspace(program, self.skills)
        places: dict[str, ProgramPart] = {}
        by_name = {part.name: part for part in self.parts}
        by_name |= {f"def {_LOOSE}{number}": part for number, part in enumerate(self.loose)}
        for node in (*program.items, *([program.main] if program.main else ())):
            if (part := by_name.get(_name(node))) is not None:
                places[conversion.block_ids[id(node)]] = part
        stacks = [_placed(stack, places.get(stack[0].id)) for stack in conversion.workspace.stacks]
        return Workspace([stack for stack in stacks if stack], conversion.workspace.variables)


def _as_statements(part: ProgramPart) -> Iterable[str]:
    text = part.lines[0]
    if not part.block.is_value:
        return part.lines
    if is_value(text):
        return [f"print({text})"]
    return [text] if is_statement(text) else [f"# {' '.join(text.split())}"]


def _name(node: object) -> str:
    match node:
        case Def(name=name):
            return f"def {name}"
        case When(name=name):
            return f"when {name}"
        case Main():
            return "main"
    return ""


def _placed(stack: list[NewBlock], part: ProgramPart | None) -> list[NewBlock]:
    """A stack where its blocks were; of loose blocks without the function that held them."""
    if part is None or not part.block.id:
        return stack
    if not part.name:
        stack = _inner(stack[0], is_value=part.block.is_value)
    if not stack:
        return stack
    first = msgspec.structs.replace(stack[0], x=part.block.x, y=part.block.y)
    return [first, *stack[1:]]


def _inner(hat: NewBlock, *, is_value: bool) -> list[NewBlock]:
    stack = hat.inputs["STACK"].stack if "STACK" in hat.inputs else []
    if not is_value or not stack:
        return stack
    values = [plug.block or plug.shadow for plug in stack[0].inputs.values()]
    return [value for value in values[:1] if value is not None]
