"""What is said while a program runs, and of the robot and its camera."""

from typing import Annotated, Any, Literal

from msgspec import Meta, Struct, field

from learnblock.server.messages.base import Coordinate, Message, Name, StateName

# The page speaks.


class ChooseRobot(Message, frozen=True):
    name: Name


class ChooseWorld(Message, frozen=True):
    name: Name


class Run(Message, frozen=True):
    """Run the program from the beginning.

    Args:
        paused: hold it before its first line.
    """

    paused: bool = False


class Stop(Message, frozen=True):
    """Stop the program and the robot."""


class Pause(Message, frozen=True):
    """Hold program and world where they are."""


class Resume(Message, frozen=True):
    """Go on after a pause or a breakpoint."""


class Step(Message, frozen=True):
    """Run to the next line; `over` does not follow calls into functions."""

    over: bool = False


class SetSpeed(Message, frozen=True):
    """How fast simulated time runs: times real time; None is as fast as it goes."""

    factor: Annotated[float, Meta(ge=0.01, le=100)] | None


class Answer(Message, frozen=True):
    """The line that the program asked for by `InputWanted`."""

    text: Annotated[str, Meta(max_length=10_000)]


class ResetWorld(Message, frozen=True):
    """Put everything back to where it was at first; only while no program runs."""


class PlaceRobot(Message, frozen=True):
    """Set the robot down elsewhere; the next run starts there. Only while the world stands still.

    Args:
        x: mm east.
        y: mm north.
        heading: degrees clockwise, 0 looks east.
    """

    x: Coordinate
    y: Coordinate
    heading: Annotated[float, Meta(ge=-360, le=360)]


class Drive(Message, frozen=True):
    """Drive by hand while no program runs; told again at least twice a second, else it stops.

    Args:
        advance: of the robot's fastest, -1 to 1, forward positive.
        rotation: of the robot's fastest, -1 to 1, clockwise positive.
    """

    advance: Annotated[float, Meta(ge=-1, le=1)]
    rotation: Annotated[float, Meta(ge=-1, le=1)]


class WatchCamera(Message, frozen=True):
    """Send camera frames from now on, or no more."""

    on: bool


# The server speaks.


class RunState(Message, frozen=True):
    """What the program does.

    Args:
        state: ``idle`` before the first run, ``ended`` after one; ``paused`` holds the world,
            ``held`` holds the program before a line; ``input`` waits for `Answer`.
        block: the block before which it is held.
    """

    state: StateName
    block: str | None = None
    speed: float | None = 1.0


class InputWanted(Message, frozen=True):
    """The program waits for a line."""

    prompt: str


class Printed(Message, frozen=True):
    """What the program printed, at most some thousand characters at once."""

    text: str


class GoalNow(Struct, frozen=True):
    """A goal of the world."""

    name: str
    sort: str
    state: Literal["open", "reached", "failed"]
    time: float | None


class Ended(Message, frozen=True):
    """How a run ended: the report of ``learnblock run``.

    Args:
        ended: one word, such as ``finished``, ``stopped`` or ``error``.
        message: a sentence when it did not end well.
        block: where it went wrong.
        no_effect: skills that had none, each with the device that is missing.
        own_block: the file's name of the own block in which it went wrong, if in one.
        own_line: the line of its source, from 1; 0 where it is not known.
        tried: it was `TryOwnBlock` and no program.
    """

    ended: str
    message: str = ""
    block: str | None = None
    time: float = 0.0
    distance: float | None = None
    goals: tuple[GoalNow, ...] = ()
    emotions: tuple[str, ...] = ()
    no_effect: tuple[tuple[str, str], ...] = ()
    trace_sha256: str = ""
    own_block: str = ""
    own_line: int = 0
    tried: bool = False


class WhenNow(Struct, frozen=True):
    """A `when`: whether it is active, and since how many seconds."""

    name: str
    active: bool
    time: float


class Variables(Message, frozen=True):
    """The program's variables as text: those of the function it is in, and its own."""

    local: dict[str, str]
    shared: dict[str, str]
    whens: tuple[WhenNow, ...] = ()


class Robot(Struct, frozen=True, omit_defaults=True):
    """A robot as it is now.

    Args:
        name: in its world.
        x: mm east.
        y: mm north.
        heading: degrees clockwise, 0 looks east.
        joints: degrees, by key.
        leds: red, green, blue, by key.
        emotion: what it shows; ``none`` is nothing.
    """

    name: str
    x: float
    y: float
    heading: float
    joints: dict[str, float] = field(default_factory=dict)
    leds: dict[str, tuple[int, int, int]] = field(default_factory=dict)
    emotion: str = "none"


class Telemetry(Message, frozen=True):
    """The world as it is now, about twenty times a second while something moves.

    Args:
        time: seconds of the world.
        robots: ours is the first.
        pushed: x, y, heading of what can be pushed, in the order of the world's description:
            boxes with a mass first, then cylinders.
        sensors: readings by sensor, such as ``Distance front 1`` in its unit; None where nothing is
            measured.
        block: the block that runs.
        goals: as they stand.
    """

    time: float
    robots: tuple[Robot, ...]
    pushed: tuple[tuple[float, float, float], ...] = ()
    sensors: dict[str, float | bool | None] = field(default_factory=dict)
    block: str | None = None
    goals: tuple[GoalNow, ...] = ()


class Sound(Message, frozen=True):
    """The robot would be heard.

    Args:
        device: such as ``Speaker``.
        action: such as ``say``.
        values: as the robot was told.
    """

    device: str
    action: str
    values: tuple[Any, ...]


class Seen(Struct, frozen=True, omit_defaults=True):
    """Something that perception found in a camera frame.

    Args:
        sort: tag, face or line.
        label: such as the tag's number.
        corners: x, y in pixels of the frame.
    """

    sort: Literal["tag", "face", "line"]
    label: str
    corners: tuple[tuple[float, float], ...]


class CameraFrame(Message, frozen=True):
    """What the next binary message is: a JPEG of the camera, and what was found in it."""

    width: int
    height: int
    time: float
    seen: tuple[Seen, ...] = ()
