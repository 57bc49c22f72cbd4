"""Messages about the blocks that the palette shows."""

from learnblock.blocks.block_sets import BlockSet
from learnblock.i18n import Phrase
from learnblock.server.messages.base import FromReader, Look, Name, Own, Text, ToPage, Write

# From the page.


class ListBlockSets(Look, frozen=True):
    """Ask for `BlockSets`."""


class ChooseBlockSet(Write, FromReader, frozen=True):
    """Show the blocks of a set, and save the set in the project; the reply is `BlocksShown`."""

    set: BlockSet


class ReadBlockSet(Look, frozen=True):
    """Ask for the set in a file's text; the reply is `BlockSetRead`."""

    filename: Name
    text: Text


class SaveBlockSet(Own, frozen=True):
    """Save a set in the user's folder.

    Args:
        set: saved under its name.
        replace: whether to replace the user's set with that name; otherwise `Failed`.
    """

    set: BlockSet
    replace: bool = False


class DeleteBlockSet(Own, frozen=True):
    """Delete a set from the user's folder; projects that contain it keep it."""

    name: Name


class ExportBlockSet(Look, frozen=True):
    """Ask for a set as a file; the reply is `File`."""

    set: BlockSet


# To the page.


class BlockSets(ToPage, frozen=True):
    """The block sets to choose from.

    Args:
        ours: the built-in sets, from the first steps to all blocks.
        own: the user's sets.
        problems: the errors in files of the user's folder.
    """

    ours: tuple[BlockSet, ...]
    own: tuple[BlockSet, ...]
    problems: tuple[Phrase, ...] = ()


class BlocksShown(ToPage, frozen=True):
    """The block set that the palette shows, and the sets saved in the project."""

    set: BlockSet
    carried: tuple[BlockSet, ...] = ()


class BlockSetRead(ToPage, frozen=True):
    """The block set in a file, which is not saved yet."""

    set: BlockSet
