"""The block sets of a project, and the one that its palette shows."""

from dataclasses import dataclass

from learnblock.blocks import block_sets
from learnblock.blocks.block_sets import EVERYTHING, BlockSet
from learnblock.errors import UnknownNameError
from learnblock.project.files.project import MOST_BLOCK_SETS, Project
from learnblock.server.messages import BlocksShown


@dataclass(frozen=True)
class ShownBlocks:
    """The block set that the palette shows, and the sets saved in the project.

    A project for an exercise contains its own sets, so that they are available on every computer.

    Args:
        name: the name of the shown set: a built-in one, or one of `carried`.
        carried: the sets saved in the project, the last chosen first.
    """

    name: str = EVERYTHING
    carried: tuple[BlockSet, ...] = ()

    @classmethod
    def of(cls, project: Project) -> "ShownBlocks":
        """Restore the choice of a project.

        Raises:
            UnknownNameError: the project names an unknown set.
        """
        shown = cls(project.shown, project.block_sets)
        if shown._find() is None:
            names = (*block_sets.BUILT_IN, *(block_set.name for block_set in shown.carried))
            raise UnknownNameError("block-set", project.shown, names)
        return shown

    @property
    def set(self) -> BlockSet:
        """The set that is shown."""
        block_set = self._find()
        assert block_set is not None  # noqa: S101 - `of` and `choosing` ensure it
        return block_set

    def choosing(self, chosen: BlockSet) -> "ShownBlocks":
        """Choose another set, and save it in the project unless it is built in.

        Raises:
            BlockSetError: the set has the name of a built-in one, or an unusable name.
        """
        if block_sets.built_in().get(chosen.name) == chosen:
            return ShownBlocks(chosen.name, self.carried)
        name = block_sets.checked_name(chosen.name)
        others = (block_set for block_set in self.carried if block_set.name != name)
        return ShownBlocks(name, (chosen, *others)[:MOST_BLOCK_SETS])

    def message(self) -> BlocksShown:
        """The message to pages."""
        return BlocksShown(self.set, self.carried)

    def _find(self) -> BlockSet | None:
        carried = {block_set.name: block_set for block_set in self.carried}
        return block_sets.built_in().get(self.name) or carried.get(self.name)
