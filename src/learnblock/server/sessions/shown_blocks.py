"""Which blocks a project's palette shows."""

from dataclasses import dataclass

from learnblock.blocks import block_sets
from learnblock.blocks.block_sets import EVERYTHING, BlockSet
from learnblock.errors import UnknownNameError
from learnblock.server.messages import MOST_CARRIED, BlocksShown
from learnblock.server.projects.project_file import Project


@dataclass(frozen=True)
class ShownBlocks:
    """The set that is shown, and those that the project takes along.

    Whoever opens an exercise has its blocks, and finds them again after having shown others.

    Args:
        name: of the set that is shown: one of ours, or one that is carried.
        carried: sets that are not ours, the last chosen first.
    """

    name: str = EVERYTHING
    carried: tuple[BlockSet, ...] = ()

    @classmethod
    def of(cls, project: Project) -> "ShownBlocks":
        """What a project says.

        Raises:
            UnknownNameError: it shows a set that is neither ours nor its own.
        """
        found = cls(project.shown, project.block_sets)
        if found._find() is None:
            known = (*block_sets.BUILT_IN, *(one.name for one in found.carried))
            raise UnknownNameError("set of blocks", project.shown, known)
        return found

    @property
    def set(self) -> BlockSet:
        """The set that is shown."""
        found = self._find()
        assert found is not None  # noqa: S101 - `of` and `choosing` see to it
        return found

    def choosing(self, chosen: BlockSet) -> "ShownBlocks":
        """Another set; one that is not ours is carried from now on.

        Raises:
            BlockSetError: it has the name of one of ours, or none that a file can have.
        """
        if block_sets.built_in().get(chosen.name) == chosen:
            return ShownBlocks(chosen.name, self.carried)
        name = block_sets.checked_name(chosen.name)
        others = (one for one in self.carried if one.name != name)
        return ShownBlocks(name, (chosen, *others)[:MOST_CARRIED])

    def told(self) -> BlocksShown:
        """As pages are told."""
        return BlocksShown(self.set, self.carried)

    def _find(self) -> BlockSet | None:
        carried = {one.name: one for one in self.carried}
        return block_sets.built_in().get(self.name) or carried.get(self.name)
