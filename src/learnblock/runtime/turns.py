"""Turns of a loop, counted while they are alike, for the trace of a real robot.

A loop without waits asks its sensors some thousand times per second, and nearly always gets the
same answer. In a simulated world each access takes time, so there its turns are few.
"""

from collections.abc import Callable

Write = Callable[[float, str], object]

#: Longer turns are not compared with one another.
LONGEST_TURN = 200
#: Seconds after which a count is written even if the turns are still alike: of a program that is
#: killed, the trace lacks no more than that.
LONGEST_COUNT = 1.0
#: The most steps that are remembered while no turns are alike.
_MOST_STEPS = 20 * LONGEST_TURN


class CountedSteps:
    """Writes the steps of a program; of equal turns of a loop, and of a loop in it, only the count.

    A count is a line as well: so many lines before it happened so many more times, until its time.

    Args:
        write: called with the time of a line in s and its content, which is JSON without braces.
    """

    def __init__(self, write: Write) -> None:
        self._outer = _Turns(write)
        self._inner = _Turns(self._outer.step)

    def step(self, time: float, text: str) -> None:
        """Take the next step of the program.

        Args:
            time: its time in s.
            text: what is to be written about it.
        """
        self._inner.step(time, text)

    def end(self) -> None:
        """Write what is still counted, because something else has happened."""
        self._inner.end()
        self._outer.end()


class _Turns:
    """Counts the turns of one loop at a time."""

    def __init__(self, write: Write) -> None:
        self._write = write
        #: What has been written since the last count, or since something else has happened.
        self._steps: list[str] = []
        #: By step, where in `_steps` it was last.
        self._places: dict[str, int] = {}
        #: The turn that is being repeated; empty while there is none.
        self._turn: list[str] = []
        #: The steps of the present turn, with their times, which may yet become another one.
        self._begun: list[tuple[float, str]] = []
        self._times = 0
        self._since = self._until = 0.0

    def step(self, time: float, text: str) -> None:
        while self._turn and text != self._turn[len(self._begun)]:
            # The steps of the turn that has begun may themselves be turns of another loop.
            self._stop_counting()
        if self._turn:
            self._repeat(time, text)
        else:
            self._add(time, text)

    def end(self) -> None:
        while self._turn:
            self._stop_counting()
        self._forget()

    def _stop_counting(self) -> None:
        if self._times:
            self._write(self._until, f'"repeated":{len(self._turn)},"times":{self._times}')
            self._forget()
        begun, self._begun = self._begun, []
        self._turn, self._times = [], 0
        for time, text in begun:
            self.step(time, text)

    def _repeat(self, time: float, text: str) -> None:
        self._begun.append((time, text))
        if len(self._begun) == len(self._turn):
            self._begun.clear()
            self._times += 1
            self._until = time
            if time - self._since >= LONGEST_COUNT:
                self._stop_counting()

    def _add(self, time: float, text: str) -> None:
        self._write(time, text)
        if len(self._steps) >= _MOST_STEPS:
            self._forget()
        steps, now = self._steps, len(self._steps)
        length = now - self._places.get(text, now)
        steps.append(text)
        self._places[text] = now
        if 0 < length <= LONGEST_TURN and steps[-length:] == steps[-2 * length : -length]:
            self._turn = steps[-length:]
            self._since = time

    def _forget(self) -> None:
        self._steps.clear()
        self._places.clear()
