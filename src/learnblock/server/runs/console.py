"""The output of programs for the page."""

import threading
from collections import Counter
from collections.abc import Sequence
from itertools import groupby

from learnblock.server import messages
from learnblock.server.messages import PrintedPart

#: The maximum number of characters sent at once and kept for a page that opens later.
MOST_AT_ONCE = 20_000
MOST_KEPT = 100_000


class Console:
    """The output of the robots that run one program, in the order in which they print.

    It collects the output in the threads of the programs, and hands it out in portions.
    """

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._new: list[PrintedPart] = []
        self._kept: list[PrintedPart] = []
        #: The number of characters that each robot has printed.
        self._printed: Counter[str] = Counter()

    @property
    def kept(self) -> Sequence[PrintedPart]:
        """The end of the output returned so far."""
        return tuple(self._kept)

    def printed(self, text: str, robot: str = "") -> None:
        """Add output of a program; may be called from any thread.

        Args:
            text: the output.
            robot: the name of its robot; empty if no other runs the same program.
        """
        with self._lock:
            # Each print counts as a line, as in the log of the run.
            self._printed[robot] += len(text.removesuffix("\n")) + 1
            self._new.append(PrintedPart(robot, text, self._printed[robot]))

    def take(self) -> Sequence[PrintedPart]:
        """The output since the last call, or only its end if there is too much."""
        with self._lock:
            new, self._new = self._new, []
        shown = _shortened(_joined(new))
        self._kept = _joined(_end([*self._kept, *shown], MOST_KEPT))
        return shown

    def clear(self) -> None:
        """Forget all output, as at the beginning of a run."""
        with self._lock:
            self._new, self._kept = [], []
            self._printed.clear()


class Voice:
    """What one robot prints on the console of its program.

    Args:
        console: the console.
        robot: the name of the robot; empty if no other runs the same program.
    """

    def __init__(self, console: Console, robot: str = "") -> None:
        self.robot = robot
        self._console = console

    def printed(self, text: str) -> None:
        """Add output of the program; may be called from any thread."""
        self._console.printed(text, self.robot)


def message_of(parts: Sequence[PrintedPart]) -> messages.ToPage | None:
    """The message about some output; None if there is none."""
    if not parts:
        return None
    if any(part.robot for part in parts):
        return messages.PrintedByRobots(tuple(parts))
    return messages.Printed("".join(part.text for part in parts), parts[-1].until)


def _joined(parts: Sequence[PrintedPart]) -> list[PrintedPart]:
    """The same output, with what one robot printed in one go as one part."""
    runs = ((robot, list(run)) for robot, run in groupby(parts, lambda part: part.robot))
    return [
        PrintedPart(robot, "".join(part.text for part in run), run[-1].until) for robot, run in runs
    ]


def _shortened(parts: Sequence[PrintedPart]) -> Sequence[PrintedPart]:
    left_out = sum(len(part.text) for part in parts) - MOST_AT_ONCE
    if left_out <= 0:
        return parts
    first, *rest = _end(parts, MOST_AT_ONCE)
    note = f"[{left_out} characters left out]\n"
    return [PrintedPart(first.robot, note + first.text, first.until), *rest]


def _end(parts: Sequence[PrintedPart], most: int) -> Sequence[PrintedPart]:
    """The last characters of some output."""
    end: list[PrintedPart] = []
    for part in reversed(parts):
        text = part.text[-most:] if most > 0 else ""
        if not text:
            break
        end.append(PrintedPart(part.robot, text, part.until))
        most -= len(text)
    return end[::-1]
