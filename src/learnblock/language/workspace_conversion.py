"""Between programs and workspaces, both ways without loss."""

from collections.abc import Mapping
from dataclasses import dataclass

from learnblock.blocks.configuration import BlockConfiguration
from learnblock.errors import Diagnostic
from learnblock.language.nodes import Program
from learnblock.language.workspace import Workspace
from learnblock.language.workspace_reader import read
from learnblock.language.workspace_survey import distinct, survey
from learnblock.language.workspace_writer import WorkspaceWriter


@dataclass(frozen=True, slots=True)
class WorkspaceText:
    """A program as blocks.

    Args:
        workspace: the blocks. Those of the workspace before are shared: change none in place.
        block_ids: the block of each statement, part of an ``if``, definition and expression, by
            the node's `id()`.
    """

    workspace: Workspace
    block_ids: Mapping[int, str]


@dataclass(frozen=True, slots=True)
class WorkspaceProgram:
    """What a workspace says.

    Args:
        program: sensible even where blocks are missing.
        block_ids: as of `WorkspaceText`.
        problems: what is wrong, each with the id of its block.
    """

    program: Program
    block_ids: Mapping[int, str]
    problems: tuple[tuple[str, Diagnostic], ...]


def to_workspace(
    program: Program,
    configurations: Mapping[str, BlockConfiguration],
    previous: Workspace | None = None,
) -> WorkspaceText:
    """A program as blocks.

    Args:
        program: the tree.
        configurations: of the skills that have blocks, by name.
        previous: the workspace before an edit. Every block that is still there stays as it was:
            its id, its place, folded or not, the bubble of its comment; so do blocks that are no
            part of the program, or have been disabled, and inputs that are still empty.

    Raises:
        ProgramError: the blocks of `previous` are too many inside each other.
    """
    before = Workspace() if previous is None else previous
    in_use = survey(before)
    if in_use.repeated:
        before = distinct(before)
        in_use = survey(before)
    reader = read(before, configurations)
    writer = WorkspaceWriter(program, configurations, reader, before, in_use)
    return WorkspaceText(writer.workspace, writer.ids)


def from_workspace(
    workspace: Workspace, configurations: Mapping[str, BlockConfiguration]
) -> WorkspaceProgram:
    """What a workspace says: a program, and what is wrong with its blocks.

    Stacks under no hat and disabled blocks are no part of the program. Where a value is missing
    another stands in the program, and a statement that cannot be read is left out.

    Raises:
        ProgramError: the blocks are too many inside each other.
    """
    reader = read(workspace, configurations)
    return WorkspaceProgram(reader.program, reader.ids, tuple(reader.problems))
