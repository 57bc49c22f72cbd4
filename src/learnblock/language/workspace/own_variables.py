"""Make variables local in the functions that the page makes.

The page marks these definitions (`MARK`). There, ``set x to`` means ``set local x to`` if only a
call of the function inside itself can tell the difference: each call sets the variable before it
uses it, and nothing outside the function uses it.
"""

import re
from collections.abc import Iterable, Iterator

import msgspec

from learnblock.language.blocktext.names import to_python
from learnblock.language.workspace.block_reader import extra, is_disabled
from learnblock.language.workspace.blocks import Block, Input, Workspace
from learnblock.language.workspace.survey import blocks_in, variables_of
from learnblock.language.workspace.types import ANSWERING_FUNCTION, FUNCTION

#: The key in the state of a definition.
MARK = "locals"
_SET, _SET_LOCAL = "variables_set", "lb_set_local"
_WORDS = re.compile(r"\w+")


def with_locals(workspace: Workspace) -> Workspace:
    """The workspace with ``set local x to`` where the marked functions mean it."""
    if not any(_is_marked(stack[0]) for stack in workspace.stacks):
        return workspace
    users = _Users(workspace)
    stacks = [
        [_renamed(stack[0], users.first_sets(stack[0]), _SET_LOCAL), *stack[1:]]
        if _is_marked(stack[0])
        else stack
        for stack in workspace.stacks
    ]
    return Workspace(stacks, workspace.variables)


def without_locals(workspace: Workspace) -> Workspace:
    """The workspace with ``set x to`` in the marked functions.

    A function of which `with_locals` would make another one loses its mark.
    """
    if not any(_is_marked(stack[0]) for stack in workspace.stacks):
        return workspace
    users = _Users(workspace)
    stacks = []
    for first, *below in workspace.stacks:
        kept = first
        if _is_marked(first):
            local = {block.id for block in blocks_in([first]) if block.type == _SET_LOCAL}
            plain = _renamed(first, local, _SET)
            kept = plain if users.first_sets(plain) == local else _unmarked(first)
        stacks.append([kept, *below])
    return Workspace(stacks, workspace.variables)


def _is_marked(block: Block) -> bool:
    is_function = block.type in {FUNCTION, ANSWERING_FUNCTION} and not is_disabled(block)
    return is_function and extra(block, MARK) is True


def _unmarked(block: Block) -> Block:
    state = {key: value for key, value in block.extraState.items() if key != MARK}
    return msgspec.structs.replace(block, extraState=state or None)


def _renamed(block: Block, ids: set[str], kind: str) -> Block:
    """A block in which the blocks of some ids have another type."""
    if not ids:
        return block
    inputs = {
        name: msgspec.structs.replace(
            plugged, stack=[_renamed(statement, ids, kind) for statement in plugged.stack]
        )
        for name, plugged in block.inputs.items()
    }
    kind = kind if block.id in ids else block.type
    return msgspec.structs.replace(block, type=kind, inputs=inputs)


class _Users:
    """Who uses which variable: the stacks, and the blocks of marked functions."""

    def __init__(self, workspace: Workspace) -> None:
        self.names = {variable.id: variable.name for variable in workspace.variables}
        self.within: dict[str, set[str]] = {}
        self.stacks = {stack[0].id: self.note(stack) for stack in workspace.stacks}
        texts = (text for stack in workspace.stacks for text in _texts(stack))
        self.in_python = {word for text in texts for word in _WORDS.findall(text)}

    def note(self, blocks: Iterable[Block]) -> set[str]:
        """The variables that blocks use, everything inside them included."""
        names: set[str] = set()
        for block in blocks:
            inner = variables_of(block)
            for plugged in block.inputs.values():
                inner |= self.note(_blocks(plugged))
            self.within[block.id] = inner
            names |= inner
        return names

    def first_sets(self, definition: Block) -> set[str]:
        """The blocks of a function that are the first to set a variable of its own."""
        others = (used for first, used in self.stacks.items() if first != definition.id)
        shared = variables_of(definition).union(*others)
        candidates = self.within[definition.id] - shared
        own = (key for key in candidates if not self.is_in_python(key))
        inputs = (definition.inputs.get(name, Input()) for name in ("STACK", "RETURN"))
        chain = [block for plugged in inputs for block in _blocks(plugged)]
        return {first for key in own if (first := self.first_set(chain, key)) is not None}

    def is_in_python(self, key: str) -> bool:
        """Whether a part that stays Python may use a variable."""
        name = self.names.get(key, "")
        return bool({name, to_python(name)} & self.in_python)

    def first_set(self, chain: list[Block], key: str) -> str | None:
        """The block that sets a variable before any other of a chain uses it; None without one."""
        users = [block for block in chain if key in self.within[block.id]]
        if not users or is_disabled(users[0]):
            return None
        first = users[0]
        inner = map(_blocks, first.inputs.values())
        using = [part for part in inner if any(key in self.within[block.id] for block in part)]
        if first.type == _SET and key in variables_of(first):
            return None if using else first.id
        if len(users) > 1 or len(using) != 1 or key in variables_of(first):
            return None
        return self.first_set(using[0], key)


def _blocks(plugged: Input) -> list[Block]:
    values = (block for block in (plugged.block, plugged.shadow) if block is not None)
    return [*values, *plugged.stack]


def _texts(blocks: Iterable[Block]) -> Iterator[str]:
    """Python in blocks, and anything else that was typed in."""
    for block in blocks_in(blocks):
        yield from (value for value in block.fields.values() if isinstance(value, str))
        if block.type.startswith("lb_python"):
            yield str(block.extraState)
