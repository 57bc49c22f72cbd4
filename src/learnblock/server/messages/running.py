"""Messages about running programs, and about the robot and its camera."""

from typing import Annotated, Any, ClassVar, Literal

from msgspec import Meta, Struct

from learnblock.client.keyboard import KEYS, Key
from learnblock.i18n import Phrase
from learnblock.monitor.monitor import GoalNow, Link, Seen, State
from learnblock.runtime.debugger import HeldBy
from learnblock.server.messages.base import (
    Coordinate,
    FromReader,
    Look,
    Name,
    Pace,
    StateName,
    ToPage,
    Write,
)

VariantNumber = Annotated[int, Meta(ge=0, le=9999)]

# From the page.


class ChooseRobot(Write, FromReader, frozen=True):
    name: Name


class ChooseWorld(Write, FromReader, frozen=True):
    """Choose a world, or another variant of it.

    Args:
        name: its name.
        variant: the number of a variant; 0 is the world as it is drawn.
    """

    name: Name
    variant: VariantNumber = 0


class Run(Write, FromReader, frozen=True):
    """Run the program from the beginning.

    Args:
        paused: whether to pause before its first line.
    """

    pace: ClassVar = Pace(minute=30, burst=10)

    paused: bool = False


class Stop(Look, frozen=True):
    """Stop the program and the robot, which a watching teacher may have to do at once."""


class Pause(Write, FromReader, frozen=True):
    """Pause program and world."""


class Resume(Write, FromReader, frozen=True):
    """Resume after a pause or a breakpoint."""


class Step(Write, FromReader, frozen=True):
    """Run to the next line; `over` does not follow calls into functions."""

    over: bool = False


class SetSpeed(Write, FromReader, frozen=True):
    """Set the speed of simulated time, as a multiple of real time; None is the fastest."""

    factor: Annotated[float, Meta(ge=0.01, le=100)] | None


class Answer(Write, FromReader, frozen=True):
    """Answer `InputWanted` with a line."""

    text: Annotated[str, Meta(max_length=10_000)]


class HoldKeys(Write, frozen=True):
    """The keys that the user holds down now, for all programs that ask for them."""

    keys: Annotated[tuple[Key, ...], Meta(max_length=len(KEYS))]


class ResetWorld(Write, FromReader, frozen=True):
    """Reset the world to its initial state; only while no program runs."""


class PlaceRobot(Write, FromReader, frozen=True):
    """Place the robot elsewhere; the next run starts there. Only while nothing moves.

    Args:
        x: mm east.
        y: mm north.
        heading: degrees clockwise, 0 faces east.
    """

    x: Coordinate
    y: Coordinate
    heading: Annotated[float, Meta(ge=-360, le=360)]


class HandleRobot(Write, frozen=True):
    """Shake a simulated robot, or tilt it to a side until another message; also during a run."""

    how: Literal["shake", "level", "front", "back", "left", "right"]


class Drive(Write, FromReader, frozen=True):
    """Drive by hand while no program runs; the robot stops half a second after the last message.

    Args:
        advance: a fraction of the robot's top speed, -1 to 1, forward positive.
        rotation: a fraction of the robot's top speed, -1 to 1, clockwise positive.
    """

    advance: Annotated[float, Meta(ge=-1, le=1)]
    rotation: Annotated[float, Meta(ge=-1, le=1)]


class WatchCamera(Look, frozen=True):
    """Begin or stop sending camera frames."""

    on: bool


# From the server.


class RunState(ToPage, frozen=True):
    """The state of the program.

    Args:
        state: ``idle`` before the first run, ``ended`` after one; ``paused`` together
            with its world, ``held`` before a line of code; ``input`` while it waits for `Answer`;
            ``done`` once it has ended while the programs of other robots continue.
        block: the block it is paused at.
        held_by: why it is held there: at a breakpoint, after a step, or because it was paused.
        speed: the speed of simulated time, as a multiple of real time; None is the fastest.
    """

    state: StateName
    block: str | None = None
    speed: float | None = 1.0
    held_by: HeldBy = "pause"


class InputWanted(ToPage, frozen=True):
    """The program is waiting for a line."""

    prompt: str


class KeysWanted(ToPage, frozen=True):
    """The programs of a run ask whether keys are held down.

    Args:
        keys: the keys they ask for; all if that is unknown, none once they have ended.
        programs: the number of programs that ask for keys.
    """

    keys: tuple[Key, ...]
    programs: int = 1


class Printed(ToPage, frozen=True):
    """Output of the program, at most a few thousand characters at once.

    Args:
        text: the output.
        until: the number of characters that the program has printed so far, with it; each print
            counts as a line.
    """

    text: str
    until: int = 0


class Bumped(ToPage, frozen=True):
    """The robot has bumped into something.

    Args:
        time: seconds of the robot's time.
        thing: what it bumped into.
    """

    time: float
    thing: Phrase


class PrintedPart(Struct, frozen=True):
    """What one of several robots printed without another in between.

    Args:
        robot: its name.
        text: the output.
        until: the number of characters that it has printed so far; see `Printed`.
    """

    robot: str
    text: str
    until: int


class PrintedByRobots(ToPage, frozen=True):
    """`Printed` for robots that share a program, in the order in which they printed."""

    parts: tuple[PrintedPart, ...]


class Ended(ToPage, frozen=True):
    """How a run ended: the report of ``learnblock run``.

    Args:
        ended: one word, such as ``finished``, ``stopped`` or ``error``.
        message: the reason, when it did not end well.
        block: the block with the error.
        line: the line of the program's Python with the error, from 1; 0 if unknown.
        no_effect: skills that had no effect, each with the missing device.
        custom_block: the file name of the custom block with the error, if it was in one.
        custom_line: the line of its source, from 1; 0 if unknown.
        trace_sha256: the hash of the trace; empty if a real robot took part with others.
        repeatable: whether the same programs give the same run: no real robot took part.
        tried: whether it was `TryCustomBlock` rather than the program.
        others: whether other robots' programs continue; the report of the whole run follows.
    """

    ended: str
    message: Phrase | None = None
    block: str | None = None
    line: int = 0
    time: float = 0.0
    distance: float | None = None
    goals: tuple[GoalNow, ...] = ()
    emotions: tuple[str, ...] = ()
    no_effect: tuple[tuple[str, str], ...] = ()
    trace_sha256: str = ""
    repeatable: bool = True
    custom_block: str = ""
    custom_line: int = 0
    tried: bool = False
    others: bool = False


class WhenNow(Struct, frozen=True):
    """A `when`: whether it is active, and for how many seconds."""

    name: str
    active: bool
    time: float


class Variables(ToPage, frozen=True):
    """The program's variables as text: local ones of the current function, and global ones."""

    local: dict[str, str]
    shared: dict[str, str]
    whens: tuple[WhenNow, ...] = ()


class RunningLine(ToPage, frozen=True):
    """The position in the running program; sent when it changes, several times a second.

    Args:
        line: the line of the program's Python, from 1; 0 before the first.
        block: the block of that line, if it is in one.
    """

    line: int
    block: str | None = None


class StrokePart(Struct, frozen=True):
    """The new points of a pen's stroke.

    Args:
        stroke: the number of the stroke, from 0.
        color: red, green and blue, 0 to 255.
        width: mm.
        points: (mm east, mm north), after those sent before.
    """

    stroke: int
    color: tuple[int, int, int]
    width: float
    points: tuple[tuple[float, float], ...]


class Drawing(ToPage, frozen=True):
    """What has been drawn on the floor since the last such message.

    Args:
        fresh: whether everything drawn before is gone.
        parts: in the order in which the strokes were begun.
    """

    fresh: bool
    parts: tuple[StrokePart, ...] = ()


class Telemetry(ToPage, State, frozen=True):
    """The current state of the world, about twenty times per second while something changes.

    Args:
        found: the last findings of the program's own questions in the camera's picture; None if it
            has asked nothing, and while the page looks back at a run.
    """

    found: tuple[Seen, ...] | None = None


class RobotLink(ToPage, Link, frozen=True):
    """The link to the robot; sent when it changes."""


class Sound(ToPage, frozen=True):
    """A sound or another output of a simulated robot.

    Args:
        device: such as ``Speaker``.
        action: such as ``say``.
        values: the values of the command.
        stand_in: whether the robot has no loudspeaker, so that the page's takes its place.
    """

    device: str
    action: str
    values: tuple[Any, ...]
    stand_in: bool = False


class CameraFrame(ToPage, frozen=True):
    """The size and the findings of the camera frame (JPEG) in the next binary message.

    Args:
        width: in pixels.
        height: in pixels.
        time: when it was taken, in s.
        seen: the findings.
        past: whether it is of a moment that the page looks back at.
    """

    width: int
    height: int
    time: float
    seen: tuple[Seen, ...] = ()
    past: bool = False
