"""Find the ids of the blocks and variables that a workspace uses."""

from collections.abc import Iterable, Iterator
from itertools import count
from typing import NamedTuple

import msgspec

from learnblock.language.workspace.blocks import Block, Workspace


class Survey(NamedTuple):
    """The ids in use.

    Args:
        blocks: the ids of all blocks, including shadows.
        variables: the ids of the variables that the blocks name.
        repeated: whether two blocks have the same id.
    """

    blocks: set[str]
    variables: set[str]
    repeated: bool


def survey(workspace: Workspace) -> Survey:
    """Collect the ids in a workspace, including its loose stacks."""
    ids: list[str] = []
    variables: set[str] = set()
    for block in _blocks(workspace):
        ids.append(block.id)
        if "VAR" in block.fields or block.extraState is not None:
            variables.update(variables_of(block))
    blocks = set(ids)
    return Survey(blocks, variables, len(blocks) < len(ids))


def _blocks(workspace: Workspace) -> Iterator[Block]:
    return blocks_in(block for stack in workspace.stacks for block in stack)


def blocks_in(blocks: Iterable[Block]) -> Iterator[Block]:
    """Some blocks and all blocks inside them, including shadows."""
    ahead = list(blocks)
    while ahead:
        block = ahead.pop()
        yield block
        for inner in block.inputs.values():
            if inner.block is not None:
                ahead.append(inner.block)
            if inner.shadow is not None:
                ahead.append(inner.shadow)
            if inner.stack:
                ahead += inner.stack


def distinct(workspace: Workspace) -> Workspace:
    """A copy of a workspace with a new id for each block whose id is already taken."""
    seen = {block.id for block in _blocks(workspace)}
    ids = (name for number in count(1) if (name := f"d{number}") not in seen)
    copied = msgspec.json.decode(msgspec.json.encode(workspace), type=Workspace)
    taken: set[str] = set()
    for block in _blocks(copied):
        if block.id in taken:
            block.id = next(ids)
        taken.add(block.id)
    return copied


def variables_of(block: Block) -> set[str]:
    """The ids of the variables that a block itself names."""
    fields = block.fields.values()
    keys = {chosen.get("id", "") for chosen in fields if isinstance(chosen, dict)}
    parameters = block.extraState.get("params") if isinstance(block.extraState, dict) else None
    if isinstance(parameters, list):
        ids = (parameter.get("id") for parameter in parameters if isinstance(parameter, dict))
        keys.update(key for key in ids if isinstance(key, str))
    return keys
