"""The monitor of a robot: its interface to the page, the same for every robot.

Its values are structs, which the messages to the page contain or extend.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum
from typing import Annotated, Any, Literal, Protocol

from msgspec import Meta, Struct, field

from learnblock.devices import Pose
from learnblock.monitor.sensors import Sensor

#: The contents of a world's file and of a robot's, as plain values: the page has their types, and
#: `read_world` reports each mistake in a world that the page has edited.
WorldValues = Annotated[dict[str, Any], Meta(extra={"values_of": "WorldFile"})]
RobotLook = Annotated[dict[str, Any], Meta(extra={"values_of": "RobotDescription"})]
#: For each painted line, the corner points of its centre line, in mm.
Lines = tuple[tuple[tuple[float, float], ...], ...]


class LinkState(StrEnum):
    """The link to a robot."""

    #: A simulated robot needs no link.
    SIMULATED = "simulated"
    #: No program is connected to it.
    DISCONNECTED = "disconnected"
    CONNECTED = "connected"
    #: Messages are missing or late.
    WEAK = "weak"
    #: The link broke while a program was running.
    LOST = "lost"


class Link(Struct, frozen=True):
    """The link to a robot; None if the robot does not report a value.

    Args:
        state: the state, if known.
        battery: the battery's voltage, V.
        quality: the share of the robot's messages that arrive, 0 to 1.
    """

    state: LinkState
    battery: float | None = None
    quality: float | None = None


class Scene(Struct, frozen=True):
    """The unchanging parts of a world, for drawing it.

    Args:
        name: the world's name; empty for the plain floor under a real robot.
        world: the contents of the world's file (`WorldFile`).
        lines: for each painted line, the corner points of its centre line, in mm.
        robots: name and description of each robot (`RobotDescription`), ours first.
        cameras: the keys of our robot's cameras.
        start: (x mm, y mm, heading in degrees) where the next run starts; None for a real robot.
        variant: the number of the world's variant; 0 is the world as it is drawn.
        real: whether our robot is a real one, which cannot be placed with a pointer.
    """

    name: str
    world: WorldValues
    lines: Lines
    robots: tuple[tuple[str, RobotLook], ...]
    cameras: tuple[str, ...] = ()
    start: Pose | None = None
    variant: int = 0
    real: bool = False


class Robot(Struct, frozen=True, omit_defaults=True):
    """The current state of a robot.

    Args:
        name: its name in its world.
        x: mm east.
        y: mm north.
        heading: degrees clockwise, 0 faces east.
        located: whether x, y and heading are known; otherwise it is drawn there. See `located`.
        joints: degrees, by key.
        leds: red, green and blue, 0 to 255, by key.
        emotion: the emotion it shows; ``none`` if it shows none.
        speed: (forward in mm/s, clockwise in degrees/s) as last commanded; None if unknown.
        text: the text on its screen, or beside it in a world; empty if there is none.
    """

    name: str
    x: float
    y: float
    heading: float
    located: bool = True
    joints: dict[str, float] = field(default_factory=dict)
    leds: dict[str, tuple[int, int, int]] = field(default_factory=dict)
    emotion: str = "none"
    speed: tuple[float, float] | None = None
    text: str = ""

    @property
    def pose(self) -> Pose | None:
        """(x mm, y mm, heading in degrees); None if unknown."""
        return (self.x, self.y, self.heading) if self.located else None


def located(pose: Pose | None) -> tuple[float, float, float, bool]:
    """The place of a `Robot`; one whose pose is unknown is drawn in the middle."""
    return (*(pose or (0.0, 0.0, 0.0)), pose is not None)


class GoalNow(Struct, frozen=True, omit_defaults=True):
    """A goal of the world, when it was reached or failed, s, and the team that it is for."""

    name: str
    sort: str
    state: Literal["open", "reached", "failed"]
    time: float | None
    team: str = ""


class PlayerNow(Struct, frozen=True, omit_defaults=True):
    """A robot that plays: its name, its score, its lives or None, and its team or ""."""

    name: str
    score: float
    lives: int | None
    team: str = ""


class GameNow(Struct, frozen=True, omit_defaults=True):
    """The current state of a world's game.

    Args:
        players: the robots that play.
        time_left: seconds of the countdown; None without one.
        things: (x mm, y mm) of each collectable, in the order of the world's description; None
            where it has been collected.
        doors: whether each door is open.
        won: whether the game has been won; None while it goes on.
        reason: why it has ended, or what ended it.
        winner: the robot that has won it alone; "" for all of them.
        team: the team that has won it; "" for none.
        counts: whether there is a score, lives or a countdown.
    """

    players: tuple[PlayerNow, ...]
    time_left: float | None = None
    things: tuple[tuple[float, float] | None, ...] = ()
    doors: tuple[bool, ...] = ()
    won: bool | None = None
    reason: str = ""
    winner: str = ""
    team: str = ""
    counts: bool = True


class Seen(Struct, frozen=True, omit_defaults=True):
    """A finding of perception in a camera's picture.

    Args:
        sort: the kind of finding.
        label: the tag's number, the emotion of the face (empty if the program didn't ask), the
            line's colour and side, or the object's colour.
        corners: (column, row) in pixels.
    """

    sort: Literal["tag", "face", "line", "object"]
    label: str
    corners: tuple[tuple[float, float], ...]


@dataclass(frozen=True, slots=True)
class Picture:
    """A picture with its findings.

    Args:
        jpeg: the contents of the file.
        width: in pixels.
        height: in pixels.
        time: the robot's time in s.
        seen: the findings.
    """

    jpeg: bytes
    width: int
    height: int
    time: float
    seen: tuple[Seen, ...]


class State(Struct, frozen=True):
    """The current state of a world.

    Args:
        time: seconds of the robot's time.
        robots: ours first.
        pushed: (x, y, heading) of movable objects, in the order of the world's description: boxes
            with a mass first, then cylinders, and what moves by itself.
        sensors: the readings of our robot.
        goals: the world's goals.
        game: its game; None if the world and its programs have none.
    """

    time: float
    robots: tuple[Robot, ...]
    pushed: tuple[Pose, ...] = ()
    sensors: tuple[Sensor, ...] = ()
    goals: tuple[GoalNow, ...] = ()
    game: GameNow | None = None


# Why: docs/decisions.md, "The page watches through a monitor"
class Monitor(Protocol):
    """The page's view of a robot, whether or not a program runs.

    Watching does not affect the program: its readings, frames and trace stay the same. All
    methods may be called from any thread.
    """

    @property
    def start(self) -> Pose | None:
        """The pose where the user placed the robot, and the next run starts."""

    def scene(self) -> Scene:
        """The unchanging parts of its world."""

    def state(self) -> State:
        """Its current state."""

    def found(self) -> tuple[Seen, ...] | None:
        """What the program's own questions have found last in the camera's picture.

        None if it has asked nothing.
        """

    def link(self) -> Link:
        """Its link."""

    def camera(self) -> Picture | None:
        """Its camera's newest picture, with the findings of perception.

        None without a camera or before its first picture. While nothing changes, the picture is
        the same object.
        """

    def sounds(self) -> "Sequence[Sound]":
        """The sounds that the page should play, since the last call."""

    def strokes(self) -> "Sequence[Stroke]":
        """The drawing on the floor. Strokes only grow, and those that have ended stay the same."""

    def place(self, x: float, y: float, heading: float) -> None:
        """Place the robot elsewhere (mm, mm, degrees); the next run starts there.

        Raises:
            LearnBlockError: it is a real robot.
        """

    def handle(self, how: str) -> None:
        """Shake or tilt the robot, also while a program runs.

        Args:
            how: ``shake``, ``level``, or the lower side: ``front``, ``back``, ``left``, ``right``.

        Raises:
            LearnBlockError: it is a real robot.
        """

    def drive(self, advance: float, rotation: float) -> None:
        """Drive by hand; the robot stops half a second after the last call.

        Args:
            advance: fraction of the robot's top speed, -1 to 1, forward positive.
            rotation: fraction of its top speed, -1 to 1, clockwise positive.

        Raises:
            LearnBlockError: a program drives the robot, or it is a real robot.
        """

    def close(self) -> None:
        """Stop watching; a robot driven by hand stops. Calling it twice is harmless."""


class Sound(Protocol):
    """An audible command to a robot, such as ("Speaker", "say", ("hello",))."""

    @property
    def device(self) -> str: ...

    @property
    def action(self) -> str: ...

    @property
    def values(self) -> tuple[Any, ...]: ...


class Stroke(Protocol):
    """A line drawn on the floor; points are only added to it, at the end."""

    @property
    def colour(self) -> tuple[int, int, int]:
        """Red, green and blue, 0 to 255."""

    @property
    def width(self) -> float:
        """The width in mm."""

    @property
    def points(self) -> Sequence[tuple[float, float]]:
        """Places in mm."""
