"""The checks in a lesson's file: what a program has to do, and how it has to be built.

Times are seconds of the robot's time, places mm (x east, y north of the middle of the floor),
headings degrees clockwise with 0 in the east.
"""

from typing import Annotated, Literal

from msgspec import Meta, Struct

from learnblock.lessons.texts import Title

Seconds = Annotated[float, Meta(ge=0, le=3600)]
Length = Annotated[float, Meta(ge=0, le=10_000)]
Place = Annotated[float, Meta(ge=-5000, le=5000)]
Heading = Annotated[float, Meta(ge=-360, le=360)]
Angle = Annotated[float, Meta(ge=0, le=180)]
Share = Annotated[float, Meta(ge=0, le=1)]
Count = Annotated[int, Meta(ge=0, le=10_000)]
Name = Annotated[str, Meta(min_length=1, max_length=80)]
#: With ``*`` for any characters; upper and lower case and spaces at the ends don't matter.
Pattern = Annotated[str, Meta(min_length=1, max_length=200)]


class AnyEvent(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True, tag_field="event"):
    """Something that happens at one time of a run."""


class GoalReached(AnyEvent, frozen=True, kw_only=True, tag="goal"):
    """A goal of the world is reached."""

    name: Name


class Shown(AnyEvent, frozen=True, kw_only=True, tag="shows"):
    """The robot shows an emotion or a text."""

    what: Pattern


class Said(AnyEvent, frozen=True, kw_only=True, tag="says"):
    """The robot says a text."""

    what: Pattern


class Printed(AnyEvent, frozen=True, kw_only=True, tag="prints"):
    """The program prints a line."""

    what: Pattern


class Called(AnyEvent, frozen=True, kw_only=True, tag="calls"):
    """The program calls a skill."""

    skill: Name


class Sent(AnyEvent, frozen=True, kw_only=True, tag="sends"):
    """The program sends a message to other robots."""

    message: Name


class Collided(AnyEvent, frozen=True, kw_only=True, tag="collision"):
    """The robot bumps into something."""

    thing: Pattern = "*"


class At(AnyEvent, frozen=True, kw_only=True, tag="at"):
    """The middle of the robot comes into a round region, seen every 0.1 s."""

    x: Place
    y: Place
    radius: Length = 100.0


class Stood(AnyEvent, frozen=True, kw_only=True, tag="stands"):
    """The robot has stood still for a while."""

    seconds: Annotated[float, Meta(ge=0.1, le=600)] = 1.0


Event = GoalReached | Shown | Said | Printed | Called | Sent | Collided | At | Stood


class AnyCheck(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True, tag_field="kind"):
    """What all checks have.

    Args:
        say: what the pupil reads; without it, the words of the check itself.
        name: what hints call the check; without it its kind.
        robot: the name of the robot among several; without it the first.
        optional: whether the step is done without it: then it earns a star of its own.
    """

    say: Title | None = None
    name: Name | None = None
    robot: Name | None = None
    optional: bool = False


class Reaches(AnyCheck, frozen=True, kw_only=True, tag="goals"):
    """Goals of the world are reached: those named, or all."""

    goals: Annotated[tuple[Name, ...], Meta(max_length=20)] = ()
    within: Seconds | None = None


class Happens(AnyCheck, frozen=True, kw_only=True, tag="happens"):
    """An event happens, so many times."""

    what: Event
    at_least: Count = 1
    at_most: Count | None = None
    within: Seconds | None = None


class Never(AnyCheck, frozen=True, kw_only=True, tag="never"):
    """An event never happens."""

    what: Event


class InOrder(AnyCheck, frozen=True, kw_only=True, tag="in_order"):
    """Events happen one after the other, with others in between.

    Args:
        events: the events.
        within: the most seconds between two of them that follow each other.
    """

    events: Annotated[tuple[Event, ...], Meta(min_length=2, max_length=20)]
    within: Seconds | None = None


class StaysOnLine(AnyCheck, frozen=True, kw_only=True, tag="on_line"):
    """From the first time on a line of the world, the robot stays on it for a share of the time.

    Args:
        line: the line's name.
        share: of the time.
        distance: the largest distance of the robot's middle from the line that counts, mm.
        least: mm that it has to drive in that time.
    """

    line: Name = "line"
    share: Share = 0.9
    distance: Length = 60.0
    least: Length = 500.0


class Drives(AnyCheck, frozen=True, kw_only=True, tag="drives"):
    """The robot drives a distance, along its way."""

    at_least: Length = 0.0
    at_most: Length | None = None


class EndsAt(AnyCheck, frozen=True, kw_only=True, tag="ends_at"):
    """The robot is at a place when the program ends."""

    x: Place
    y: Place
    radius: Length = 50.0
    heading: Heading | None = None
    angle: Angle = 10.0


class Turns(AnyCheck, frozen=True, kw_only=True, tag="turns"):
    """The robot has turned by so many degrees in all at the end; clockwise is positive."""

    by: Annotated[float, Meta(ge=-36_000, le=36_000)]
    tolerance: Angle = 5.0


class Ends(AnyCheck, frozen=True, kw_only=True, tag="ends"):
    """The program ends by itself, without an error."""

    within: Seconds | None = None


class Prints(AnyCheck, frozen=True, kw_only=True, tag="prints"):
    """The program prints these lines, in this order, with others in between."""

    lines: Annotated[tuple[Pattern, ...], Meta(min_length=1, max_length=50)]


#: Parts of a program that a check can ask for.
Construct = Literal[
    "loop",
    "repeat",
    "forever",
    "if",
    "else",
    "when",
    "function",
    "parameter",
    "return",
    "variable",
    "list",
    "print",
    "input",
]


class Uses(AnyCheck, frozen=True, kw_only=True, tag="uses"):
    """The program has a construct, or calls a skill or a function of its own, so many times."""

    construct: Construct | None = None
    skill: Name | None = None
    function: Name | None = None
    at_least: Count = 1
    at_most: Count | None = None

    def __post_init__(self) -> None:
        if [self.construct, self.skill, self.function].count(None) != 2:
            raise ValueError("lesson-uses-one")


class Size(AnyCheck, frozen=True, kw_only=True, tag="size"):
    """The program has so many statement blocks at most, without the heads of functions."""

    blocks: Annotated[int, Meta(ge=1, le=1000)]


class Expert(AnyCheck, frozen=True, kw_only=True, tag="python"):
    """A function of the lesson's ``checks.py`` says whether it holds; it runs contained."""

    function: Annotated[
        str, Meta(pattern="^[a-z_][a-z0-9_]{0,39}$", description="a function's name in Python")
    ]


#: Checks of what the robot did.
Behaviour = (
    Reaches
    | Happens
    | Never
    | InOrder
    | StaysOnLine
    | Drives
    | EndsAt
    | Turns
    | Ends
    | Prints
    | Expert
)
#: Checks of how the program is built.
Structure = Uses | Size
Check = Behaviour | Structure
