"""Read statement blocks and their stacks."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from typing import NamedTuple

from learnblock.blocks.toolbox import SKILL
from learnblock.i18n import Phrase
from learnblock.language.blocktext.block_parser import MAX_BLOCKS
from learnblock.language.blocktext.parser import MODULE
from learnblock.language.tree import raw
from learnblock.language.tree.nodes import (
    Activate,
    Assign,
    Blank,
    Body,
    Branch,
    Break,
    Call,
    Comment,
    Constant,
    Continue,
    Deactivate,
    Else,
    ForEach,
    ForRange,
    If,
    Import,
    Item,
    Main,
    Name,
    Number,
    Pass,
    Perform,
    PythonBlock,
    PythonLine,
    PythonPart,
    Raw,
    Repeat,
    Return,
    Setup,
    Statement,
    Unary,
    WaitUntil,
    While,
    is_further_part,
)
from learnblock.language.workspace.block_reader import (
    extra,
    extra_count,
    extra_list,
    is_disabled,
    plugged,
)
from learnblock.language.workspace.blocks import Block
from learnblock.language.workspace.container_reader import (
    CHANGES,
    ContainerReader,
    change_entry,
    change_index,
    pop,
    remove_entry,
    set_entry,
    set_index,
)
from learnblock.language.workspace.notes import Ends, Lead, Notes, comments_in, notes_of
from learnblock.language.workspace.python_shapes import BLOCK, LINE, TEXT, words_in
from learnblock.language.workspace.types import (
    FOR_EACH,
    FOR_UNPACKING,
    FOREVER,
    WHILE,
    variable_fields,
)

_FLOWS: dict[str, type[Break | Continue]] = {"BREAK": Break, "CONTINUE": Continue}
_OPENERS = frozenset(
    (
        "controls_if",
        WHILE,
        FOREVER,
        "controls_repeat_ext",
        FOR_EACH,
        FOR_UNPACKING,
        "controls_for",
        BLOCK,
    )
)
_NO_PARTS = frozenset(("lb_python", TEXT, "lb_comment", "lb_main", "lb_without_robot"))


class Group(NamedTuple):
    """A statement and the comments above it: the content of one block."""

    lead: Lead
    statement: Item | Main


class StatementReader(ContainerReader):
    """Reads statements.

    `groups` maps each block to its content; `silent` are the blocks without content; `alone` is
    whether the program is a single statement; `depth` is the number of open blocks; `in_function`
    is whether variables can be local there.
    """

    groups: dict[str, Group]
    silent: set[str]
    alone: bool
    depth = 0
    in_function = False

    def chain(self, blocks: Iterable[Block]) -> list[Group]:
        """Read the blocks of a stack, except those without content."""
        return [group for block in blocks if (group := self.group(block)) is not None]

    def group(self, block: Block, read: "Reading | None" = None) -> Group | None:
        """Read a block; None if it is disabled or cannot be read.

        Args:
            block: the block.
            read: how to read it, where more than statements is allowed.
        """
        if self.depth == MAX_BLOCKS and block.type in _OPENERS:
            message = Phrase("blocktext-too-many-blocks", limit=MAX_BLOCKS)
            self.report(block, "too-deep", message)
            return None
        notes = notes_of(block)
        lead, ends = comments_in(block, notes, parts(block))
        statement = None if is_disabled(block) else (read or self.statement)(block, notes, ends)
        if statement is None:
            self.silent.add(block.id)
            return None
        return self.found(block, lead, statement)

    def found(self, block: Block, lead: Lead, statement: Item | Main) -> Group:
        """Record the content of a block."""
        for note in lead:
            self.note(note, block)
        self.note(statement, block)
        group = Group(lead, statement)
        self.groups[block.id] = group
        return group

    def statement(self, block: Block, notes: Notes, ends: Ends) -> Statement | None:
        handler = STATEMENTS.get(block.type)
        if handler is not None:
            return handler(self, block, notes, ends)
        if block.type.startswith(SKILL):
            return self.perform(block, self.skill(block, block.type[len(SKILL) :]), ends)
        if block.type in TOP_LEVEL:
            self.report(block, "misplaced-block", Phrase("workspace-misplaced-block"))
        else:
            message = Phrase("workspace-unknown-block", type=block.type)
            self.report(block, "unknown-block", message)
        return None

    def body(self, block: Block, name: str) -> Body:
        """The statements in an input, or `pass` if there are none that do anything."""
        body = self.statements(block, name)
        return body if _does_something(body) else (*body, self.idle(block))

    def idle(self, block: Block) -> Pass:
        node = Pass()
        self.note(node, block)
        return node

    def statements(self, block: Block, name: str) -> Body:
        """The statements in an input, if there are any."""
        socket = block.inputs.get(name)
        if socket is None or not socket.stack:
            return ()
        self.depth += 1
        groups = self.chain(socket.stack)
        self.depth -= 1
        return spaced(groups)  # type: ignore[return-value]

    def variables_of(self, block: Block) -> tuple[Name, ...]:
        """The variables of a loop with several."""
        count = max(2, extra_count(block, "variables"))
        return tuple(self.variable(block, field) for field in variable_fields(count))


Reading = Callable[[Block, Notes, Ends], Item | Main | None]
Handler = Callable[[StatementReader, Block, Notes, Ends], Statement | None]
TOP_LEVEL = frozenset(("lb_import", "lb_setup", "lb_without_robot"))


def parts(block: Block) -> int:
    """The number of lines of a block that may have a comment at the end."""
    if block.type in _NO_PARTS:
        return 0
    if block.type == "controls_if":
        return extra_count(block, "elseIfCount") + 1 + (extra(block, "hasElse") is True)
    return len(extra_list(block, "parts")) if block.type == BLOCK else 1


def spaced(groups: Sequence[Group]) -> tuple[Item | Main, ...]:
    """The statements of a body, with blank lines only where a program can have them."""
    body: list[Item | Main] = []
    for lead, statement in groups:
        body.extend(lead if body or not lead or type(lead[0]) is not Blank else lead[1:])
        body.append(statement)
    return tuple(body)


def _does_something(body: Body) -> bool:
    return any(
        type(statement) not in {Comment, Blank}
        and not (type(statement) is Raw and not raw.code_lines(statement.text))
        for statement in body
    )


def import_of(reader: StatementReader, block: Block, ends: Ends) -> Import | None:
    """Read the import of a library."""
    module = reader.words(block, "MODULE").strip()
    if MODULE.fullmatch(module):
        return Import(module, ends[0])
    reader.report(block, "import-name", Phrase("workspace-import-name"))
    return None


def setup_of(reader: StatementReader, block: Block, ends: Ends) -> Setup:
    """Read the setup of the robot."""
    return Setup(*reader.arguments(block), ends[0])


def _if(reader: StatementReader, block: Block, _: Notes, ends: Ends) -> If:
    count = extra_count(block, "elseIfCount") + 1
    branches = tuple([_branch(reader, block, place, ends[place]) for place in range(count)])
    otherwise = None
    if extra(block, "hasElse") is True:
        otherwise = Else(reader.body(block, "ELSE"), ends[count])
        reader.note(otherwise, block)
    return If(branches, otherwise)


def _branch(reader: StatementReader, block: Block, place: int, comment: str | None) -> Branch:
    condition = reader.truth(block, f"IF{place}")
    branch = Branch(condition, reader.body(block, f"DO{place}"), comment)
    reader.note(branch, block)
    return branch


def _while(reader: StatementReader, block: Block, _: Notes, ends: Ends) -> While:
    condition = reader.truth(block, "BOOL")
    if block.fields.get("MODE") == "UNTIL":
        condition = reader.made(Unary("not", condition), block)
    return While(condition, reader.body(block, "DO"), ends[0])


def _forever(reader: StatementReader, block: Block, _: Notes, ends: Ends) -> While:
    always = reader.stand_in(block, Constant(value=True))
    return While(always, reader.body(block, "DO"), ends[0])


def _for_range(reader: StatementReader, block: Block, notes: Notes, ends: Ends) -> ForRange:
    step = reader.optional(block, "BY")
    if step == Number("1") and not notes.step:
        step = None
    return ForRange(
        reader.variable(block),
        reader.number(block, "FROM"),
        reader.number(block, "TO"),
        step,
        reader.body(block, "DO"),
        ends[0],
    )


def _raw(reader: StatementReader, block: Block, notes: Notes, _: Ends) -> Raw:
    code = reader.words(block, "CODE")
    unfinished = notes.unfinished and (reader.alone or not code)
    return Raw(code if unfinished else code + "\n")


def _python_words(reader: StatementReader, block: Block, state: object, field: str) -> list[str]:
    """The words of a line of Python: those around its sockets, else those in a field."""
    words = words_in(state)
    if len(words) < 2 and field in block.fields:
        return [_one_line(reader, block, field)]
    return words


def _one_line(reader: StatementReader, block: Block, field: str) -> str:
    """What a field says, on one line."""
    return " ".join(reader.words(block, field).split("\n")).strip()


def _python_line(reader: StatementReader, block: Block, _: Notes, ends: Ends) -> PythonLine:
    words = _python_words(reader, block, extra(block, "words"), "CODE")
    return PythonLine(reader.python(block, LINE, words or ["pass"]), ends[0])


def _python_block(
    reader: StatementReader, block: Block, _: Notes, ends: Ends
) -> PythonBlock | None:
    parts: list[PythonPart] = []
    first = 0
    for place, comment in enumerate(ends):
        words = _python_words(reader, block, extra_list(block, "parts")[place], f"CODE{place}")
        header = reader.python(block, BLOCK, words or ["try"], first, place)
        first += max(len(words) - 1, 0)
        if is_further_part(header) != (place > 0):
            code = "workspace-not-a-part" if place else "workspace-not-a-beginning"
            reader.report(block, "invalid-python", Phrase(code, words=header))
            header = "else" if place else "try"
        part = PythonPart(header, (), comment)
        if place or not part.has_cases:
            part = replace(part, body=reader.body(block, f"DO{place}"))
        parts.append(part)
        reader.note(part, block)
    return PythonBlock(tuple(parts)) if parts else None


def _do(reader: StatementReader, block: Block, _: Notes, ends: Ends) -> Perform | None:
    call = reader.value(block, "VALUE")
    return None if plugged(block, "VALUE") is None else reader.perform(block, call, ends)


STATEMENTS: dict[str, Handler] = {
    "controls_if": _if,
    WHILE: _while,
    FOREVER: _forever,
    "lb_wait_until": lambda reader, block, _, ends: WaitUntil(
        reader.truth(block, "CONDITION", "workspace-wait-without-condition"), ends[0]
    ),
    "controls_repeat_ext": lambda reader, block, _, ends: Repeat(
        reader.number(block, "TIMES"), reader.body(block, "DO"), ends[0]
    ),
    FOR_EACH: lambda reader, block, _, ends: ForEach(
        (reader.variable(block),), reader.list(block, "LIST"), reader.body(block, "DO"), ends[0]
    ),
    FOR_UNPACKING: lambda reader, block, _, ends: ForEach(
        reader.variables_of(block), reader.list(block, "LIST"), reader.body(block, "DO"), ends[0]
    ),
    "controls_for": _for_range,
    "controls_flow_statements": lambda reader, block, _, ends: reader.choice(block, "FLOW", _FLOWS)(
        ends[0]
    ),
    "variables_set": lambda reader, block, _, ends: Assign(
        reader.variable(block), "=", reader.value(block, "VALUE"), ends[0]
    ),
    "lb_set_local": lambda reader, block, _, ends: Assign(
        reader.variable(block),
        "=",
        reader.value(block, "VALUE"),
        ends[0],
        is_local=reader.in_function,
    ),
    "math_change": lambda reader, block, _, ends: Assign(
        reader.variable(block), "+=", reader.number(block, "DELTA"), ends[0]
    ),
    "lb_change": lambda reader, block, _, ends: Assign(
        reader.variable(block),
        reader.choice(block, "OP", CHANGES),
        reader.number(block, "VALUE"),
        ends[0],
    ),
    "lists_setIndex": set_index,
    "lb_change_index": change_index,
    "lb_dictionary_set": set_entry,
    "lb_dictionary_change": change_entry,
    "lb_dictionary_remove": remove_entry,
    "lists_getIndex": pop,
    "lb_return": lambda reader, block, _, ends: Return(reader.optional(block, "VALUE"), ends[0]),
    "lb_pass": lambda _reader, _block, _, ends: Pass(ends[0]),
    "lb_activate": lambda reader, block, _, ends: Activate(
        reader.name(block, block.fields.get("WHEN")), ends[0]
    ),
    "lb_deactivate": lambda reader, block, _, ends: Deactivate(
        reader.name(block, block.fields.get("WHEN")), ends[0]
    ),
    "text_print": lambda reader, block, _, ends: reader.perform(
        block, Call("print", (reader.text(block, "TEXT"),)), ends
    ),
    "lb_do": _do,
    "lb_call": lambda reader, block, _, ends: reader.perform(block, reader.call(block), ends),
    "procedures_callnoreturn": lambda reader, block, _, ends: reader.perform(
        block, reader.own_call(block), ends
    ),
    "lb_python": _raw,
    TEXT: _raw,
    LINE: _python_line,
    BLOCK: _python_block,
    "lb_comment": lambda reader, block, _notes, _ends: Comment(_one_line(reader, block, "TEXT")),
}
