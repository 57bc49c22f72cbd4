"""The timeline of a run in progress, read from its log bit by bit."""

from collections.abc import Iterable, Sequence
from typing import Any

from learnblock.runtime.log.blocks import EventBlock, EventStream
from learnblock.runtime.log.noting import TICK
from learnblock.server import messages
from learnblock.server.messages.looking import MOST_MARKS

#: The most points of the way in each message; at the end of the run there are more.
MOST_POINTS = 500


class LiveTimeline:
    """What a log says about a run, without the actions of its program.

    Reading all of it again for each look would take seconds for a run of ten minutes.
    """

    def __init__(self) -> None:
        self._seen = 0
        self._end = 0.0
        self._is_simulated = False
        self._marks: list[messages.TimeMark] = []
        self._way: list[tuple[float, float, float]] = []

    def read(self, blocks: Sequence[EventBlock]) -> messages.Timeline:
        """The run so far.

        Args:
            blocks: all blocks of the log, those of the last time first.
        """
        from learnblock.why.recorded import lines_in  # noqa: PLC0415 - the page opens before it is needed

        world = [block for block in blocks if block.stream is EventStream.WORLD]
        self._take(lines_in([block.data for block in world[self._seen :]]))
        self._seen = len(world)
        self._end = max([self._end, *(block.last * TICK for block in blocks)])
        return messages.Timeline(
            round(self._end, 2),
            self._is_simulated,
            marks=tuple(self._marks[-MOST_MARKS:]),
            way=tuple(self._way[:: 1 + len(self._way) // MOST_POINTS]),
        )

    def _take(self, lines: Iterable[dict[str, Any]]) -> None:
        from learnblock.why.moments import marks_in  # noqa: PLC0415 - as above

        for line in lines:
            self._end = max(self._end, line.get("t", 0.0))
            self._is_simulated |= "world" in line.get("robot", ())
            if "pose" in line:
                self._way.append((line["t"], *line["pose"][:2]))
            self._marks.extend(
                messages.TimeMark(mark.time, mark.kind, mark.text)  # type: ignore[arg-type] # the same kinds
                for mark in marks_in([line])
            )
