"""The moving picture in the help of a block: its example's blocks, its world, and what happened."""

from collections.abc import Iterable, Iterator
from functools import lru_cache

import msgspec

from learnblock.blocks.schema.loading import builtin
from learnblock.language.workspace.blocks import Workspace
from learnblock.monitor.worlds import world_values
from learnblock.project.document.document import Document
from learnblock.project.document.views import Place
from learnblock.project.help.examples import example_name, examples
from learnblock.project.help.recordings import HelpRecording, Noticed, Waypoint, recordings
from learnblock.robots import module_of
from learnblock.simulator import load_world

#: The kind of an event in which a line ran; its text becomes the line's block.
_LINE = "line"


class BlockHelp(msgspec.Struct, frozen=True, kw_only=True):
    """An example that ran: its blocks, its world from above and what happened.

    Args:
        program: its Block-Text.
        robot: the simulated robot that it ran on.
        world: the values of its world's file.
        workspace: its blocks.
        way: where the robot was; between two places it went evenly.
        events: what happened, in order; a line as the id of its block, "" if it has none.
    """

    program: str
    robot: str
    world: dict[str, object]
    workspace: Workspace
    way: tuple[Waypoint, ...]
    events: tuple[Noticed, ...]


def moving_picture(block: str) -> bytes | None:
    """The picture of a block as JSON; None for one without an example, such as a custom block.

    Args:
        block: its name in block sets, such as ``controls_if:else`` or ``function.turn``.
    """
    name = example_name(block)
    return _of_example(name) if name in recordings() else None


@lru_cache(maxsize=64)
def _of_example(name: str) -> bytes:
    recording = recordings()[name]
    document = Document.from_text(recording.program, module_of(recording.robot), builtin())
    return msgspec.json.encode(
        BlockHelp(
            program=recording.program,
            robot=recording.robot,
            world=world_values(load_world(examples()[name].world_file)),
            workspace=document.workspace,
            way=recording.way,
            events=tuple(_with_blocks(recording, document.places)),
        )
    )


def _with_blocks(recording: HelpRecording, places: Iterable[Place]) -> Iterator[Noticed]:
    """The events, with the id of the block in place of a line."""
    blocks = {str(place.blocktext): place.block for place in places}
    for event in recording.events:
        is_line = event.kind == _LINE
        yield event._replace(text=blocks.get(event.text, "")) if is_line else event
