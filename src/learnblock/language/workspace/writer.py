"""Write a program as a workspace, and keep the rest of the earlier workspace."""

from collections.abc import Mapping, Sequence
from itertools import groupby, pairwise

import msgspec

from learnblock.blocks import BlockConfiguration
from learnblock.language.tree.nodes import (
    Body,
    Comment,
    Def,
    If,
    Item,
    Main,
    Node,
    Program,
    PythonBlock,
    When,
    While,
)
from learnblock.language.tree.traversal import bodies, expressions, statements
from learnblock.language.workspace.alignment import Match, aligned
from learnblock.language.workspace.arrangement import drawn, grouped
from learnblock.language.workspace.block_reader import extra, extra_list, is_disabled
from learnblock.language.workspace.blocks import Block, Input, Variable, Workspace
from learnblock.language.workspace.notes import comment_of
from learnblock.language.workspace.own_variables import MARK
from learnblock.language.workspace.reader import WorkspaceReader, is_note, is_part, statements_of
from learnblock.language.workspace.shapes import Shape
from learnblock.language.workspace.statement_reader import Group
from learnblock.language.workspace.statement_shapes import when_shape, while_shape
from learnblock.language.workspace.survey import Survey, survey
from learnblock.language.workspace.types import (
    ANSWERING_FUNCTION,
    COMMENT,
    FOREVER,
    FUNCTION,
    START,
    WHEN,
    WHENS,
    WHILE,
)
from learnblock.language.workspace.value_writer import ValueWriter

_HATTED = (Def, When, Main)


class WorkspaceWriter(ValueWriter):
    """Writes a program as a workspace, keeping as much of the earlier one as possible."""

    def __init__(
        self,
        program: Program,
        configurations: Mapping[str, BlockConfiguration],
        before: WorkspaceReader,
        previous: Workspace,
        in_use: Survey,
    ) -> None:
        super().__init__(program, configurations, before, in_use)
        self.previous = previous
        self.set_aside = before.variables.keys() - in_use.variables
        # The blocks below hats, where they do not belong.
        self.tails = {stack[0].id: stack[1:] for stack in previous.stacks if len(stack) > 1}
        # The first block of the stack of each comment outside of any hat.
        self.notes = {
            block.id: stack[0].id for stack in filter(is_note, previous.stacks) for block in stack
        }
        self.stacks: list[list[Block]] = []
        self.has_main = program.main is not None
        self.hats: set[str] = set()
        self.top(program)
        self.stacks += self.rest()
        self.workspace = Workspace(self.stacks, self.known_variables())

    # The top level.

    def top(self, program: Program) -> None:
        groups = drawn(program)
        old = self.before.entries
        places = _with_moved(groups, old, _matches(groups, [group for group, _, _ in old]))
        run: list[tuple[Group, Block, Block | None]] = []
        for group, match in zip(groups, places, strict=True):
            _, old_block, hat = (None, None, None) if match is None else old[match.place]
            block = self.statement(group, old_block, equal=match is not None and match.equal)
            if isinstance(group.statement, _HATTED):
                self.run(run)
                run = []
                self.definition(block)
            else:
                run.append((group, block, hat))
        self.run(run)

    def definition(self, block: Block) -> None:
        self.hats.add(block.id)
        self.stacks.append([block, *self.tails.get(block.id, [])])

    def run(self, run: Sequence[tuple[Group, Block, Block | None]]) -> None:
        """Write consecutive statements; comments outside of any hat stay there."""
        notes = self.notes_of_run([(group, block) for group, block, _ in run])
        for note, part in groupby(zip(notes, run, strict=True), lambda pair: pair[0]):
            blocks = [(block, hat) for _, (_, block, hat) in part]
            is_only_comments = all(block.type == COMMENT and hat is None for block, hat in blocks)
            if note is not None or is_only_comments:
                self.stacks.append([block for block, _ in blocks])
            else:
                self.starts(blocks)

    def notes_of_run(self, run: Sequence[tuple[Group, Block]]) -> list[str | None]:
        """The stack outside of any hat for each statement that belongs into one.

        Without a blank line between them, new comments go where the comments next to them are,
        because a hat below a comment begins with a blank line.
        """
        notes = [self.notes.get(block.id) for _, block in run]
        joined = [_continues(group, other) for (group, _), (other, _) in pairwise(run)]
        for place, joins in enumerate(joined, 1):
            if joins and notes[place] is None:
                notes[place] = notes[place - 1]
        for place in reversed(range(len(joined))):
            if joined[place] and notes[place] is None:
                notes[place] = notes[place + 1]
        return notes

    def starts(self, run: Sequence[tuple[Block, Block | None]]) -> None:
        """Write consecutive statements as stacks, each under the hat block it was under before."""
        home = next((hat for _, hat in run if hat is not None), None)
        blocks: list[Block] = []
        for block, hat in run:
            if (
                hat is not None
                and home is not None
                and hat.id != home.id
                and hat.id not in self.hats
            ):
                self.start(blocks, home)
                home, blocks = hat, []
            blocks.append(block)
        if blocks:
            self.start(blocks, home)

    def start(self, blocks: list[Block], hat: Block | None) -> None:
        if hat is None or hat.id in self.hats:
            self.stacks.append(
                [Block(START, next(self.new_ids), inputs={"DO": Input(stack=blocks)})]
            )
            return
        self.hats.add(hat.id)
        blocks = self.with_silent(blocks, statements_of(hat))
        inputs = {**hat.inputs, "DO": Input(stack=blocks)}
        self.stacks.append(
            [msgspec.structs.replace(hat, inputs=inputs), *self.tails.get(hat.id, [])]
        )

    def rest(self) -> list[list[Block]]:
        """The stacks outside the program, and hat blocks without content."""
        stacks: list[list[Block]] = []
        for stack in self.previous.stacks:
            if not stack or stack[0].id in self.hats:
                continue
            if not is_part(stack) or self.is_empty_hat(stack[0]):
                stacks.append(stack)
            elif stack[0].type == START and (silent := self.silent(statements_of(stack[0]))):
                hat = msgspec.structs.replace(stack[0], inputs={"DO": Input(stack=silent)})
                stacks.append([hat, *stack[1:]])
        return stacks

    def is_empty_hat(self, hat: Block) -> bool:
        """Whether a hat has no content; without a `main`, an empty one would become the `main`."""
        if hat.type == START:
            return not statements_of(hat)
        return hat.id not in self.before.groups and self.has_main

    # Statements.

    def statement(self, group: Group, old: Block | None, *, equal: bool) -> Block:
        """Write a statement and the comments above it as a block.

        Args:
            group: the statement and its comments.
            old: the block that it was.
            equal: whether the content of that block is unchanged.
        """
        if old is not None and equal and self.can_stay(group, old):
            return old
        node = group.statement
        shape = self.shape(node, old)
        same = old if old is not None and _may_follow(old.type, shape.type) else None
        inner_bodies = {
            name: inner
            for name, body in shape.bodies.items()
            if (inner := self.body(body, same.inputs.get(name) if same else None)).stack
        }
        comment, notes = comment_of(group.lead, shape.ends, shape.notes, same)
        block = self.block(self.parametrized(shape._replace(notes=notes), old), old, inner_bodies)
        block.comment = comment
        self.note_statement(group, block)
        return block

    def shape(self, node: Item | Main, old: Block | None) -> Shape:
        """The shape of a statement; a user's own 'repeat while true' does not become 'forever'.

        Nor does the block of an event become a ready hat.
        """
        earlier = None if old is None else self.before.groups[old.id].statement
        kind = None if old is None else old.type
        match node, earlier:
            case While(), While(is_endless=True) if kind == WHILE:
                return while_shape(node)
            case When(), When() if kind == WHEN and self.shaper.ready_hat(earlier):
                return when_shape(node)
        return self.shaper.statement(node)

    def may_be(self, shape: Shape, old: Block) -> bool:
        """Whether a block can get new content and keep its id; an event also keeps its place."""
        if {old.type, shape.type} <= WHENS:
            return old.id not in self.taken and not is_disabled(old)
        return super().may_be(shape, old)

    def can_stay(self, group: Group, old: Block) -> bool:
        """Whether a block with the same content can stay; if so, keep it with everything inside."""
        earlier = self.before.groups[old.id]
        if old.id in self.taken:
            return False
        if self.changed and self.has_changed_within(group.statement):
            return False
        self.taken.add(old.id)
        self.keep(group, earlier)
        return True

    def keep(self, group: Group, earlier: Group) -> None:
        """Record the blocks of an equal statement as those of this one."""
        ids, before = self.ids, self.before.ids
        for note, other in zip(group.lead, earlier.lead, strict=True):
            ids[id(note)] = before[id(other)]
        new, old = statements((group.statement,)), statements((earlier.statement,))  # type: ignore[arg-type]
        for statement, was in zip(new, old, strict=True):
            if id(was) in before:
                ids[id(statement)] = before[id(was)]
            for part, part_was in zip(_parts(statement), _parts(was), strict=True):
                ids[id(part)] = before[id(part_was)]
            for value, value_was in zip(expressions(statement), expressions(was), strict=True):
                self.keep_values(value, value_was)

    def note_statement(self, group: Group, block: Block) -> None:
        """Assign the parts of a statement without their own blocks to its block."""
        for note in (*group.lead, group.statement, *_parts(group.statement)):
            self.ids[id(note)] = block.id
        for value in expressions(group.statement):
            self.note_parts(value, block)
        for body in bodies(group.statement):
            for statement in body[-2:]:
                self.ids.setdefault(id(statement), block.id)

    def parametrized(self, shape: Shape, old: Block | None) -> Shape:
        """The shape of a function, with the ids of its parameters and what a call begins with."""
        if shape.type not in {FUNCTION, ANSWERING_FUNCTION}:
            return shape
        mark = {MARK: True} if old is not None and extra(old, MARK) is True else {}
        if shape.extra is None:
            return shape._replace(extra=mark or None)
        names = [parameter["name"] for parameter in shape.extra["params"]]
        samples = {} if old is None else _samples(old)
        parameters = [
            {"name": name, "id": self.variable(name), **samples.get(name, {})} for name in names
        ]
        return shape._replace(extra={"params": parameters, **mark})

    def body(self, body: Body, old: Input | None) -> Input:
        """Write a body, and keep the blocks of the old stack that have no content."""
        chain = [] if old is None else old.stack
        earlier = [block for block in chain if block.id in self.before.groups]
        groups = grouped(body)
        places = aligned(groups, [self.before.groups[block.id] for block in earlier])
        blocks = [
            self.statement(group, earlier[match.place], equal=match.equal)
            if match
            else self.statement(group, None, equal=False)
            for group, match in zip(groups, places, strict=True)
        ]
        return Input(stack=self.with_silent(blocks, chain))

    # Blocks without content: disabled, or of an unknown type.

    def silent(self, chain: Sequence[Block]) -> list[Block]:
        return [block for block in chain if block.id in self.before.silent]

    def with_silent(self, blocks: list[Block], chain: Sequence[Block]) -> list[Block]:
        """A stack with the blocks without content, each below the block it was below before."""
        if not self.silent(chain):
            return blocks
        below: dict[str | None, list[Block]] = {}
        here = {block.id for block in blocks}
        above: str | None = None
        for block in chain:
            if block.id in here:
                above = block.id
            elif block.id in self.before.silent:
                below.setdefault(above, []).append(block)
        result = below.get(None, [])
        for block in blocks:
            result += [block, *below.get(block.id, [])]
        return result

    def known_variables(self) -> list[Variable]:
        """The variables in use, and those that the user created for later."""
        used = survey(Workspace(self.stacks)).variables
        known = {key: Variable(name, key) for key, name in self.before.variables.items()}
        known.update((variable.id, variable) for variable in self.variables.values())
        return [
            variable
            for variable in known.values()
            if variable.id in used or variable.id in self.set_aside
        ]


def _samples(block: Block) -> Mapping[str, Mapping[str, object]]:
    """What the page has noted about the parameters of a function, by their names."""
    return {
        name: {"sample": sample}
        for parameter in extra_list(block, "params")
        if isinstance(parameter, dict)
        and isinstance(name := parameter.get("name"), str)
        and isinstance(sample := parameter.get("sample"), str | int | float)
    }


def _continues(group: Group, other: Group) -> bool:
    """Whether two comments have neither a statement nor a blank line between them."""
    return type(group.statement) is type(other.statement) is Comment and not other.lead


def _may_follow(old: str, new: str) -> bool:
    """Whether a block of a type keeps what is inside one of another type."""
    return old == new or {old, new} == {WHILE, FOREVER} or {old, new} <= WHENS


def _matches(groups: Sequence[Group], old: Sequence[Group]) -> list[Match | None]:
    """The matches of definitions and of statements, which may have moved past one another."""
    matches: list[Match | None] = [None] * len(groups)
    for hatted in (True, False):
        new_places, old_places = (
            [i for i, group in enumerate(some) if isinstance(group.statement, _HATTED) is hatted]
            for some in (groups, old)
        )
        among = aligned([groups[i] for i in new_places], [old[i] for i in old_places])
        for place, match in zip(new_places, among, strict=True):
            if match is not None:
                matches[place] = match._replace(place=old_places[match.place])
    return matches


def _with_moved(
    groups: Sequence[Group],
    old: Sequence[tuple[Group, Block, Block | None]],
    matches: list[Match | None],
) -> list[Match | None]:
    """The matches, including functions and whens that were moved past others."""
    taken = {match.place for match in matches if match is not None}
    free: dict[tuple[type, str] | None, int] = {
        key: place
        for place, (group, _, _) in enumerate(old)
        if place not in taken and (key := _key(group)) is not None
    }
    return [
        Match(place, old[place][0] == group)
        if match is None and (place := free.pop(_key(group), None)) is not None
        else match
        for group, match in zip(groups, matches, strict=True)
    ]


def _key(group: Group) -> tuple[type, str] | None:
    """The key that identifies a function or a when."""
    statement = group.statement
    return (type(statement), statement.name) if isinstance(statement, Def | When) else None


def _parts(node: Item | Main) -> tuple[Node, ...]:
    """The parts of a statement that are nodes: the branches of an ``if``."""
    if isinstance(node, PythonBlock):
        return node.parts
    if not isinstance(node, If):
        return ()
    return node.branches if node.otherwise is None else (*node.branches, node.otherwise)
