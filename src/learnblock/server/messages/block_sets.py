"""What is said of which blocks are shown."""

from learnblock.blocks.block_sets import BlockSet
from learnblock.server.messages.base import Message, Name, Text

# The page speaks.


class ListBlockSets(Message, frozen=True):
    """Ask for `BlockSets`."""


class ChooseBlockSet(Message, frozen=True):
    """Show the blocks of a set in this project, which takes the set along: `BlocksShown`."""

    set: BlockSet


class ReadBlockSet(Message, frozen=True):
    """Ask for the set in a file's text: `BlockSetRead`."""

    filename: Name
    text: Text


class SaveBlockSet(Message, frozen=True):
    """Save a set in the user's folder.

    Args:
        set: under its name.
        replace: the user's own set of that name, if there is one; otherwise that is refused.
    """

    set: BlockSet
    replace: bool = False


class DeleteBlockSet(Message, frozen=True):
    """Delete a set from the user's folder; projects that took it along keep it."""

    name: Name


class ExportBlockSet(Message, frozen=True):
    """Ask for a set as a file: `File`."""

    set: BlockSet


# The server speaks.


class BlockSets(Message, frozen=True):
    """Every set one can choose.

    Args:
        ours: from the first lesson to everything.
        own: the user's.
        problems: of files in the user's folder that are no sets.
    """

    ours: tuple[BlockSet, ...]
    own: tuple[BlockSet, ...]
    problems: tuple[str, ...] = ()


class BlocksShown(Message, frozen=True):
    """Which blocks the project's palette shows, and the sets that the project takes along."""

    set: BlockSet
    carried: tuple[BlockSet, ...] = ()


class BlockSetRead(Message, frozen=True):
    """The set in a file, which is not saved yet."""

    set: BlockSet
