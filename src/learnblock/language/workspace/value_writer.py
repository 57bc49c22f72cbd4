"""Write expressions as value blocks, and keep the blocks of an earlier workspace."""

from collections.abc import Iterable, Mapping
from itertools import count

from learnblock.blocks import BlockConfiguration, Parameter
from learnblock.blocks.ready_hats import READY_HATS
from learnblock.blocks.toolbox import SHADOWS, SKILL, Shadow, parameter_shadow
from learnblock.language.tree.nodes import (
    Call,
    Expression,
    Index,
    Item,
    Main,
    Name,
    Node,
    Program,
    Unary,
)
from learnblock.language.tree.traversal import expressions, statements, within
from learnblock.language.workspace.arguments import shadow_literal
from learnblock.language.workspace.block_reader import is_disabled
from learnblock.language.workspace.blocks import Block, FieldValue, Input, Variable
from learnblock.language.workspace.notes import NO_NOTES, Notes
from learnblock.language.workspace.reader import WorkspaceReader
from learnblock.language.workspace.shapes import Shape
from learnblock.language.workspace.statement_shapes import StatementShaper
from learnblock.language.workspace.survey import Survey

# How many operands each of these expressions has; an operand may have no block of its own.
_OPERANDS: Mapping[type[Expression], int] = {Unary: 1, Index: 2}
# Renaming a function may change one of these into another; the arguments stay the same.
_CALLS = frozenset(("procedures_callnoreturn", "procedures_callreturn", "lb_call", "lb_call_value"))
_NO_INPUTS: Mapping[str, Input] = {}


class ValueWriter:
    """Writes values.

    Args:
        program: the tree.
        configurations: the blocks of the skills, by name.
        before: the reader of the earlier workspace, whose blocks are kept where possible.
        in_use: the ids in the earlier workspace.
    """

    def __init__(
        self,
        program: Program,
        configurations: Mapping[str, BlockConfiguration],
        before: WorkspaceReader,
        in_use: Survey,
    ) -> None:
        self.shaper = StatementShaper(program, configurations)
        self.configurations = configurations
        self.before = before
        self.ids: dict[int, str] = {}
        self.taken: set[str] = set()
        used = in_use.blocks
        self.new_ids = (name for number in count(1) if (name := f"b{number}") not in used)
        self.variables = {name: Variable(name, key) for key, name in before.variables.items()}
        known = before.variables.keys() | in_use.variables
        self.new_variables = (name for number in count(1) if (name := f"v{number}") not in known)
        self.changed = _changed(self.shaper, StatementShaper(before.program, configurations))

    # Blocks that are kept.

    def stays(self, node: Expression, old: Block) -> bool:
        """Whether a block already has this value; if so, keep it with everything inside."""
        earlier = self.before.nodes.get(old.id)
        if old.id in self.taken or type(earlier) is not type(node) or earlier != node:
            return False
        if self.changed and self.has_changed(within(node)):
            return False
        self.taken.add(old.id)
        self.keep_values(node, earlier)
        return True

    def keep_values(self, node: Expression, earlier: Expression) -> None:
        """Record the blocks of an equal value as those of this one."""
        ids, before = self.ids, self.before.ids
        for part, other in zip(within(node), within(earlier), strict=True):
            ids[id(part)] = before[id(other)]

    def has_changed(self, nodes: Iterable[Node]) -> bool:
        """Whether nodes use a name whose blocks have changed."""
        return any(isinstance(node, Name | Call) and node.name in self.changed for node in nodes)

    def has_changed_within(self, statement: Item | Main) -> bool:
        return any(
            self.has_changed(within(value))
            for part in statements((statement,))  # type: ignore[arg-type]
            for value in expressions(part)
        )

    # Blocks that are written.

    def value(self, node: Expression, old: Block | None) -> Block:
        """Write a value as a block.

        Args:
            node: the value.
            old: the block that it may have been, or that may now be inside it.
        """
        if old is not None and self.stays(node, old):
            return old
        shape = self.shaper.value(node)
        block = self.block(shape, old, {})
        self.ids[id(node)] = block.id
        if len(shape.values) < _OPERANDS.get(type(node), 0):
            self.note_parts(node, block)
        return block

    def note_parts(self, node: Expression, block: Block) -> None:
        """Assign the parts of a value without their own blocks to the block of the value."""
        for part in within(node):
            self.ids.setdefault(id(part), block.id)

    def block(self, shape: Shape, old: Block | None, inputs: dict[str, Input]) -> Block:
        """Write a shape as a block, without a comment; keep the old block if possible.

        Args:
            shape: the content.
            old: the block that it may have been.
            inputs: the inputs with statements.
        """
        same = old if old is not None and self.may_be(shape, old) else None
        block = Block(shape.type, next(self.new_ids) if same is None else same.id)
        self.taken.add(block.id)
        block.fields = self.fields(shape.fields)
        block.inputs = self.inputs(shape, same, old) | inputs
        block.extraState = shape.extra
        if shape.notes is not NO_NOTES:
            block.data = shape.notes.data()
        if same is not None:
            _keep_looks(block, same)
        return block

    def may_be(self, shape: Shape, old: Block) -> bool:
        """Whether a block can get new content and keep its id."""
        return old.type == shape.type and old.id not in self.taken and not is_disabled(old)

    def fields(self, fields: Mapping[str, FieldValue | Name]) -> dict[str, FieldValue]:
        return {
            name: {"id": self.variable(value.name)} if isinstance(value, Name) else value
            for name, value in fields.items()
        }

    def variable(self, name: str) -> str:
        """The id of a variable."""
        variable = self.variables.get(name)
        if variable is None:
            variable = self.variables[name] = Variable(name, next(self.new_variables))
        return variable.id

    # Inputs.

    def inputs(self, shape: Shape, same: Block | None, old: Block | None) -> dict[str, Input]:
        """The values in the inputs of a block, and the shadows of empty inputs.

        Args:
            shape: the content of the block.
            same: the old block, if it keeps its id.
            old: the block that it may have been, or that may now be inside it.
        """
        shadows = self.shadows(shape.type)
        source = old if old is not None and {shape.type, old.type} <= _CALLS else same
        before = _NO_INPUTS if source is None else source.inputs
        wrapped = old if source is None else None
        inputs: dict[str, Input] = {}
        for name, node in shape.values.items():
            if same is not None and self.before.missing.get((same.id, name)) == node:
                self.keep_missing(node, same, name, inputs)
                continue
            inputs[name] = self.input(node, shadows.get(name), before.get(name), wrapped)
        for name, (shadow, _) in shadows.items():
            if name not in shape.values and name != "AT":
                inputs[name] = self.untouched(shadow, before.get(name))
        return inputs

    def keep_missing(
        self, node: Expression, old: Block, name: str, inputs: dict[str, Input]
    ) -> None:
        """An input that stays empty."""
        self.ids[id(node)] = old.id
        if name in old.inputs:
            inputs[name] = old.inputs[name]

    def input(
        self,
        node: Expression,
        shadow: tuple[Shadow, Parameter | None] | None,
        old: Input | None,
        wrapped: Block | None,
    ) -> Input:
        """The input with a value: in the shadow if that can show it, else in a block over it.

        Args:
            node: the value.
            shadow: the shadow of the input, if any, and its parameter.
            old: the previous content of the input.
            wrapped: a block that may now be inside this input.
        """
        inner = None if old is None else old.block
        under = None if old is None else old.shadow
        if shadow is None and under is not None:
            # The page has shadows of its own, such as that of a variable's first value.
            shadow = Shadow(under.type, "", ""), None
        if shadow is None:
            return Input(self.value(node, inner or wrapped))
        value = shadow_literal(node, *shadow)
        if value is not None and inner is None:
            block = self.shadow(value.type, {value.field: value.value}, value.notes, under)
            for part in within(node):
                self.ids[id(part)] = block.id
            return Input(shadow=block)
        return Input(self.value(node, inner or wrapped), under or self.default(shadow[0]))

    def untouched(self, shadow: Shadow, old: Input | None) -> Input:
        """An input that shows its default."""
        under = None if old is None else old.shadow
        return Input(shadow=self.shadow(shadow.type, {shadow.field: shadow.value}, NO_NOTES, under))

    def default(self, shadow: Shadow) -> Block:
        return Block(shadow.type, next(self.new_ids), fields={shadow.field: shadow.value})

    def shadow(
        self, kind: str, fields: dict[str, FieldValue], notes: Notes, old: Block | None
    ) -> Block:
        data = None if notes is NO_NOTES else notes.data()
        if old is None or old.type != kind:
            return Block(kind, next(self.new_ids), fields=fields, data=data)
        if old.fields == fields and old.data == data:
            return old
        return Block(kind, old.id, fields=fields, data=data)

    def shadows(self, kind: str) -> Mapping[str, tuple[Shadow, Parameter | None]]:
        """The shadows of a type of block, with the parameters that they are for."""
        skill = READY_HATS.get(kind) or (kind.startswith(SKILL) and kind.removeprefix(SKILL))
        configuration = self.configurations.get(skill) if skill else None
        if configuration is None:
            return _LANGUAGE.get(kind, {})
        return {
            parameter.name: (shadow, parameter)
            for parameter in configuration.parameters
            if (shadow := parameter_shadow(parameter)) is not None
        }


_LANGUAGE: Mapping[str, Mapping[str, tuple[Shadow, Parameter | None]]] = {
    kind: {name: (shadow, None) for name, shadow in shadows.items()}
    for kind, shadows in SHADOWS.items()
}


def _keep_looks(block: Block, old: Block) -> None:
    """Copy the position and appearance that the user chose for a block."""
    block.x, block.y = old.x, old.y
    block.collapsed, block.inline = old.collapsed, old.inline
    block.disabledReasons = old.disabledReasons


def _changed(new: StatementShaper, old: StatementShaper) -> frozenset[str]:
    """The names whose blocks have changed."""
    whens = new.whens ^ old.whens
    functions = {
        name
        for name in new.functions.keys() | old.functions.keys()
        if new.functions.get(name) != old.functions.get(name)
    }
    states = {prefix + name for name in whens for prefix in ("state_", "time_")}
    return frozenset(functions | states)
