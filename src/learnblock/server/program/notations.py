"""A program without syntax errors, in all three notations."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property

from learnblock.blocks import BlockConfiguration
from learnblock.blocks.importable import Importable
from learnblock.language import from_python, to_python, to_workspace
from learnblock.language.blocktext.format import format_with_extents
from learnblock.language.python.generation import DEFAULT_ROBOT, ROBOT_IMPORT
from learnblock.language.tree.extents import Extent, every, extents
from learnblock.language.tree.nodes import Program, Raw
from learnblock.language.workspace.blocks import Workspace


@dataclass(frozen=True)
class Target:
    """The robot and skills that a program is written for.

    Args:
        robot_module: the module from which its Python imports the robot.
        configurations: the known skills, by name.
        equipment: what the robot has, see `learnblock.senses.equipment`; None if unknown.
    """

    robot_module: str
    configurations: Mapping[str, BlockConfiguration] = field(default_factory=dict)
    equipment: frozenset[str] | None = None

    @cached_property
    def importable(self) -> Importable:
        """The known libraries; a project has no other files."""
        found = (one.library for one in self.configurations.values())
        return Importable(frozenset(filter(None, found)))


@dataclass(frozen=True)
class Written:
    """A program in one of the two text notations.

    Args:
        text: the text as shown.
        extents: the lines of every statement (see `every`).
        tree: a tree with spans in the text if its author wrote it; None if it is generated.
    """

    text: str
    extents: tuple[Extent, ...]
    tree: Program | None = None

    @classmethod
    def by_author(cls, text: str, tree: Program) -> "Written":
        return cls(text, extents(tree), tree)


@dataclass(frozen=True)
class Notations:
    """One program in three notations.

    Args:
        tree: the program itself.
        block_ids: the block of each node of `tree`, by its identity.
        workspace: the blocks.
        blocktext: the program in Block-Text.
        python: the program in Python.
        by_hand: whether the Python differs from the generated one; it is run and saved unchanged.
    """

    tree: Program
    block_ids: Mapping[int, str]
    workspace: Workspace
    blocktext: Written
    python: Written
    by_hand: bool = False

    @classmethod
    def of_blocktext(
        cls, tree: Program, text: str, target: Target, before: Workspace | None
    ) -> "Notations":
        """The notations of a program written in Block-Text."""
        block_ids, workspace = _blocks(tree, target, before)
        blocktext = Written.by_author(text, tree)
        return cls(tree, block_ids, workspace, blocktext, _python(tree, target))

    @classmethod
    def of_python(
        cls, tree: Program, text: str, target: Target, before: Workspace | None
    ) -> "Notations":
        """The notations of a program written in Python; `tree` is from `read_python`."""
        block_ids, workspace = _blocks(tree, target, before)
        python = Written.by_author(text, tree)
        blocktext = _blocktext(tree)
        return cls(tree, block_ids, workspace, blocktext, python, tree.python is not None)

    @classmethod
    def of_blocks(
        cls, tree: Program, block_ids: Mapping[int, str], workspace: Workspace, target: Target
    ) -> "Notations":
        """The notations of a program built from blocks."""
        return cls(tree, block_ids, workspace, _blocktext(tree), _python(tree, target))

    # Edits that do not change the program leave the other notations as their author wrote them.

    def with_blocktext(self, tree: Program, text: str) -> "Notations":
        """The same program, written differently in Block-Text."""
        return replace(self, blocktext=Written.by_author(text, tree))

    def with_python(self, tree: Program, text: str) -> "Notations":
        """The same program, written differently in Python."""
        by_hand = tree.python is not None
        return replace(self, python=Written.by_author(text, tree), by_hand=by_hand)

    def with_blocks(
        self, tree: Program, block_ids: Mapping[int, str], workspace: Workspace
    ) -> "Notations":
        """The same program, laid out differently as blocks."""
        return replace(self, tree=tree, block_ids=block_ids, workspace=workspace)

    def for_robot(self, module: str) -> "Notations":
        """The same program for another robot."""
        if is_raw(self.tree):
            return self
        return replace(self, python=replace(self.python, text=with_robot(self.python.text, module)))

    def blocks(self) -> list[str | None]:
        """The block of `every` statement."""
        return [self.block_ids.get(id(node)) for node in every(self.tree)]


def read_python(text: str) -> Program:
    """The tree of a program in Python; its `python` is None if we would generate the same.

    Raises:
        ProgramError: it is not valid Python.
    """
    # The imported robot does not make a program differ from the generated one.
    return from_python(with_robot(text, DEFAULT_ROBOT))


def with_robot(python: str, module: str) -> str:
    """Python that imports its robot from `module`."""
    return ROBOT_IMPORT.sub(lambda match: match[0].replace(match[1], module, 1), python, count=1)


def is_raw(tree: Program) -> bool:
    """Whether a program is one block of raw Python, which creates its own robot, if any."""
    return len(tree.items) == 1 and tree.main is None and isinstance(tree.items[0], Raw)


def _blocks(
    tree: Program, target: Target, before: Workspace | None
) -> tuple[Mapping[int, str], Workspace]:
    made = to_workspace(tree, target.configurations, before)
    return made.block_ids, made.workspace


def _blocktext(tree: Program) -> Written:
    text, written = format_with_extents(tree)
    return Written(text, extents(tree, written))


def _python(tree: Program, target: Target) -> Written:
    made = to_python(replace(tree, python=None), target.robot_module)
    return Written(made.text, extents(tree, made.extents))
