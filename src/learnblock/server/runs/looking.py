"""Looks back at a run: its moments, and its call graph."""

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from threading import Lock, Thread
from time import monotonic
from typing import TYPE_CHECKING, Protocol

from learnblock.errors import LearnBlockError
from learnblock.runtime.log.blocks import Block, Stream
from learnblock.runtime.log.noting import TICK
from learnblock.server import messages
from learnblock.server.messages.looking import MOST_MARKS, MOST_POINTS
from learnblock.server.runs import telemetry
from learnblock.server.runs.live_timeline import LiveTimeline
from learnblock.server.runs.reported import Reported, predicted
from learnblock.server.runs.telemetry import Drawn

if TYPE_CHECKING:
    from learnblock.monitor.monitor import Picture
    from learnblock.why import History, Recorded
    from learnblock.why.answers import Answers
    from learnblock.why.calls import Calls
    from learnblock.why.moments import Moments
    from learnblock.why.questions import Question
    from learnblock.why.sentences import Sentence
    from learnblock.why.steps import Place, Steps
    from learnblock.why.world_again import WorldAgain

#: Reading the log of a run that goes on is long from so many seconds on; then it is not read again
#: before so many times that time has passed.
LONG, PATIENCE = 0.05, 20
NO_TIMELINE = messages.Timeline(0.0)


class Log(Protocol):
    """The log of a run in progress, or of a kept one."""

    @property
    def blocks(self) -> tuple[Block, ...]:
        """Its current content, oldest first."""

    @property
    def complete_since(self) -> int:
        """The oldest detail that it still has, in ticks."""


class Looking:
    """A run that pages look back at; its methods are slow, and may be called from any thread.

    Args:
        log: the log of the run, which may be in progress.
        blocks: for each line of the program's Python, its block; None for a line without one.
    """

    def __init__(self, log: Log, blocks: Sequence[str | None]) -> None:
        self.log = log
        self._line_blocks = blocks
        self._lock = Lock()
        self._read = 0
        self._history: History | None = None
        self._moments: Moments | None = None
        self._steps: Steps
        self._world: WorldAgain | None = None
        self._reported: Reported
        self._answers: Answers | None = None
        self._live = LiveTimeline()
        #: When the log was read, and how long that took, in s.
        self._read_at = self._cost = 0.0
        #: Held by the next caller; see `_turn`.
        self._next = Lock()
        self._preparing: Thread | None = None

    def timeline(self, *, live: bool = False) -> messages.Timeline:
        """The run so far.

        Args:
            live: whether it is in progress, so that only what is quickly found out is included.
        """
        with self._turn():
            if live:
                return self._live.read(self.log.blocks)
            history, moments = self._now()
            self._prepare()
            marks = moments.marks[-MOST_MARKS:]
            return messages.Timeline(
                history.end,
                self._world is not None,
                round(self.log.complete_since * TICK, 2),
                tuple(messages.TimeMark(mark.time, mark.kind, mark.text) for mark in marks),  # type: ignore[arg-type] # the same kinds
                way(history.recorded),
            )

    def past(self, request: messages.LookBack) -> messages.Past:
        """The run at a place, or at the one before or after it."""
        with self._turn():
            history, moments = self._now(request.time)
            place = self._place(request)
            found = self._go(request, place) if request.step else place
            tick, event = found or place
            time = min(request.time, history.end) if found == place else round(tick * TICK, 3)
            moment = moments.at(time, event)
            is_whole = event == history.at(time)
            line = moment.line if is_whole else self._steps.line_at((tick, event))
            whens = tuple(messages.WhenNow(name, *state) for name, state in moment.whens.items())
            return messages.Past(
                time,
                event,
                messages.RunningLine(line, self._block(line)),
                messages.Variables(moment.local, moment.shared, whens),
                found is not None,
                self._values(event, line),
                moment.stack,
                moment.printed,
                *self._world_at(time),
            )

    def picture(self, time: float) -> "Picture | None":
        """What the robot's camera saw at a time in s; None if that is not known."""
        from learnblock.monitor.world_monitor import WorldMonitor  # noqa: PLC0415 - slow to load

        with self._turn():
            self._now(time)
            return WorldMonitor.of(self._world.seek(time)).camera() if self._world else None

    def predicted(self) -> messages.Predicted:
        """Where the twin of a real robot would have been."""
        with self._turn():
            history, _ = self._now()
        return predicted(history.recorded)

    def values(self, now: Mapping[str, str]) -> messages.ValuesThere:
        """The values next to the lines of a program that is paused now.

        Args:
            now: the program's variables as it reported them; a log that is not up to date yet
                gives nothing.
        """
        with self._turn():
            history, moments = self._now()
            event = len(history.events) - 1
            values = self._values(event, moments.line_at(history.end))
            is_late = any(now.get(value.name, value.value) != value.value for value in values)
            return messages.ValuesThere(() if is_late else values)

    def calls(self, first: float, last: float | None) -> messages.CallGraph:
        """The call graph of a part of the run."""
        from learnblock.why.calls import calls  # noqa: PLC0415 - the page opens before it is needed

        with self._turn():
            history, _ = self._now()
            graph = calls(history, first, last)
        return call_graph(graph)

    def questions(self, block: str, time: float | None) -> messages.Questions:
        """What can be asked about the run, about a block, or about the robot at a time in s."""
        from learnblock.why import questions  # noqa: PLC0415 - as above

        with self._turn():
            history, _ = self._now()
        if block:
            lines = self._lines_of(history, block)
            possible = questions.questions_about_lines(history, lines, time)
        elif time is not None:
            possible = questions.questions_about_moment(history, time)
        else:
            possible = questions.questions(history)
        return messages.Questions(
            tuple(self._asked(history, question) for question in possible), block
        )

    def answer(self, question: messages.WhyQuestion) -> messages.WhyAnswer:
        """The answer to a question."""
        from learnblock.why.answers import Answers  # noqa: PLC0415 - as above
        from learnblock.why.questions import Ask, Question, with_values  # noqa: PLC0415
        from learnblock.why.things import seen_in  # noqa: PLC0415

        asked = Question(Ask(question.ask), question.subject, question.time)
        with self._turn():
            history, _ = self._now()
            if self._answers is None:
                self._answers = Answers(history, seen_in(self._world) if self._world else None)
            answer = self._answers.answer(asked)
            asked = with_values(history, asked)
        return messages.WhyAnswer(
            self._asked(history, asked),
            tuple(self._sentence(history, sentence) for sentence in answer.sentences),
            tuple(self._sentence(history, sentence) for sentence in answer.more),
        )

    def _sentence(self, history: "History", sentence: "Sentence") -> messages.WhySentence:
        return messages.WhySentence(
            sentence.phrase,
            sentence.time if sentence.event >= 0 else None,
            self._block_of(history, str(sentence.line)),
            self._block_of(history, str(sentence.phrase.values.get("inner", ""))),
        )

    def _asked(self, history: "History", question: "Question") -> messages.Asked:
        asked = messages.WhyQuestion(question.ask.value, question.subject, question.time)
        return messages.Asked(asked, question.phrase, self._block_of(history, question.subject))

    def _block_of(self, history: "History", line: str) -> str | None:
        """The block of an author's line, given as text; None if it is no line."""
        number = int(line) if line.isdecimal() and len(line) < 10 else 0
        return self._block(history.program.python_line(number)) if number else None

    def _lines_of(self, history: "History", block: str) -> frozenset[str]:
        """The author's lines of a block."""
        return frozenset(
            str(history.program.written_line(number))
            for number, owner in enumerate(self._line_blocks, 1)
            if owner == block
        )

    @contextmanager
    def _turn(self) -> Iterator[None]:
        """Get exclusive use of the run; the thread that prepares the world lets others go first."""
        with self._next:
            self._lock.acquire()
        try:
            yield
        finally:
            self._lock.release()

    def _now(self, time: float | None = None) -> "tuple[History, Moments]":
        """The run as it is now, or at least up to a time in s; read again if it has continued."""
        from learnblock.why import History  # noqa: PLC0415 - as above
        from learnblock.why.moments import Moments  # noqa: PLC0415
        from learnblock.why.recorded import Recorded  # noqa: PLC0415
        from learnblock.why.steps import Steps  # noqa: PLC0415

        if self._history is None or self._moments is None or not self._is_known(time):
            began = monotonic()
            blocks = self.log.blocks
            recorded = Recorded.of(blocks)
            self._read = len(blocks)
            self._world = self._world_of(recorded)
            self._history = History(recorded)
            self._moments = Moments(self._history)
            self._reported = Reported(recorded)
            self._answers = None
            self._steps = Steps(self._history, self._moments)
            self._read_at, self._cost = monotonic(), monotonic() - began
        return self._history, self._moments

    def _is_known(self, time: float | None) -> bool:
        """Whether what has been read is enough for a time in s, or for all; see `_now`."""
        if self._history is None:
            return False
        if time is not None and time <= self._history.end:
            # What has happened by then no longer changes.
            return True
        blocks = self.log.blocks
        if time is not None and blocks[-1].stream is not Stream.ENDING:
            is_early = monotonic() - self._read_at < PATIENCE * self._cost
            return self._cost > LONG and is_early
        return len(blocks) == self._read

    def _world_of(self, recorded: "Recorded") -> "WorldAgain | None":
        """The world of what has been read; if more was added, the same world continues."""
        before, lines = self._history, recorded.lines
        count = len(before.recorded.lines) if before else 0
        is_longer = before and count and lines[count - 1] == before.recorded.lines[-1]
        # The lines of the other robots of a team are known at its end only.
        if is_longer and self._world and not recorded.team:
            self._world.extend(lines[count:])
            return self._world
        return _world_again(recorded)

    def _prepare(self) -> None:
        """Prepare for going back in the world while no page is looking back."""
        if self._world is None or (self._preparing and self._preparing.is_alive()):
            return
        self._preparing = Thread(target=self._prepare_world, name="past", daemon=True)
        self._preparing.start()

    def _prepare_world(self) -> None:
        more = True
        while more:
            with self._turn():
                more = self._world is not None and self._world.prepare()

    @property
    def _known(self) -> "History":
        assert self._history is not None  # noqa: S101 - every caller has read it
        return self._history

    def _block(self, line: int) -> str | None:
        return self._line_blocks[line - 1] if 1 <= line <= len(self._line_blocks) else None

    def _place(self, request: messages.LookBack) -> "Place":
        history = self._known
        tick, last = self._steps.at(min(request.time, history.end))
        return tick, last if request.event is None else min(request.event, last)

    def _go(self, request: messages.LookBack, place: "Place") -> "Place | None":
        from learnblock.why.steps import START, To  # noqa: PLC0415 - as above

        to = To(request.to)
        subject: str | frozenset[int] = request.subject
        if to is To.RUN:
            lines = enumerate(self._line_blocks, 1)
            subject = frozenset(number for number, block in lines if block == request.subject)
        found = self._steps.go(request.step, place, to, subject)
        if found or to not in (To.LINE, To.EVENT, To.TURN):
            return found
        # The run begins before the first line, and ends after the last one.
        end = START if request.step < 0 else self._steps.at(self._known.end)
        return None if end == place else end

    def _values(self, event: int, line: int) -> tuple[messages.ValueThere, ...]:
        from learnblock.why.values_there import values_there  # noqa: PLC0415 - as above

        history, moments = self._known, self._moments
        assert moments is not None  # noqa: S101 - read with the history
        heads = self._heads(history)
        return tuple(
            messages.ValueThere(heads[value.line], value.name, value.value)
            for value in values_there(history, moments, event, line)
            if value.line in heads
        )

    def _heads(self, history: "History") -> dict[int, str]:
        """The block of each line that is the first of its block; an `elif` has no block."""
        heads: dict[str, int] = {}
        for line in sorted({node.line for node in history.nodes}):
            if block := self._block(line):
                heads.setdefault(block, line)
        return {line: block for block, line in heads.items()}

    def _world_at(self, time: float) -> tuple[messages.Telemetry | None, messages.Drawing | None]:
        from learnblock.monitor.world_monitor import WorldMonitor  # noqa: PLC0415 - slow to load

        if self._world is None:
            state = self._reported.at(time)
            return telemetry.of_state(state) if state else None, None
        monitor = WorldMonitor.of(self._world.seek(time))
        return telemetry.telemetry(monitor), Drawn().news(monitor.strokes())


def call_graph(graph: "Calls") -> messages.CallGraph:
    """A call graph as pages draw it."""
    numbers = {node.called: number for number, node in enumerate(graph.nodes)}
    return messages.CallGraph(
        graph.robot,
        graph.first,
        graph.last,
        tuple(
            messages.CalledFunction(
                int(node.called.layer), node.called.name, node.count, node.seconds, node.share
            )
            for node in graph.nodes
        ),
        tuple(
            messages.CallEdge(
                numbers[edge.caller],
                numbers[edge.callee],
                edge.count,
                edge.seconds,
                edge.share,
                edge.first,
                edge.event,
            )
            for edge in graph.edges
        ),
    )


def way(recorded: "Recorded") -> tuple[tuple[float, float, float], ...]:
    """Where the robot was, if that is known: the time in s, mm east and mm north."""
    reported = ((line, line.get("pose") or line.get("odometry")) for line in recorded.lines)
    poses = [(line["t"], pose[0], pose[1]) for line, pose in reported if pose]
    return tuple(poses[:: 1 + len(poses) // MOST_POINTS])


def _world_again(recorded: "Recorded") -> "WorldAgain | None":
    from learnblock.why.world_again import WorldAgain  # noqa: PLC0415 - as above

    try:
        return WorldAgain(recorded)
    except LearnBlockError:
        # A real robot, or a world that is not here: the recorded data can still be shown.
        return None
