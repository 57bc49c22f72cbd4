"""A workspace of blocks: Blockly's serialization, with each chain of blocks as a list.

Blockly nests each block in the one above. JSON decoders fail on that after a few hundred
statements, so the form for messages and files is flat: a stack is a list of blocks, from the top.
The rest (`fields`, `extraState`, shadows) is in Blockly's own format, so that the page needs only a
dozen lines to convert it.
"""

from typing import Any

from msgspec import Struct, field

#: The value of a field: a string, a number, a Boolean, or the ``{"id": ...}`` of a variable.
FieldValue = str | float | bool | dict[str, str] | None


class BlockComment(Struct, omit_defaults=True):
    """The comment of a block.

    Args:
        text: the comment without ``#``; each line is a line of the program.
        pinned: whether its bubble is open.
        width: the width of the bubble.
        height: the height of the bubble.
    """

    text: str
    pinned: bool = False
    width: float | None = None
    height: float | None = None


class Block(Struct, omit_defaults=True):
    """A block.

    Args:
        type: the type, such as ``math_number`` or ``lb_skill_move_straight``.
        id: an identifier that stays the same when other parts of the program are edited.
        x: the horizontal position of the first block of a stack; None lets the page choose.
        y: the vertical position; see `x`.
        fields: the fields by name.
        inputs: the inputs by name.
        extraState: the state of the type's mutator.
        comment: the comment, if any.
        data: details that the program needs but the block cannot show, as JSON.
        collapsed: whether it is folded.
        disabledReasons: why it is disabled, as Blockly's codes.
        inline: whether its inputs are in one row; None for the default.
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
    """An input of a block: a value (`block` over `shadow`), or a `stack` of statements."""

    block: Block | None = None
    shadow: Block | None = None
    stack: list[Block] = field(default_factory=list)


class Variable(Struct, frozen=True):
    """A variable of the workspace."""

    name: str
    id: str


class Workspace(Struct):
    """A workspace: its stacks in the order of the program, including loose ones."""

    stacks: list[list[Block]] = field(default_factory=list)
    variables: list[Variable] = field(default_factory=list)

    def __post_init__(self) -> None:
        # Only a file that was written by hand has empty stacks; they mean nothing.
        self.stacks = [stack for stack in self.stacks if stack]
