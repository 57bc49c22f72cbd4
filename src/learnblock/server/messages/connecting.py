"""Messages about finding real robots, and about the connection to one of them."""

from typing import Annotated, Literal

from msgspec import Meta, Struct, field

from learnblock.i18n import Phrase
from learnblock.monitor.sensors import Sensor
from learnblock.robots.settings import LONGEST_NAME
from learnblock.server.messages.base import Computer, FromReader, Name, ToPage

# From the page.


class FindRobots(Computer, FromReader, frozen=True):
    """Start or stop looking for real robots; while it looks, `RobotsNearby` follows each change."""

    on: bool


class ConnectRobot(Computer, FromReader, frozen=True):
    """Connect to a robot without a program; the replies are `RobotConnected`.

    Args:
        id: the id of a robot in `RobotsNearby`, or the name of a kind of robot, which is then
            looked for where its settings say.
    """

    id: Annotated[str, Meta(min_length=1, max_length=400)]


class DisconnectRobot(Computer, FromReader, frozen=True):
    """Stop the connected robot, and disconnect."""


class TryRobot(Computer, FromReader, frozen=True):
    """Have the connected robot do something; it halts what it is doing.

    Args:
        action: ``stop``, or one of the `actions` of `RobotConnected`.
    """

    action: Literal["wheels", "face", "lamps", "beep", "distance", "angle", "stop"]


class CorrectRobot(Computer, frozen=True):
    """Correct the settings of the connected robot; the reply is `RobotCorrected`.

    Args:
        distance: how far it drove, mm, when asked to drive 500 mm.
        angle: how far it turned, degrees, when asked to turn by 360 degrees.
        save: whether to save the new settings, and connect again with them.
    """

    distance: Annotated[float, Meta(ge=100, le=2500)] = 500.0
    angle: Annotated[float, Meta(ge=72, le=1800)] = 360.0
    save: bool = False


class NameRobot(Computer, frozen=True):
    """Give a kind of robot a name of the user's choice; an empty name removes it."""

    robot: Name
    name: Annotated[str, Meta(max_length=LONGEST_NAME)]


class UseRobot(Computer, frozen=True):
    """Disconnect, save what connects it, and choose the connected robot for the project, if any."""


class InstallAddOn(Computer, FromReader, frozen=True):
    """Install what a kind of robot needs, which `AddOn` shows; or no longer, if it is under way."""

    robot: Name
    on: bool = True


# To the page.


class NearbyRobot(Struct, frozen=True, omit_defaults=True):
    """A robot that answers.

    Args:
        id: what `ConnectRobot` calls it.
        robot: the kind of robot.
        way: how it is reached.
        place: its address or its device.
    """

    id: str
    robot: str
    way: Literal["wifi", "usb", "bluetooth", "computer"]
    place: str = ""


class AddOn(Struct, frozen=True, omit_defaults=True):
    """The packages that a kind of robot needs, and that are not installed.

    Args:
        command: what installs them, to be typed into a terminal.
        ours: whether `InstallAddOn` may install them: nobody else uses this environment.
        installing: whether they are being installed.
        progress: what the installer said last; empty before its first word.
        problem: why the last attempt failed.
    """

    command: str
    ours: bool = False
    installing: bool = False
    progress: str = ""
    problem: Phrase | None = None


class KnownRobot(Struct, frozen=True, omit_defaults=True):
    """A kind of real robot.

    Args:
        robot: its id.
        name: the name given by the user; empty without one.
        used: whether it was connected on this computer before.
        is_busy: whether a program or another page uses it now.
        add_on: the packages that it lacks; None if it has them.
        looking: whether the first look for it has not ended.
    """

    robot: str
    name: str = ""
    used: bool = False
    is_busy: bool = False
    add_on: AddOn | None = None
    looking: bool = False


class RobotsNearby(ToPage, frozen=True):
    """The real robots.

    Args:
        found: those that answer.
        known: all kinds, those used last first.
    """

    found: tuple[NearbyRobot, ...] = ()
    known: tuple[KnownRobot, ...] = ()


class RobotConnected(ToPage, frozen=True):
    """The page's connection to a robot; sent when it changes.

    Args:
        state: ``lost`` if the robot stopped answering, ``failed`` if it never did.
        id: the id of the robot; empty for ``none``.
        robot: its kind.
        problem: why the connection ended, or why the last action failed.
        doing: the action that is under way; empty if there is none.
        actions: what it can do.
        corrects: whether measurements can correct its settings.
    """

    state: Literal["none", "connecting", "connected", "lost", "failed"]
    id: str = ""
    robot: str = ""
    problem: Phrase | None = None
    doing: str = ""
    actions: tuple[str, ...] = ()
    corrects: bool = False


class RobotValues(ToPage, frozen=True):
    """What the connected robot reports, several times a second while it changes.

    Args:
        sensors: its readings.
        joints: degrees, by key.
        speed: mm/s forward and degrees/s clockwise, as last commanded.
        heading: degrees clockwise by its odometry; None if it has none.
        weak: whether its messages are late or missing.
        quality: the share of its messages that arrive, 0 to 1, if known.
        silence: milliseconds since its last message, if known.
        round_trip: milliseconds from a question to its answer, if known.
        battery: its voltage, V, if it reports it.
        charge: how full the battery is, 0 to 1, estimated from its voltage if need be.
        signal: how strong its radio was when it was found, dBm, if known.
    """

    sensors: tuple[Sensor, ...] = ()
    joints: dict[str, float] = field(default_factory=dict)
    speed: tuple[float, float] | None = None
    heading: float | None = None
    weak: bool = False
    quality: float | None = None
    silence: int | None = None
    round_trip: int | None = None
    battery: float | None = None
    charge: float | None = None
    signal: int | None = None


class Correction(Struct, frozen=True):
    """A setting before and after a correction."""

    setting: str
    before: float
    after: float


class RobotCorrected(ToPage, frozen=True):
    """The corrections that measurements suggest.

    Args:
        corrections: the settings that they change.
        saved: whether they were saved.
        problem: why they can't be.
    """

    corrections: tuple[Correction, ...] = ()
    saved: bool = False
    problem: Phrase | None = None
