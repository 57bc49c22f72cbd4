"""The goals in a world's file."""

from collections.abc import Iterator
from typing import Annotated, Literal

from msgspec import Meta, Struct

from learnblock.simulator.description_types import (
    HEADING,
    XY,
    Emotion,
    Heading,
    Name,
    Place,
    Seconds,
    TagNumber,
    X,
    Y,
)
from learnblock.simulator.game.description import CollectableKind

GoalName = Annotated[Name, Meta(description="shown on the page")]
Radius = Annotated[float, Meta(ge=10, le=5000)]
Angle = Annotated[float, Meta(ge=1, le=180)]


class AnyGoal(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """What all goals have."""

    name: GoalName
    robot: (
        Annotated[Name, Meta(description="the name of the robot; without it any robot")] | None
    ) = None
    after: (
        Annotated[Name, Meta(description="the name of the goal that has to be reached before")]
        | None
    ) = None
    time_limit: (
        Annotated[Seconds, Meta(description="seconds; after that the goal has failed")] | None
    ) = None
    team: (
        Annotated[Name, Meta(description="the team that it is for; without it any robot")] | None
    ) = None
    wins: Annotated[bool, Meta(description="whether reaching it wins the game and ends it")] = False


class Reach(AnyGoal, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """Bring a robot's middle, or that of an object, into a round region."""

    x: Annotated[Place, X]
    y: Annotated[Place, Y]
    radius: Annotated[Radius, Meta(description="of the region, mm")] = 150.0
    object: (
        Annotated[Name, Meta(description="the object that has to be there instead of a robot")]
        | None
    ) = None
    together: Annotated[bool, Meta(description="whether all robots have to be there at once")] = (
        False
    )
    alone: Annotated[
        bool, Meta(description="whether one robot has to be there while all others are outside")
    ] = False
    name: GoalName = "reach"

    def __post_init__(self) -> None:
        named = self.robot is not None
        if [self.object is not None, self.together, self.alone].count(True) + named > 1:
            raise ValueError("world-reach-choice")


class Follow(AnyGoal, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """Drive along a line."""

    line: Annotated[Name, Meta(description="the line's name")] = "line"
    fraction: Annotated[
        float, Meta(ge=0.01, le=1, description="how much of the line; 1 is all of it, one lap")
    ] = 1.0
    distance: Annotated[
        float,
        Meta(ge=5, le=1000, description="largest distance of a robot's middle from the line, mm"),
    ] = 100.0
    name: GoalName = "follow"


class Visit(AnyGoal, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """Come close to the front of a tag and face it."""

    id: Annotated[TagNumber, Meta(description="the tag's number")]
    distance: Annotated[
        Radius, Meta(description="largest distance from the robot's middle to the tag, mm")
    ] = 350.0
    angle: Annotated[Angle, Meta(description="largest angle off the robot's heading, degrees")] = (
        25.0
    )
    name: GoalName = "visit"


class Tour(AnyGoal, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """Bring a robot's middle to several places in order."""

    points: Annotated[
        tuple[XY, ...], Meta(min_length=2, max_length=100, description="the places, mm")
    ]
    radius: Annotated[Radius, Meta(description="largest distance from each place, mm")] = 50.0
    name: GoalName = "tour"


class Stop(AnyGoal, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """Stand still with a robot's middle in a round region, or end the program there."""

    x: Annotated[Place, X]
    y: Annotated[Place, Y]
    radius: Annotated[Radius, Meta(description="of the region, mm")] = 50.0
    heading: Annotated[Heading, HEADING] | None = None
    angle: Annotated[Angle, Meta(description="largest angle off that heading, degrees")] = 5.0
    seconds: Annotated[Seconds, Meta(description="how long, seconds")] = 1.0
    name: GoalName = "stop"


class Show(AnyGoal, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """Show an emotion, anywhere or in a round region."""

    emotion: Annotated[Emotion, Meta(description="the emotion to show")]
    x: Annotated[Place, X] = 0.0
    y: Annotated[Place, Y] = 0.0
    radius: Annotated[Radius, Meta(description="of the region, mm; without it anywhere")] | None = (
        None
    )
    name: GoalName = "show"


class Avoid(AnyGoal, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """Drive without bumping into anything or leaving the floor; otherwise the goal has failed."""

    distance: Annotated[float, Meta(ge=10, le=100_000, description="how far, mm")] = 2000.0
    name: GoalName = "avoid"


class GameGoal(AnyGoal, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """What all goals of games have."""

    lose_nothing: Annotated[bool, Meta(description="whether losing a life makes it fail")] = False


class Score(GameGoal, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """Have a score."""

    points: Annotated[float, Meta(ge=0.1, le=1_000_000, description="the score to have")]
    together: Annotated[bool, Meta(description="whether the scores of all robots are added up")] = (
        False
    )
    name: GoalName = "score"


class CollectThings(GameGoal, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """Collect things."""

    kind: Annotated[
        CollectableKind | Literal["anything"], Meta(description="what they have to be")
    ] = "anything"
    count: (
        Annotated[int, Meta(ge=1, le=1000, description="how many; without it all there are")] | None
    ) = None
    name: GoalName = "collect"


class Gates(GameGoal, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """Drive through all gates in their order."""

    laps: Annotated[int, Meta(ge=1, le=100, description="how often")] = 1
    name: GoalName = "gates"


class Goals(Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """The goals of robots; checked every 50 ms, and when a robot's program ends."""

    reach: Annotated[tuple[Reach, ...], Meta(max_length=50)] = ()
    follow: Annotated[tuple[Follow, ...], Meta(max_length=50)] = ()
    visit: Annotated[tuple[Visit, ...], Meta(max_length=50)] = ()
    tour: Annotated[tuple[Tour, ...], Meta(max_length=50)] = ()
    stop: Annotated[tuple[Stop, ...], Meta(max_length=50)] = ()
    show: Annotated[tuple[Show, ...], Meta(max_length=50)] = ()
    avoid: Annotated[tuple[Avoid, ...], Meta(max_length=50)] = ()
    score: Annotated[tuple[Score, ...], Meta(max_length=50)] = ()
    collect: Annotated[tuple[CollectThings, ...], Meta(max_length=50)] = ()
    gates: Annotated[tuple[Gates, ...], Meta(max_length=50)] = ()

    def all(self) -> Iterator[tuple[str, int, AnyGoal]]:
        """Each goal with its kind and its place among the goals of this kind."""
        for kind in self.__struct_fields__:
            for index, goal in enumerate(getattr(self, kind)):
                yield kind, index, goal
