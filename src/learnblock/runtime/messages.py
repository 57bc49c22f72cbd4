"""The whole conversation between the robot host and the child that runs a program.

The child speaks first and the host answers only where the message says so, so the two can never
wait for each other. Messages stay in order, so the host can put a program's prints, lines and calls
at the right place in the trace.

The types of the child's messages say how large each field may be; whether it makes sense is checked
by `learnblock.runtime.validation`.
"""

from enum import IntEnum
from typing import Annotated, Any

import msgspec
from msgspec import Meta

from learnblock.i18n import Phrase
from learnblock.runtime.limits import Limits
from learnblock.scores import Change
from learnblock.wheels import Drivetrain

#: The largest message of a child, in bytes; `Logged` and pictures may be larger.
LARGEST = 64 * 1024
#: The largest `Logged`: more events are sent in several.
LARGEST_LOGGED = 256 * 1024
#: The most steps in a message, arguments of a call, and devices and lines in a list.
MOST_STEPS, MOST_ARGUMENTS, MOST_NUMBERS = 2000, 100, 1000
#: The most characters of a name, of a prompt, and of a part of a printed line. A character that
#: UTF-8 cannot encode takes six.
LONGEST_NAME, LONGEST_PROMPT, LONGEST_PRINT = 1000, 2000, 6 * 8192
#: The most bytes of a value that is sent to other robots. A number takes at most 9 bytes here, and
#: at least 2 as JSON, in which its size is limited.
LARGEST_SENT = 32 * 1024
#: The largest number of a tick, of a line and of a call's depth.
LAST_TICK = LAST_NUMBER = 2**32 - 1
#: The most steps of a world that a program may wait.
MOST_WAITED = 2**53

Name = Annotated[str, Meta(max_length=LONGEST_NAME)]
Index = Annotated[int, Meta(ge=0, le=LAST_NUMBER)]
Indexes = Annotated[tuple[Index, ...], Meta(max_length=MOST_NUMBERS)]
Tick = Annotated[int, Meta(ge=0, le=LAST_TICK)]
Seconds = Annotated[float, Meta(ge=0, le=LAST_TICK)]
Arguments = Annotated[tuple[Any, ...], Meta(max_length=MOST_ARGUMENTS)]
NamedArguments = Annotated[dict[Name, Any], Meta(max_length=MOST_ARGUMENTS)]
#: The name of a file is checked against those that the host knows.
FileName = Annotated[str, Meta(max_length=4096)]
Described = dict[Name, Annotated[str, Meta(max_length=LONGEST_PROMPT)]]


class Message(msgspec.Struct, frozen=True, array_like=True, tag=True):
    """A message between host and program."""


# Messages of the host.


class Mode(IntEnum):
    """Where a program pauses, apart from breakpoints."""

    RUN = 0
    STEP = 1
    STEP_OVER = 2


class Control(Message, frozen=True):
    """Where the program should pause; it can arrive at any time.

    Args:
        breakpoints: the breakpoints, as lines of its Python.
        mode: nowhere else, at the next line, or at the next line in this or a calling function.
        depth: the call depth, for the last of these.
    """

    breakpoints: frozenset[int] = frozenset()
    mode: Mode = Mode.RUN
    depth: int = 0

    def holds(self, line: int, depth: int) -> bool:
        """Whether a program pauses at this line and call depth."""
        return (
            line in self.breakpoints
            or self.mode is Mode.STEP
            or (self.mode is Mode.STEP_OVER and depth <= self.depth)
        )


class Setup(Message, frozen=True):
    """The program to run; the first message.

    Args:
        source: the program's Python code.
        filename: its name in errors.
        folder: where its modules are imported from; "" for nowhere.
        skills: the names of the skills it may use.
        robots: the modules besides ours from which it may import a ``Robot``.
        debug: where it should pause at first; None without a debugger.
        limits: the resources that it may use.
        network: whether it may use the network.
        anyway: whether it goes on where it asks for something that the robot lacks.
        tags: the numbers of tags, by name, that it uses instead of the user's.
        log: whether it tells what it does, for the log of the run.
        variables: whether it tells its variables as they are at its end.
        dead_ends: the lines of loops that it never leaves; it tells when it is in one.
    """

    source: str
    filename: str
    folder: str
    skills: tuple[str, ...]
    robots: tuple[str, ...]
    debug: Control | None
    limits: Limits
    network: bool = False
    anyway: bool = False
    tags: dict[str, int] = {}
    log: bool = False
    variables: bool = False
    dead_ends: tuple[int, ...] = ()


class DeviceOffer(msgspec.Struct, frozen=True, array_like=True):
    """A device of the robot: its type, its key and the functions it is built from.

    Args:
        drivetrain: what the wheels of a base can do, if known.
    """

    type: str
    key: str
    functions: tuple[str, ...]
    drivetrain: Drivetrain | None = None


class Connected(Message, frozen=True):
    """The robot is connected.

    Args:
        devices: in the order in which `Ask` and `Command` count them.
        equipment: what the robot has; see `learnblock.senses.equipment`.
        steps: the world's step counter, or None for a real robot.
        dt: seconds per step.
        seed: seeds the program's own random numbers; None leaves them alone.
    """

    devices: tuple[DeviceOffer, ...]
    equipment: frozenset[str]
    steps: int | None
    dt: float
    seed: int | None


class Answer(Message, frozen=True):
    """The answer to a request.

    To an `Ask` the value, to a `Sleep` the step at which it woke and readings, to an `Input` the
    line (None if there is none) and the world's step (None without a world).
    """

    value: Any = None


class Failed(Message, frozen=True):
    """The request failed; `error` names the class in `learnblock.errors` to raise."""

    error: str
    phrase: Phrase


class Stop(Message, frozen=True):
    """The program must stop; a possible answer to any request."""


class Continue(Message, frozen=True):
    """Continue with the line at which the program has paused."""


class ShowVariables(Message, frozen=True):
    """Request `Variables`; it can arrive at any time."""


# Messages of the child.


class Contained(Message, frozen=True):
    """The child has given up its rights, and begins with the program."""


class Connect(Message, frozen=True):
    """The program creates its robot; answered by `Connected` or `Failed`."""

    module: Name
    arguments: NamedArguments


class Ask(Message, frozen=True):
    """Call a device's function; the `Answer` is its value."""

    device: Index
    function: Name
    args: Arguments


class Command(Message, frozen=True):
    """Call a device's function without waiting for an answer."""

    device: Index
    function: Name
    args: Arguments


class Sleep(Message, frozen=True):
    """Park until that many steps have passed.

    The answer is the step at which the program woke and the readings of the devices in `reads`,
    which the program has read since it last slept and will probably read again.
    """

    steps: Annotated[int, Meta(ge=1, le=MOST_WAITED)]
    reads: Indexes = ()


class Send(Message, frozen=True):
    """Send a message to the other robots of the run.

    Args:
        name: the name of the message.
        value: its value; it arrives encoded, because its size is checked before it is decoded.
    """

    name: Name
    value: msgspec.Raw


class Collect(Message, frozen=True):
    """Request the messages of other robots that have arrived; the answer is (name, value) each."""


class Keys(Message, frozen=True):
    """Request the keys of the keyboard that are held down; the answer is their names."""


class Stuck(Message, frozen=True):
    """The program is in a loop that it never leaves."""


class ChangeGame(Message, frozen=True):
    """Change what counts in the game that the robot plays, or end it."""

    change: Change
    amount: float


class AskGame(Message, frozen=True):
    """Request score, lives and time of the game; the answer is a `Tally`."""


class CollectNews(Message, frozen=True):
    """Request the news of the game that have arrived; the answer is a list of their names."""


class Disconnect(Message, frozen=True):
    """The program has stopped its robot."""


class Called(Message, frozen=True):
    """The program called a skill with arguments."""

    skill: Name
    args: Arguments
    kwargs: NamedArguments


class Steps(Message, frozen=True):
    """What the program did since the previous message, in order.

    Args:
        steps: the numbers of lines that ran, the names of skills called without arguments, skills
            called with a few small ones, and commands that take effect with the next step of the
            robot's world.
    """

    steps: Annotated[tuple[Index | Name | Called | Command, ...], Meta(max_length=MOST_STEPS)]


class Missing(Message, frozen=True):
    """A skill had no effect because the robot lacks a device."""

    skill: Name
    device: Name


class Printed(Message, frozen=True):
    """A line that the program printed, with its line end if there is one yet."""

    text: Annotated[str, Meta(max_length=LONGEST_PRINT)]


class Logged(Message, frozen=True):
    """What the program has done, for the log of the run.

    Args:
        first: the time of the first event, in ticks.
        last: the time of the last one.
        events: the events (`learnblock.runtime.log.events`), encoded with msgpack.
    """

    first: Tick
    last: Tick
    events: Annotated[bytes, Meta(max_length=LARGEST_LOGGED)]


class Input(Message, frozen=True):
    """The program waits for a line of input, which is the answer."""

    prompt: Annotated[str, Meta(max_length=LONGEST_PROMPT)]


class Variables(Message, frozen=True):
    """The program's variables as text.

    Args:
        local: the variables of the running function.
        shared: the variables of the program.
        whens: whether each `when` is active, and for how many seconds.
    """

    local: Described
    shared: Described
    whens: dict[Name, tuple[bool, Seconds]] = {}


class Line(Message, frozen=True):
    """The program has paused before a line; the answer is `Continue`.

    Args:
        number: the line.
        depth: the call depth.
        variables: the variables at that point.
    """

    number: Index
    depth: Index
    variables: Variables


class Fault(msgspec.Struct, frozen=True, array_like=True):
    """The error that ended the program.

    Args:
        phrase: the message for a person.
        lines: the program's own lines on the way to the error, outermost first; the innermost
            `MOST_NUMBERS`.
        file: the file in the user's folder where it happened; "" if it was in none.
        file_line: the line of that file, from 1.
    """

    phrase: Phrase
    lines: Indexes
    file: FileName = ""
    file_line: Index = 0


class Interrupted(Message, frozen=True):
    """A stop signal reached the program at this line; the program may still continue.

    Args:
        line: the line of the program.
        file: see `Fault`.
        file_line: see `Fault`.
    """

    line: Index
    file: FileName = ""
    file_line: Index = 0


class Ended(Message, frozen=True):
    """The program has ended by itself, with a `fault`, or because it was `stopped`.

    Args:
        lines: where it was stopped.
        variables: the variables at its end, if `Setup` asks for them.
    """

    fault: Fault | None = None
    stopped: bool = False
    lines: Indexes = ()
    variables: Variables | None = None


class Picture(msgspec.Struct, frozen=True, array_like=True, tag="Command"):
    """A `Command` that may be larger than others, because its only argument is a frame."""

    device: Index
    function: Name
    args: tuple[msgspec.msgpack.Ext]


FromHost = Setup | Connected | Answer | Failed | Stop | Control | Continue | ShowVariables
FromChild = (
    Contained
    | Connect
    | Ask
    | Command
    | Sleep
    | Send
    | Collect
    | Keys
    | Stuck
    | ChangeGame
    | AskGame
    | CollectNews
    | Disconnect
    | Steps
    | Line
    | Called
    | Missing
    | Printed
    | Logged
    | Input
    | Variables
    | Interrupted
    | Ended
)
