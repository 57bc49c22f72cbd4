"""The lines of a trace, kept so that a loop which asks a sensor all the time costs little."""

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from typing import Any, overload

import msgspec

Line = Mapping[str, Any]

_LARGEST_NUMBER = 1e9
#: Before the time of a line, as a recorder writes it.
_BEFORE_TIME = b'{"t":'
#: How the rest of a line begins that is about a step of the program.
_STEPS = (b'"line":', b'"call":')
#: The longest step that is kept once for all its lines, in bytes, and the most of them.
_LONGEST_STEP, _MOST_STEPS = 200, 10_000


class TraceLines(Sequence[Line]):
    """Lines in order, each as its time and what it is about.

    Most lines of a trace are steps of the program, and most of these say the same at many times:
    they are decoded once. A line without a time has None.

    Args:
        lines: the first lines.
    """

    def __init__(self, lines: Iterable[Line] = ()) -> None:
        self._times: list[float | None] = []
        self._abouts: list[Line] = []
        #: What steps are about, by its bytes; of a recorder in this process, by its identity.
        self._steps: dict[bytes | int, Line] = {}
        #: The numbers of the lines that are not among `_steps`.
        self._others: list[int] = []
        self._decoder = msgspec.json.Decoder()
        for line in lines:
            self.keep(line)

    def keep(self, line: Line, /) -> None:
        """Add a line; see `LineSink`."""
        time = line.get("t")
        if _is_time(time):
            line = {key: value for key, value in line.items() if key != "t"}
        # The number comes last: see `with_more`.
        self._times.append(time if _is_time(time) else None)
        self._abouts.append(line)
        self._others.append(len(self._abouts) - 1)

    def keep_steps(self, time: float, steps: Sequence[Line], /) -> None:
        """Add lines of one time; see `LineSink`."""
        time = round(time, 6)
        for about in steps:
            is_known = id(about) in self._steps
            if not is_known and len(self._steps) < _MOST_STEPS:
                self._steps[id(about)] = about
                is_known = True
            self._times.append(time)
            self._abouts.append(about)
            if not is_known:
                self._others.append(len(self._abouts) - 1)

    def write(self, data: bytes) -> None:
        """Add lines as a recorder in another process wrote them; what can't be read is left out."""
        steps, times, abouts = self._steps, self._times, self._abouts
        before, time = b"", None
        for text in data.split(b"\n"):
            head, _, rest = text.partition(b",")
            if head != before:
                before, time = head, self._time(head)
            about = steps.get(rest)
            if about is None:
                about = self._step(rest)
            if about is None or time is None:
                self._decode(text)
            else:
                times.append(time)
                abouts.append(about)

    def with_more(self, lines: Iterable[Line]) -> "TraceLines":
        """A copy with further lines; another thread may still write to this one."""
        copy = TraceLines()
        # First the numbers: they must not be of lines that the copy does not have.
        copy._others = self._others.copy()
        copy._steps = self._steps.copy()
        copy._abouts = self._abouts.copy()
        copy._times = self._times[: len(copy._abouts)]
        for line in lines:
            copy.keep(line)
        return copy

    def steps(self) -> Collection[Line]:
        """What lines are about, each at least once; many of them only once."""
        return [*self._steps.values(), *(self._abouts[number] for number in self._others)]

    def timed(self) -> Iterator[tuple[float, Line]]:
        """Each line that has a time, as its time and what it is about."""
        for time, about in zip(self._times, self._abouts, strict=True):
            if time is not None:
                yield time, about

    def of_kind(self, kind: str) -> Iterator[tuple[int, float, Line]]:
        """The lines about one kind of thing: the number of each, its time and what it is about."""
        for number in self._numbers(kind):
            time = self._times[number]
            if time is not None:
                yield number, time, self._abouts[number]

    @overload
    def __getitem__(self, index: int) -> Line: ...
    @overload
    def __getitem__(self, index: slice) -> list[Line]: ...
    def __getitem__(self, index: int | slice) -> Line | list[Line]:
        if isinstance(index, slice):
            return [self[number] for number in range(*index.indices(len(self)))]
        time, about = self._times[index], self._abouts[index]
        return about if time is None else {"t": time, **about}

    def __len__(self) -> int:
        return len(self._abouts)

    def _numbers(self, kind: str) -> Iterable[int]:
        ids = {id(about) for about in self._steps.values() if kind_of(about) == kind}
        if not ids:
            return (number for number in self._others if kind_of(self._abouts[number]) == kind)
        return (
            number
            for number, about in enumerate(self._abouts)
            if id(about) in ids or kind_of(about) == kind
        )

    def _time(self, head: bytes) -> float | None:
        """The time of a line, by what is before its first comma; None if that is something else."""
        if not head.startswith(_BEFORE_TIME):
            return None
        try:
            time = self._decoder.decode(head[len(_BEFORE_TIME) :])
        except (msgspec.DecodeError, UnicodeDecodeError):
            return None
        return time if _is_time(time) else None

    def _step(self, rest: bytes) -> Line | None:
        """What a step is about that has not been seen yet; None if it is kept like others."""
        if not rest.startswith(_STEPS) or len(rest) > _LONGEST_STEP:
            return None
        if len(self._steps) >= _MOST_STEPS:
            return None
        try:
            about = self._decoder.decode(b"{" + rest)
        except (msgspec.DecodeError, UnicodeDecodeError):
            return None
        if not isinstance(about, dict) or "t" in about:
            return None
        self._steps[rest] = about
        return about

    def _decode(self, text: bytes) -> None:
        try:
            line = self._decoder.decode(text)
        except (msgspec.DecodeError, UnicodeDecodeError):
            # Not from a recorder.
            return
        if isinstance(line, dict) and (_is_time(line.get("t")) or "run" in line):
            self.keep(line)


def kind_of(about: Line) -> str:
    """What a line is about: the name of its first value other than the time."""
    for key in about:
        if key != "t":
            return key
    return ""


def _is_time(value: object) -> bool:
    return isinstance(value, int | float) and abs(value) < _LARGEST_NUMBER
