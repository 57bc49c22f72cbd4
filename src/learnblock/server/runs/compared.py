"""Compares two kept runs: where they parted, and what called what in them."""

from typing import TYPE_CHECKING

from learnblock.server import messages
from learnblock.server.runs.looking import call_graph, way

if TYPE_CHECKING:
    from learnblock.why import History
    from learnblock.why.sentences import Sentence


def compared(first: tuple[str, bytes], second: tuple[str, bytes]) -> messages.RunsCompared:
    """Compare two kept runs.

    Args:
        first: the id of the one, and its file.
        second: those of the other.

    Raises:
        LearnBlockError: a file can't be read.
    """
    from learnblock.why.comparing import compared as compare  # noqa: PLC0415 - the page opens before
    from learnblock.why.verifying import history_of  # noqa: PLC0415

    one, other = (history_of(data) for _, data in (first, second))
    found = compare(one, other)
    parting = found.parting
    return messages.RunsCompared(
        _run(first[0], one, parting.first if parting else None),
        _run(second[0], other, parting.second if parting else None),
        parting.together if parting else None,
        parting.because if parting else None,
        found.causes,
    )


def calls_beside(first: bytes, second: bytes) -> messages.CallsBeside:
    """The call graphs of two kept runs.

    Args:
        first: the file of the one.
        second: that of the other.

    Raises:
        LearnBlockError: a file can't be read.
    """
    from learnblock.why.calls import calls  # noqa: PLC0415 - the page opens before
    from learnblock.why.calls_beside import beside  # noqa: PLC0415
    from learnblock.why.verifying import history_of  # noqa: PLC0415

    both = beside(*(calls(history_of(data)) for data in (first, second)))
    return messages.CallsBeside(call_graph(both.first), call_graph(both.second))


def _run(id_: str, history: "History", did: "Sentence | None") -> messages.ComparedRun:
    step = messages.RunStep(did.phrase, did.time) if did else None
    return messages.ComparedRun(id_, way(history.recorded), step)
