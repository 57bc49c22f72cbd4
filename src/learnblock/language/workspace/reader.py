"""Read a workspace as a program: the hat blocks and the stacks under them."""

from collections.abc import Mapping

from learnblock.blocks import BlockConfiguration
from learnblock.blocks.ready_hats import READY_HATS
from learnblock.errors import Diagnostic, ProgramError
from learnblock.i18n import Phrase
from learnblock.language.tree.nodes import (
    Blank,
    Comment,
    Constant,
    Def,
    Expression,
    Import,
    Item,
    Main,
    Program,
    Return,
    Setup,
    When,
    WithoutRobot,
)
from learnblock.language.workspace.arrangement import arranged
from learnblock.language.workspace.block_reader import extra, extra_list, is_disabled, plugged
from learnblock.language.workspace.blocks import Block, Workspace
from learnblock.language.workspace.notes import Ends, Notes
from learnblock.language.workspace.own_variables import with_locals
from learnblock.language.workspace.python_shapes import Joiner
from learnblock.language.workspace.statement_reader import (
    Group,
    StatementReader,
    import_of,
    setup_of,
)
from learnblock.language.workspace.types import (
    ANSWERING_FUNCTION,
    COMMENT,
    FUNCTION,
    HATS,
    MAIN,
    START,
    WHENS,
    is_name,
)


class WorkspaceReader(StatementReader):
    """Reads a workspace.

    `entries` are the statements and definitions of the top level in order, each with its block and
    its hat block, which separate comments do not have; `program` is the result.
    """

    def __init__(
        self, workspace: Workspace, configurations: Mapping[str, BlockConfiguration]
    ) -> None:
        super().__init__(workspace, configurations)
        self.groups: dict[str, Group] = {}
        self.silent: set[str] = set()
        self.entries: list[tuple[Group, Block, Block | None]] = []
        self.has_main = False
        self.joiner = Joiner(self.definitions(workspace))
        program = [stack for stack in workspace.stacks if is_part(stack)]
        self.alone = len(program) == 1 and len(statements_of(program[0][0])) == 1
        self.robot_and_raw = len(program) == 1 and _is_robot_and_raw(statements_of(program[0][0]))
        for stack in program:
            if is_note(stack):
                self.comments(stack)
            else:
                self.stack(stack[0])
        self.program = arranged(self.separated())

    def definitions(self, workspace: Workspace) -> Program:
        """The functions and events of a workspace, without what is in them."""
        items: list[Item] = []
        for hat, *_ in workspace.stacks:
            name = hat.fields.get("NAME")
            if not isinstance(name, str) or not is_name(name) or is_disabled(hat):
                continue
            if hat.type in WHENS:
                items.append(When(name, None, ()))
            elif hat.type in {FUNCTION, ANSWERING_FUNCTION}:
                items.append(Def(name, (), ()))
        return Program(tuple(items))

    def stack(self, hat: Block) -> None:
        """Read a stack that is part of the program."""
        if hat.type == START:
            for block in statements_of(hat):
                self.entry(self.group(block, self.top_statement), block, hat)
        elif hat.type == MAIN and self.has_main:
            self.report(hat, "second-main", Phrase("workspace-second-main"))
        else:
            self.entry(self.group(hat, self.hat), hat, hat)

    def comments(self, stack: list[Block]) -> None:
        """Read comments outside of any hat."""
        for block in stack:
            self.entry(self.group(block), block, None)

    def entry(self, group: Group | None, block: Block, hat: Block | None) -> None:
        if group is None:
            return
        if type(group.statement) is Setup and not self.sets_up(group, block):
            del self.groups[block.id]
            return
        self.has_main = self.has_main or type(group.statement) is Main
        self.entries.append((group, block, hat))

    def sets_up(self, group: Group, block: Block) -> bool:
        """Whether a block that creates the robot comes first and is not implied anyway."""
        setup = group.statement
        # `main` runs last wherever it is drawn.
        if any(
            type(group.statement) not in {Comment, Import, Main} for group, _, _ in self.entries
        ):
            self.report(block, "misplaced-block", Phrase("workspace-robot-not-first"))
            return False
        noted = any(type(item) is Comment for item in group.lead)
        return noted or setup != Setup() or self.robot_and_raw

    def top_statement(self, block: Block, notes: Notes, ends: Ends) -> Item | None:
        """Read a block under the start block, where more than statements is allowed."""
        match block.type:
            case "lb_import":
                return import_of(self, block, ends)
            case "lb_setup":
                return setup_of(self, block, ends)
            case "lb_without_robot":
                return WithoutRobot()
        return self.statement(block, notes, ends)

    def hat(self, block: Block, notes: Notes, ends: Ends) -> Def | When | Main:
        if block.type == MAIN:
            return Main(self.body(block, "DO"))
        self.in_function = True
        try:
            if block.type in WHENS:
                return self.when(block, ends)
            return self.function(block, notes, ends)
        finally:
            self.in_function = False

    def when(self, block: Block, ends: Ends) -> When:
        condition = self.condition(block)
        name = self.name(block, block.fields.get("NAME"))
        return When(name, condition, self.body(block, "DO"), ends[0])

    def condition(self, block: Block) -> Expression | None:
        """The condition of a ``when``; a ready hat is the call of its skill, too."""
        skill = READY_HATS.get(block.type)
        if skill is not None:
            call = self.skill(block, skill)
            self.note(call, block)
            return call
        if extra(block, "condition") is True or plugged(block, "CONDITION") is not None:
            return self.truth(block, "CONDITION")
        return None

    def function(self, block: Block, notes: Notes, ends: Ends) -> Def:
        name = self.name(block, block.fields.get("NAME"))
        if block.type == FUNCTION:
            return Def(name, self.parameters(block), self.body(block, "STACK"), ends[0])
        result = Return(self.value(block, "RETURN", Constant(None)))
        self.note(result, block)
        body = self.statements(block, "STACK")
        apart = (Blank(),) if notes.apart and body else ()
        return Def(name, self.parameters(block), (*body, *apart, result), ends[0])

    def parameters(self, block: Block) -> tuple[str, ...]:
        """The names of a function's parameters."""
        names = [self.name(block, name) for name in self.parameter_names(block)]
        if len(set(names)) < len(names):
            self.report(block, "duplicate-parameter", Phrase("workspace-duplicate-parameter"))
        return tuple(dict.fromkeys(names))

    def parameter_names(self, block: Block) -> list[object]:
        """The current names of the variables, which may have changed since the block was saved."""
        parameters: list[object] = []
        for parameter in extra_list(block, "params"):
            name, key = (
                (parameter.get("name"), parameter.get("id"))
                if isinstance(parameter, dict)
                else (parameter, None)
            )
            parameters.append(self.variables.get(key, name) if isinstance(key, str) else name)
        return parameters

    def separated(self) -> list[Group]:
        """The entries, with a blank line below comments outside of any hat."""
        groups: list[Group] = []
        is_below_note = False
        for group, _, hat in self.entries:
            if is_below_note and hat is not None and group.lead[:1] != (Blank(),):
                group = Group((Blank(), *group.lead), group.statement)  # noqa: PLW2901
            groups.append(group)
            is_below_note = hat is None
        return groups


def statements_of(hat: Block) -> list[Block]:
    """The blocks under a start block."""
    body = hat.inputs.get("DO")
    return [] if hat.type != START or body is None else body.stack


def _is_robot_and_raw(blocks: list[Block]) -> bool:
    """Whether one block of raw Python needs the block that creates the robot above it."""
    types = [block.type for block in blocks]
    return types == ["lb_setup", "lb_python"] and blocks[1].comment is None


def is_part(stack: list[Block]) -> bool:
    """Whether a stack is part of the program."""
    return is_note(stack) or (stack[0].type in HATS and not is_disabled(stack[0]))


def is_note(stack: list[Block]) -> bool:
    """Whether a stack consists of comments."""
    return all(block.type == COMMENT and not is_disabled(block) for block in stack)


def read(workspace: Workspace, configurations: Mapping[str, BlockConfiguration]) -> WorkspaceReader:
    """Read a workspace.

    Raises:
        ProgramError: its blocks are nested too deeply.
    """
    try:
        return WorkspaceReader(with_locals(workspace), configurations)
    except RecursionError:
        too_deep = Diagnostic("too-deep", Phrase("workspace-too-deep"))
        raise ProgramError("workspace", [too_deep]) from None
