"""Convert programs to workspaces and back, both ways without loss."""

from collections.abc import Mapping
from dataclasses import dataclass

from learnblock.blocks import BlockConfiguration
from learnblock.errors import Diagnostic
from learnblock.language.tree.nodes import Program
from learnblock.language.workspace.blocks import Workspace
from learnblock.language.workspace.own_variables import without_locals
from learnblock.language.workspace.reader import read
from learnblock.language.workspace.survey import distinct, survey
from learnblock.language.workspace.writer import WorkspaceWriter


@dataclass(frozen=True, slots=True)
class WorkspaceText:
    """A program as blocks.

    Args:
        workspace: the blocks. It shares some with the earlier workspace: do not change them.
        block_ids: the block of each statement, branch of an ``if``, definition and expression,
            by the `id()` of the node.
    """

    workspace: Workspace
    block_ids: Mapping[int, str]


@dataclass(frozen=True, slots=True)
class WorkspaceProgram:
    """The program in a workspace.

    Args:
        program: the program, valid even if blocks are missing.
        block_ids: as in `WorkspaceText`.
        problems: the diagnostics, each with the id of its block.
    """

    program: Program
    block_ids: Mapping[int, str]
    problems: tuple[tuple[str, Diagnostic], ...]


def to_workspace(
    program: Program,
    configurations: Mapping[str, BlockConfiguration],
    previous: Workspace | None = None,
) -> WorkspaceText:
    """Convert a program to blocks.

    Args:
        program: the tree.
        configurations: the configurations of the skills that have blocks, by name.
        previous: the workspace before an edit. Remaining blocks keep their id, position, appearance
            and comment bubble; blocks outside the program, disabled blocks and empty inputs
            remain too.

    Raises:
        ProgramError: the blocks of `previous` are nested too deeply.
    """
    before = Workspace() if previous is None else previous
    in_use = survey(before)
    if in_use.repeated:
        before = distinct(before)
        in_use = survey(before)
    reader = read(before, configurations)
    writer = WorkspaceWriter(program, configurations, reader, before, in_use)
    return WorkspaceText(without_locals(writer.workspace), writer.ids)


def from_workspace(
    workspace: Workspace, configurations: Mapping[str, BlockConfiguration]
) -> WorkspaceProgram:
    """Read the program in a workspace, and the problems of its blocks.

    Stacks without a hat block and disabled blocks are not part of the program. Missing values are
    replaced, and statements that cannot be read are left out.

    Raises:
        ProgramError: the blocks are nested too deeply.
    """
    reader = read(workspace, configurations)
    return WorkspaceProgram(reader.program, reader.ids, tuple(reader.problems))
