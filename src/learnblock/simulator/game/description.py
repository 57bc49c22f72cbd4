"""The things of games in a world's file: what is collected, entered, passed and pressed."""

from typing import Annotated, Literal

from msgspec import Meta, Struct

from learnblock.simulator.colours import Colour
from learnblock.simulator.description_types import (
    HEADING,
    XY,
    Heading,
    Name,
    ObjectHeight,
    Place,
    Seconds,
    Side,
    X,
    Y,
)

CollectableKind = Literal[
    "star", "coin", "gem", "heart", "cherry", "battery", "key", "flag", "bug", "ghost"
]
#: What becomes of the game: nothing, or it is won or lost.
Verdict = Literal["no", "win", "lose"]
TimeUp = Literal["lose", "win", "program"]
ZoneMoment = Literal["entered", "left"]

Points = Annotated[float, Meta(ge=-1000, le=1000)]
Lives = Annotated[int, Meta(ge=-9, le=9)]
Radius = Annotated[float, Meta(ge=10, le=2000)]
SCORE = Meta(description="added to the score; with 0, the program decides what it counts")
LIVES = Meta(description="lives that are won, or lost if negative")
NAME = Meta(description="for messages and events")


class GameRules(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """What holds for the whole game; it ends when it is won or lost, and so do its programs."""

    lives: (
        Annotated[int, Meta(ge=1, le=99, description="of each robot; without any left it is out")]
        | None
    ) = None
    countdown: Annotated[Seconds, Meta(description="seconds from the start")] | None = None
    time_up: Annotated[
        TimeUp, Meta(description="what the end of the countdown means; program: nothing by itself")
    ] = "lose"
    goals_win: Annotated[
        bool, Meta(description="whether the game is won by all goals, and lost by a missed one")
    ] = True


class Team(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """Robots that play together; a goal may be for one team."""

    name: Annotated[Name, Meta(description="shown on the page")]
    colour: Annotated[Colour, Meta(description="shown beside its name, its robots and its goals")]
    robots: Annotated[
        tuple[Name, ...],
        Meta(max_length=30, description="the names of the starts of its robots"),
    ] = ()


class Moving(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """How a thing moves: along a path, or at random around its place, as the seed says."""

    x: Annotated[Place, X]
    y: Annotated[Place, Y]
    path: Annotated[
        tuple[XY, ...], Meta(max_length=50, description="where it goes from its place, mm")
    ] = ()
    closed: Annotated[
        bool, Meta(description="whether it goes straight from the end of its path to its place")
    ] = False
    wander: Annotated[
        float,
        Meta(ge=0, le=2000, description="instead of a path: how far east and north it goes, mm"),
    ] = 0.0
    speed: Annotated[float, Meta(ge=1, le=1000, description="mm/s")] = 100.0

    def __post_init__(self) -> None:
        if self.path and self.wander:
            raise ValueError("world-path-or-wander")


class Collectable(Moving, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """A thing that a robot collects by driving over it; sensors and cameras don't notice it."""

    kind: Annotated[CollectableKind, Meta(description="what it is")]
    radius: Annotated[float, Meta(ge=5, le=500, description="mm")] = 40.0
    score: Annotated[Points, SCORE] = 0.0
    lives: Annotated[Lives, LIVES] = 0
    returns_after: (
        Annotated[Seconds, Meta(description="seconds after which it is there again; or never")]
        | None
    ) = None


class Zone(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """A round area on the floor that counts when a robot's middle, or an object, enters it."""

    x: Annotated[Place, X]
    y: Annotated[Place, Y]
    radius: Annotated[Radius, Meta(description="mm")] = 150.0
    score: Annotated[Points, Meta(description="added to the score")] = 0.0
    lives: Annotated[Lives, LIVES] = 0
    ends: Annotated[Verdict, Meta(description="whether it ends the game, won or lost")] = "no"
    again: Annotated[bool, Meta(description="whether it counts each time, not only once")] = True
    when: Annotated[ZoneMoment, Meta(description="when it counts")] = "entered"
    object: (
        Annotated[Name, Meta(description="the object that has to do so instead of a robot")] | None
    ) = None
    robot: (
        Annotated[
            Name, Meta(description="the robot that it counts for; or the one that is nearest")
        ]
        | None
    ) = None
    returns: Annotated[
        bool, Meta(description="whether the object goes back to where it was at first")
    ] = False
    colour: Annotated[Colour, Meta(description="of the area")] = "orange"
    name: Annotated[Name, NAME] = "zone"


class RaceGate(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """A gate on the floor; gates count when a robot drives through them in their order."""

    x: Annotated[Place, X]
    y: Annotated[Place, Y]
    heading: Annotated[
        Heading, Meta(description="direction in which it is passed, degrees clockwise; 0 is east")
    ] = 0.0
    width: Annotated[float, Meta(ge=50, le=5000, description="mm")] = 400.0
    score: Annotated[Points, Meta(description="added to the score")] = 0.0
    name: Annotated[Name, NAME] = "gate"


class Mover(Moving, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """A solid thing that moves by itself, and that nothing stops."""

    radius: Annotated[float, Meta(ge=5, le=500, description="mm")] = 60.0
    height: Annotated[ObjectHeight, Meta(description="mm")] = 120.0
    score: Annotated[Points, Meta(description="added to the score of a robot that it touches")] = (
        0.0
    )
    lives: Annotated[
        Lives, Meta(description="lives that a robot gains or loses by touching it")
    ] = 0
    colour: Annotated[Colour, Meta(description="of its side")] = "purple"
    name: Annotated[Name, NAME] = "mover"


class Door(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """A wall that is open while a switch says so."""

    x: Annotated[Place, X]
    y: Annotated[Place, Y]
    heading: Annotated[Heading, HEADING] = 0.0
    length: Annotated[Side, Meta(description="along its heading, mm")] = 300.0
    width: Annotated[Side, Meta(description="across its heading, mm")] = 20.0
    height: Annotated[ObjectHeight, Meta(description="mm")] = 100.0
    colour: Annotated[Colour, Meta(description="of its sides")] = "red"
    name: Annotated[Name, NAME] = "door"


class Switch(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """A plate on the floor that opens doors while a robot or an object with a mass is on it."""

    x: Annotated[Place, X]
    y: Annotated[Place, Y]
    radius: Annotated[Radius, Meta(description="mm")] = 80.0
    door: Annotated[Name, Meta(description="the name of the doors that it opens")] = "door"
    seconds: (
        Annotated[
            float,
            Meta(
                ge=0,
                le=3600,
                description="how long they stay open after it is left; without it for ever",
            ),
        ]
        | None
    ) = None
    name: Annotated[Name, NAME] = "switch"
