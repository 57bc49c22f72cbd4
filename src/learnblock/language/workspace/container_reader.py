"""Read blocks that change lists and dictionaries, and calls as statements."""

from learnblock.i18n import Phrase
from learnblock.language.blocktext.statement_parser import ASSIGNMENTS
from learnblock.language.tree.nodes import (
    Assign,
    Call,
    Expression,
    Index,
    List,
    Name,
    Perform,
    SkillCall,
)
from learnblock.language.workspace.block_reader import plugged
from learnblock.language.workspace.blocks import Block
from learnblock.language.workspace.notes import Ends, Notes
from learnblock.language.workspace.value_reader import ValueReader, popped

#: The operators of a change, by the value of its field.
CHANGES = {operator: operator for operator in sorted(ASSIGNMENTS - {"="})}


class ContainerReader(ValueReader):
    """Reads what a list or a dictionary holds as the target of a statement."""

    def perform(self, block: Block, call: Expression, ends: Ends) -> Perform | None:
        """A call as a statement."""
        if isinstance(call, Call | SkillCall):
            return Perform(self.made(call, block), ends[0])
        self.report(block, "no-effect", Phrase("workspace-unused-value"))
        return None

    def target(
        self, block: Block, values: Expression, place: Expression, name: str = "LIST"
    ) -> Index | None:
        """An item of the list or dictionary in an input, as the target of an assignment."""
        root = values
        while isinstance(root, Index):
            root = root.value
        if isinstance(root, Name | Call | SkillCall):
            return self.made(Index(values, place), block)
        if plugged(block, name) is not None:
            self.report(block, "no-effect", Phrase("workspace-list-without-name"))
        return None


def pop(reader: ContainerReader, block: Block, _: Notes, ends: Ends) -> Perform | None:
    call = popped(reader, block, reader.list(block, "VALUE"))
    return reader.perform(block, reader.made(call, block), ends)


def _changed_list(reader: ContainerReader, block: Block) -> Expression:
    """The list that a block changes; one that no variable holds would be lost."""
    return reader.value(block, "LIST", List(), "workspace-missing-variable-of-list")


def set_index(
    reader: ContainerReader, block: Block, _: Notes, ends: Ends
) -> Assign | Perform | None:
    values = _changed_list(reader, block)
    if block.fields.get("MODE") == "INSERT":
        return _insert(reader, block, values, ends)
    target = reader.target(block, values, reader.place(block, values))
    if target is None:
        return None
    return Assign(target, "=", reader.value(block, "TO"), ends[0])


def _insert(
    reader: ContainerReader, block: Block, values: Expression, ends: Ends
) -> Perform | None:
    if block.fields.get("WHERE") == "LAST":
        call = Call("append", (values, reader.value(block, "TO")))
    else:
        place = reader.place(block, values)
        call = Call("insert", (values, place, reader.value(block, "TO")))
    return reader.perform(block, reader.made(call, block), ends)


def change_index(reader: ContainerReader, block: Block, _: Notes, ends: Ends) -> Assign | None:
    place = reader.number(block, "INDEX")
    target = reader.target(block, _changed_list(reader, block), place)
    operator = reader.choice(block, "OP", CHANGES)
    value = reader.number(block, "VALUE")
    return None if target is None else Assign(target, operator, value, ends[0])


def _entry(reader: ContainerReader, block: Block) -> Index | None:
    """The entry of a dictionary that a block sets or changes."""
    return reader.target(block, reader.dictionary(block), reader.key(block), "DICTIONARY")


def set_entry(reader: ContainerReader, block: Block, _: Notes, ends: Ends) -> Assign | None:
    target, value = _entry(reader, block), reader.value(block, "VALUE")
    return None if target is None else Assign(target, "=", value, ends[0])


def change_entry(reader: ContainerReader, block: Block, _: Notes, ends: Ends) -> Assign | None:
    target, value = _entry(reader, block), reader.number(block, "VALUE")
    operator = reader.choice(block, "OP", CHANGES)
    return None if target is None else Assign(target, operator, value, ends[0])


def remove_entry(reader: ContainerReader, block: Block, _: Notes, ends: Ends) -> Perform | None:
    call = Call("pop", (reader.dictionary(block), reader.key(block)))
    return reader.perform(block, reader.made(call, block), ends)
