"""Messages about the moments of the last run, and its call graph."""

from typing import Annotated, Literal

from msgspec import Meta, Struct

from learnblock.i18n import Phrase
from learnblock.server.messages.base import Look, ShortText, ToPage
from learnblock.server.messages.running import Drawing, RunningLine, Telemetry, Variables

#: A time of a run in s: longer than any run that can be shown.
Time = Annotated[float, Meta(ge=0, le=1_000_000)]
#: The number of an event in the log of a run; -1 before the first one.
EventNumber = Annotated[int, Meta(ge=-1, le=2**31)]
#: The most marks that a timeline shows.
MOST_MARKS = 500
#: The most points of the way that it contains; of a longer one, every second or third one.
MOST_POINTS = 5000

# From the page.


class ReadTimeline(Look, frozen=True):
    """Ask for the timeline of the run; the reply is `Timeline`."""


class ReadPrediction(Look, frozen=True):
    """Ask where the twin of a real robot would have been; the reply is `Predicted`."""


class LookBack(Look, frozen=True):
    """Ask what the run was like at a place; the reply is `Past`.

    A place is a time, and the last event of the log that has happened there.

    Args:
        time: in s.
        event: the number of the event; None if everything of that time has happened.
        step: -1 for the place before that one, 1 for the one after; 0 for the place itself.
        to: what to go to: a line, an event, a turn of the loop, a mark, a change of a variable, or
            a run of a block.
        subject: the kind of mark (empty for any), the variable, or the block's id.
    """

    time: Time
    event: EventNumber | None = None
    step: Annotated[int, Meta(ge=-1, le=1)] = 0
    to: Literal["line", "event", "turn", "mark", "change", "run"] = "line"
    subject: ShortText = ""


class ReadPastPicture(Look, frozen=True):
    """Ask for the camera's picture at a time; the reply is a `CameraFrame` of the past.

    Args:
        time: in s.
    """

    time: Time


class ReadValues(Look, frozen=True):
    """Ask for the values next to the lines of a paused program; the reply is `ValuesThere`."""


class ReadCalls(Look, frozen=True):
    """Ask for the call graph of a part of the run; the reply is `CallGraph`.

    Args:
        first: where the part begins, in s.
        last: where it ends; None for the end of the run.
    """

    first: Time = 0.0
    last: Time | None = None


class WhyQuestion(Struct, frozen=True):
    """A question about a run.

    Args:
        ask: its kind, as in `learnblock.why.questions.QuestionKind`.
        subject: what it is about.
        time: the moment, in s; None for the whole run.
    """

    ask: Literal[
        "movement",
        "not-movement",
        "skill",
        "not-skill",
        "print",
        "not-print",
        "printed",
        "when",
        "not-when",
        "line",
        "not-line",
        "value",
        "goal",
        "reached",
        "emotion",
        "end",
        "not-end",
        "nothing",
        "long",
        "speed",
        "lost",
        "fall",
        "bump",
        "score",
        "lives",
        "game",
        "now",
    ]
    subject: ShortText = ""
    time: Time | None = None


class ReadQuestions(Look, frozen=True):
    """Ask what can be asked about the run; the reply is `Questions`.

    Args:
        block: only about this block; empty for all.
        time: about the block, or without one about the robot, at this moment, in s; None for the
            whole run.
    """

    block: ShortText = ""
    time: Time | None = None


class AskWhy(Look, frozen=True):
    """Ask a question about the run; the reply is `WhyAnswer`."""

    question: WhyQuestion


# From the server.


class Asked(Struct, frozen=True):
    """A question in words.

    Args:
        question: the question.
        phrase: its words; a line in them is that of the text that ran.
        block: the block of the line that it is about; None for none.
    """

    question: WhyQuestion
    phrase: Phrase
    block: str | None = None


class Questions(ToPage, frozen=True):
    """What can be asked about the run, one of its blocks, or the robot at a moment.

    Args:
        questions: in the order in which they are listed.
        block: the block they are about; empty for none.
    """

    questions: tuple[Asked, ...]
    block: str = ""


class WhySentence(Struct, frozen=True):
    """One fact of an answer.

    Args:
        phrase: the fact in words; its ``line`` and ``inner`` are lines of the text that ran.
        time: the moment that it is about, in s; None for no moment.
        block: the block that it is about, which is that of ``line``; None for none.
        inner: the block of ``inner``; None for none.
    """

    phrase: Phrase
    time: float | None = None
    block: str | None = None
    inner: str | None = None


class WhyAnswer(ToPage, frozen=True):
    """An answer.

    Args:
        asked: the question.
        sentences: the most important facts.
        more: the others, shown on request.
    """

    asked: Asked
    sentences: tuple[WhySentence, ...] = ()
    more: tuple[WhySentence, ...] = ()


class TimeMark(Struct, frozen=True):
    """Something that stands out in a run.

    Args:
        time: in s.
        sort: what it is.
        text: the goal, the thing, the text, the emotion or the name of a `when`.
    """

    time: float
    sort: Literal["goal", "bump", "print", "message", "placed", "emotion", "when", "error"]
    text: str


class MissedGoal(Struct, frozen=True):
    """A goal that a run has missed.

    Args:
        words: by how much.
        place: where it is, (x mm, y mm).
        nearest: how near to it the robot came.
    """

    words: Phrase
    place: tuple[float, float]
    nearest: tuple[float, float]


class Timeline(ToPage, frozen=True):
    """The run so far, or the last one.

    Args:
        end: its length in s; 0 if there is none to look back at.
        exact: whether its world can be shown at any time; otherwise only what was recorded.
        since: the oldest time with all details, in s.
        marks: what stands out, in order; the last ones if there are too many.
        way: where the robot was, if that is known: the time in s, mm east and mm north.
        missed: the first goal that it has missed, once it has ended; None if that has no place.
        begin: the time in s from which on it is shown.
    """

    end: float
    exact: bool = True
    since: float = 0.0
    marks: tuple[TimeMark, ...] = ()
    way: tuple[tuple[float, float, float], ...] = ()
    missed: MissedGoal | None = None
    begin: float = 0.0


class ValueThere(Struct, frozen=True):
    """A value next to a line of the program.

    Args:
        block: the block of the line.
        name: the variable or the call that has the value; empty for a condition.
        value: as text.
    """

    block: str
    name: str
    value: str


class ValuesThere(ToPage, frozen=True):
    """The values next to the lines of a paused program."""

    values: tuple[ValueThere, ...] = ()


class TwinFinding(Struct, frozen=True):
    """One fact about a real robot and its twin.

    Args:
        phrase: the fact in words.
        time: when that was, in s; None for the whole run.
    """

    phrase: Phrase
    time: float | None = None


class Predicted(ToPage, frozen=True):
    """Where the twin of a real robot was that obeyed the same commands.

    Args:
        way: the time in s, mm east, mm north, and degrees clockwise; empty for a simulated robot.
        parted: when the real robot left that way, in s; None if it did not.
        findings: what the difference means, the most important first.
        unrecorded: what was not recorded, so that it could not be compared.
    """

    way: tuple[tuple[float, float, float, float], ...] = ()
    parted: float | None = None
    findings: tuple[TwinFinding, ...] = ()
    unrecorded: tuple[Phrase, ...] = ()


class Past(ToPage, frozen=True):
    """What a run was like at a place.

    Args:
        time: in s.
        event: the last event that had happened; -1 before the first one.
        line: the line that ran, and its block.
        variables: what the variables held.
        found: whether there is a place to go to in the requested direction; without one
            the place is still the same.
        values: the values next to the lines.
        stack: the functions that ran, outermost first.
        printed: the number of characters printed so far; see `Printed.until`.
        telemetry: the world; None if it was a real one.
        drawing: what had been drawn on the floor; None if nothing had.
    """

    time: float
    event: int
    line: RunningLine
    variables: Variables
    found: bool = True
    values: tuple[ValueThere, ...] = ()
    stack: tuple[str, ...] = ()
    printed: int = 0
    telemetry: Telemetry | None = None
    drawing: Drawing | None = None


class CalledFunction(Struct, frozen=True):
    """A function in a call graph.

    Args:
        layer: its row: 0 the program, 1 its functions, 2 skills, 3 the generic client, 4 devices,
            5 the robot's driver.
        name: its name.
        count: the number of its calls.
        seconds: the robot's time spent in it and in what it called.
        share: that, as a part of the whole, from 0 to 1.
    """

    layer: int
    name: str
    count: int
    seconds: float
    share: float


class CallEdge(Struct, frozen=True):
    """The calls of one function by another.

    Args:
        caller: its index in `CallGraph.functions`.
        callee: the other's.
        count: their number.
        seconds: the robot's time spent in them.
        share: that, as a part of the whole, from 0 to 1.
        first: the time of the first one, in s.
        event: the number of the first one in the log.
    """

    caller: int
    callee: int
    count: int
    seconds: float
    share: float
    first: float
    event: int


class CallGraph(ToPage, frozen=True):
    """The call graph of a part of a run.

    Args:
        robot: the robot's id.
        first: where the part begins, in s.
        last: where it ends.
        functions: all that were called, by row.
        edges: the calls, in order of the first one.
    """

    robot: str
    first: float
    last: float
    functions: tuple[CalledFunction, ...] = ()
    edges: tuple[CallEdge, ...] = ()
