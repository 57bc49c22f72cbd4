"""Find blocks that do nothing: loose stacks, empty blocks, and functions without a program."""

from collections.abc import Iterable, Iterator, Mapping, Sequence

from learnblock.blocks import BlockConfiguration
from learnblock.blocks.toolbox import SKILL
from learnblock.errors import Diagnostic
from learnblock.i18n import Phrase
from learnblock.language.workspace.block_reader import is_disabled
from learnblock.language.workspace.blocks import Block, Workspace
from learnblock.language.workspace.reader import is_part
from learnblock.language.workspace.types import (
    ANSWERING_FUNCTION,
    COMMENT,
    FOR_EACH,
    FOR_UNPACKING,
    FOREVER,
    FUNCTION,
    HATS,
    WHILE,
)
from learnblock.language.workspace.value_reader import VALUES

_FUNCTIONS = frozenset((FUNCTION, ANSWERING_FUNCTION))
#: The blocks that have no use without blocks inside them; a loop with a condition may wait for it.
_FRAMES = frozenset(("controls_if", "controls_repeat_ext", FOR_EACH, FOR_UNPACKING, "controls_for"))
#: The blocks that can have blocks inside.
_HOLDERS = HATS | _FRAMES | {WHILE, FOREVER}
#: As a statement, this block removes an item of a list instead of getting it.
_REMOVES = ("lists_getIndex", "REMOVE")


def idle_blocks(
    workspace: Workspace, configurations: Mapping[str, BlockConfiguration]
) -> Iterator[tuple[str, Diagnostic]]:
    """Yield a warning for each block that does nothing, with the id of the block."""
    hats = [stack[0] for stack in workspace.stacks if stack[0].type in HATS]
    for stack in workspace.stacks:
        if is_part(stack):
            yield from _empty(stack)
        elif not is_disabled(stack[0]):
            loose = _loose(stack, configurations, has_program=bool(hats))
            yield stack[0].id, _warning("loose-block", loose)
    if hats and all(hat.type in _FUNCTIONS for hat in hats):
        name = hats[0].fields.get("NAME")
        message = Phrase("workspace-only-functions", name=name if isinstance(name, str) else "")
        yield hats[0].id, _warning("never-called", message)


def _empty(stack: Iterable[Block]) -> Iterator[tuple[str, Diagnostic]]:
    ahead = list(stack)
    while ahead:
        block = ahead.pop()
        if block.type not in _HOLDERS or is_disabled(block):
            continue
        inside = [inner for plug in block.inputs.values() for inner in plug.stack]
        if not inside and block.type in _FRAMES:
            yield block.id, _warning("empty-block", Phrase("workspace-empty-block"))
        ahead += inside


def _loose(
    stack: Sequence[Block],
    configurations: Mapping[str, BlockConfiguration],
    *,
    has_program: bool,
) -> Phrase:
    if len(stack) == 1 and _is_value(stack[0], configurations):
        return Phrase("workspace-loose-value")
    code = "workspace-loose-blocks" if has_program else "workspace-no-program"
    return Phrase(code, count=sum(block.type != COMMENT for block in stack))


def _is_value(block: Block, configurations: Mapping[str, BlockConfiguration]) -> bool:
    if block.type.startswith(SKILL):
        skill = configurations.get(block.type.removeprefix(SKILL))
        return skill is not None and skill.returns_value
    return block.type in VALUES and (block.type, block.fields.get("MODE")) != _REMOVES


def _warning(code: str, message: Phrase) -> Diagnostic:
    return Diagnostic(code, message, severity="warning")
