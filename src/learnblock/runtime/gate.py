"""The program's side of the debugger: it decides at each line whether the program pauses."""

from collections.abc import Callable
from threading import get_ident
from time import monotonic

from learnblock.runtime.lines import depth
from learnblock.runtime.messages import Mode
from learnblock.runtime.statements import OnLine
from learnblock.runtime.turn import Turn
from learnblock.runtime.wire import Wire

#: Seconds of the wall clock between two polls for messages from the host: the longest delay until
#: a busy program pauses.
LISTENING_PERIOD = 0.01


class Gate:
    """Lets a program continue at a line, or pauses it there.

    Breakpoints and steps are decided here: asking the host at every line would make a program many
    times slower.

    Args:
        wire: the link to the host, which has the breakpoints.
        filename: the file name of the program.
    """

    def __init__(self, wire: Wire, filename: str) -> None:
        self._wire = wire
        self._filename = filename
        self._listened = monotonic()
        #: Called with each line before the program may pause; does nothing without a robot.
        self.on_line: OnLine = bool
        #: Called before the program pauses: what it has noted must be known by then.
        self.before_pause: Callable[[], object] = bool

    def __call__(self, number: int) -> None:
        if monotonic() - self._listened > LISTENING_PERIOD:
            self._wire.listen()
            self._listened = monotonic()
        self.on_line(number)
        control = self._wire.control
        if control.mode is not Mode.RUN or number in control.breakpoints:
            self._hold(number, depth(self._filename))

    def _hold(self, number: int, depth: int) -> None:
        if self._wire.control.holds(number, depth):
            self.before_pause()
            self._wire.hold(number, depth)


def unless_shown(turn: Turn, on_line: OnLine) -> Callable[[int], None]:
    """`on_line`, except for lines that run only to describe a variable."""

    def line(number: int) -> None:
        if turn.forbidden_to is None or turn.forbidden_to != get_ident():
            on_line(number)

    return line
