"""A program without syntax errors, in all three notations."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property

from learnblock.blocks import BlockConfiguration
from learnblock.blocks.importable import Importable
from learnblock.language import format as format_program
from learnblock.language import from_python, to_python, to_workspace
from learnblock.language.blocktext.format import format_with_extents
from learnblock.language.python.generation import DEFAULT_ROBOT
from learnblock.language.python.robot_import import with_robot
from learnblock.language.tree.extents import Extent, every, extents
from learnblock.language.tree.nodes import Program, Raw
from learnblock.language.workspace.blocks import Workspace
from learnblock.wheels import Drivetrain


@dataclass(frozen=True)
class Target:
    """The robot and skills that a program is written for.

    Args:
        robot_module: the module from which its Python imports the robot.
        configurations: the known skills, by name.
        equipment: what the robot has, see `learnblock.senses.equipment`; None if unknown.
        drivetrain: what its wheels can do; None if unknown.
    """

    robot_module: str
    configurations: Mapping[str, BlockConfiguration] = field(default_factory=dict)
    equipment: frozenset[str] | None = None
    drivetrain: Drivetrain | None = None

    @cached_property
    def importable(self) -> Importable:
        """The known libraries; a project has no other files."""
        libraries = (configuration.library for configuration in self.configurations.values())
        return Importable(frozenset(filter(None, libraries)))


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
class Blocks:
    """A program as blocks.

    Args:
        workspace: the blocks.
        ids: the block of each node of the program's tree, by its identity.
    """

    workspace: Workspace
    ids: Mapping[int, str]


@dataclass(frozen=True)
class Notations:
    """One program in three notations.

    Args:
        tree: the program itself.
        blocks: the program as blocks.
        blocktext: the program in Block-Text.
        python: the program in Python.
    """

    tree: Program
    blocks: Blocks
    blocktext: Written
    python: Written

    @property
    def by_hand(self) -> bool:
        """Whether the Python differs from the generated one; it is run and saved unchanged."""
        return self.python.tree is not None and self.python.tree.python is not None

    @cached_property
    def canonical(self) -> str:
        """The program in the canonical form of Block-Text, by which blocks are merged."""
        is_generated = self.blocktext.tree is None
        return self.blocktext.text if is_generated else format_program(self.tree)

    def statement_blocks(self) -> list[str | None]:
        """The block of `every` statement."""
        return [self.blocks.ids.get(id(node)) for node in every(self.tree)]


def derive(
    tree: Program,
    target: Target,
    before: Notations | None = None,
    *,
    blocks: Blocks | None = None,
    blocktext: Written | None = None,
    python: Written | None = None,
    layout: Workspace | None = None,
) -> Notations:
    """The notations of a program that was read from some of its views; the others follow.

    Args:
        tree: the program; if `blocks` are given, theirs.
        target: the robot and skills that it is for.
        before: the notations before; if they are of the same program, they stay as their author
            wrote them.
        blocks: the program as blocks, if it was read from them.
        blocktext: the program in Block-Text, if it was read from that.
        python: the program in Python, if it was read from that.
        layout: the blocks next to which new ones are laid out; those of `before` by default.
    """
    if before is not None and before.tree == tree:
        return Notations(
            before.tree if blocks is None else tree,
            blocks or before.blocks,
            blocktext or before.blocktext,
            python or before.python,
        )
    if before is not None and layout is None:
        layout = before.blocks.workspace
    return Notations(
        tree,
        blocks or _blocks(tree, target, layout),
        blocktext or _blocktext(tree),
        python or _python(tree, target),
    )


def for_robot(notations: Notations, module: str) -> Notations:
    """The same program for another robot."""
    if is_raw(notations.tree):
        return notations
    python = replace(notations.python, text=with_robot(notations.python.text, module))
    return replace(notations, python=python)


def read_python(text: str) -> Program:
    """The tree of a program in Python; its `python` is None if we would generate the same.

    Raises:
        ProgramError: it is not valid Python.
    """
    # The imported robot does not make a program differ from the generated one.
    return from_python(with_robot(text, DEFAULT_ROBOT))


def is_raw(tree: Program) -> bool:
    """Whether a program is one block of raw Python, which creates its own robot, if any."""
    return len(tree.items) == 1 and tree.main is None and isinstance(tree.items[0], Raw)


def _blocks(tree: Program, target: Target, layout: Workspace | None) -> Blocks:
    program = to_workspace(tree, target.configurations, layout)
    return Blocks(program.workspace, program.block_ids)


def _blocktext(tree: Program) -> Written:
    text, node_extents = format_with_extents(tree)
    return Written(text, extents(tree, node_extents))


def _python(tree: Program, target: Target) -> Written:
    python = to_python(replace(tree, python=None), target.robot_module)
    return Written(python.text, extents(tree, python.extents))
