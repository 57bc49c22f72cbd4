"""A workspace of blocks: Blockly's own serialization, with each chain of blocks as a list.

Blockly nests the block below within the block above. A JSON decoder breaks on that after a few
hundred statements, so what travels between page and server, and is saved, is flat: a stack is a
list of blocks, from the top. All else (`fields`, `extraState`, shadows) is as Blockly writes it, so
that the page translates one into the other with a dozen lines.
"""

from typing import Any

from msgspec import Struct, field

#: What a field may hold: a text, a number, a tick, or ``{"id": ...}`` of a variable.
FieldValue = str | float | bool | dict[str, str] | None


class BlockComment(Struct, omit_defaults=True):
    """A block's comment.

    Args:
        text: without ``#``, a line of the program each.
        pinned: whether its bubble is open.
        width: of the bubble.
        height: of the bubble.
    """

    text: str
    pinned: bool = False
    width: float | None = None
    height: float | None = None


class Block(Struct, omit_defaults=True):
    """A block.

    Args:
        type: such as ``math_number`` or ``lb_skill_move_straight``.
        id: stays the block's through every edit elsewhere.
        x: of a stack's first block; None when the page is to find it a place.
        y: see `x`.
        fields: by name.
        inputs: by name.
        extraState: what the type's mutator keeps.
        comment: or None.
        data: what a block of Blockly's cannot show and the program must not lose, as JSON.
        collapsed: whether it is folded.
        disabledReasons: why it is disabled, as Blockly names it.
        inline: whether its inputs stand in one row, where somebody chose that.
    """

    type: str
    id: str
    x: float | None = None
    y: float | None = None
    fields: dict[str, FieldValue] = field(default_factory=dict)
    inputs: dict[str, "Input"] = field(default_factory=dict)
    extraState: Any = None  # noqa: N815 - Blockly's name
    comment: BlockComment | None = None
    data: str | None = None
    collapsed: bool = False
    disabledReasons: list[str] = field(default_factory=list)  # noqa: N815 - Blockly's name
    inline: bool | None = None


class Input(Struct, omit_defaults=True):
    """What is plugged into a block: a value (`block` over `shadow`), or a `stack` of statements."""

    block: Block | None = None
    shadow: Block | None = None
    stack: list[Block] = field(default_factory=list)


class Variable(Struct, frozen=True):
    """A variable of the workspace."""

    name: str
    id: str


class Workspace(Struct):
    """A workspace: its stacks in the order of the program, loose ones among them."""

    stacks: list[list[Block]] = field(default_factory=list)
    variables: list[Variable] = field(default_factory=list)
