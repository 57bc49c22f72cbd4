"""Opens a kept run, so that pages can look back at it, and compares two of them."""

from collections.abc import Sequence
from dataclasses import dataclass
from difflib import SequenceMatcher
from typing import TYPE_CHECKING

from learnblock.i18n import Phrase
from learnblock.project.document.document import Document
from learnblock.project.files.kept_runs import KeptRun
from learnblock.server import messages
from learnblock.server.runs import telemetry
from learnblock.server.runs.console import MOST_KEPT
from learnblock.server.runs.looking import Looking, call_graph, way

if TYPE_CHECKING:
    from learnblock.why import EventHistory
    from learnblock.why.recorded import Recorded
    from learnblock.why.sentences import Sentence

#: Of longer programs, only lines that have not moved have their blocks.
_MOST_LINES = 10_000


@dataclass(frozen=True)
class OpenedRun:
    """A kept run that is shown.

    Args:
        looking: looks back at it.
        shown: what pages show about it.
        scene: its world; None if that can't be shown.
    """

    looking: Looking
    shown: messages.RunShown
    scene: messages.Scene | None


def opened(run: KeptRun, data: bytes, now: Document) -> OpenedRun:
    """Open a kept run.

    Args:
        run: what is known about it.
        data: its file.
        now: the program as it is now.

    Raises:
        LearnBlockError: the file can't be read.
    """
    from learnblock.why.verification import verified  # noqa: PLC0415 - the page opens before

    log = verified(data)
    then, today = log.recorded.program, now.program(run.program)
    blocks = [now.block_at(line) for line in lines_now(then.python, today.python)]
    shown = messages.RunShown(
        run,
        then.identity != today.identity,
        _remarks(run, log.recorded, has_world=log.has_world),
        printed(log.recorded),
    )
    return OpenedRun(Looking(log, blocks), shown, scene_of(log.recorded) if log.has_world else None)


def lines_now(then: str, now: str) -> Sequence[int]:
    """For each line of a program, where that line is now; 0 if it is gone."""
    old, new = then.split("\n"), now.split("\n")
    lines = [0] * len(old)
    if max(len(old), len(new)) > _MOST_LINES:
        pairs = enumerate(zip(old, new, strict=False))
        return [number + 1 if before == after else 0 for number, (before, after) in pairs]
    for at, there, count in SequenceMatcher(None, old, new).get_matching_blocks():
        lines[at : at + count] = range(there + 1, there + 1 + count)
    return lines


def printed(recorded: "Recorded") -> str:
    """The output of the program, or its end."""
    lines = [f"{line['print']}\n" for line in recorded.lines if "print" in line]
    return "".join(lines)[-MOST_KEPT:]


def _remarks(run: KeptRun, recorded: "Recorded", *, has_world: bool) -> tuple[Phrase, ...]:
    if has_world:
        return ()
    if "world" in recorded.robot:
        return (Phrase("kept-world-missing", world=run.world, robot=run.robot),)
    return (Phrase("kept-real-robot", robot=run.robot),)


def scene_of(recorded: "Recorded") -> messages.Scene:
    """The world of a run."""
    from learnblock.monitor.world_monitor import WorldMonitor  # noqa: PLC0415 - slow to load
    from learnblock.why.world_again import WorldAgain  # noqa: PLC0415

    return telemetry.scene(WorldMonitor.of(WorldAgain(recorded).robot))


def compared(first: tuple[str, bytes], second: tuple[str, bytes]) -> messages.RunsCompared:
    """Compare two kept runs.

    Args:
        first: the id of the first run, and its file.
        second: those of the second run.

    Raises:
        LearnBlockError: a file can't be read.
    """
    from learnblock.why.comparison import compared as compare  # noqa: PLC0415 - the page opens before
    from learnblock.why.verification import history_of  # noqa: PLC0415

    first_history, second_history = (history_of(data) for _, data in (first, second))
    comparison = compare(first_history, second_history)
    parting = comparison.parting
    return messages.RunsCompared(
        _run(first[0], first_history, parting.first if parting else None),
        _run(second[0], second_history, parting.second if parting else None),
        parting.together if parting else None,
        parting.because if parting else None,
        comparison.causes,
    )


def calls_beside(first: bytes, second: bytes) -> messages.CallsBeside:
    """The call graphs of two kept runs.

    Args:
        first: the file of the first run.
        second: that of the second run.

    Raises:
        LearnBlockError: a file can't be read.
    """
    from learnblock.why.calls import calls  # noqa: PLC0415 - the page opens before
    from learnblock.why.calls_beside import beside  # noqa: PLC0415
    from learnblock.why.verification import history_of  # noqa: PLC0415

    both = beside(*(calls(history_of(data)) for data in (first, second)))
    return messages.CallsBeside(call_graph(both.first), call_graph(both.second))


def _run(id_: str, history: "EventHistory", did: "Sentence | None") -> messages.ComparedRun:
    step = messages.RunStep(did.phrase, did.time) if did else None
    return messages.ComparedRun(id_, way(history.recorded), step)
