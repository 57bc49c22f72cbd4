"""The devices that act: wheels, joints, faces, lights and sounds."""

from collections.abc import Callable
from enum import StrEnum
from typing import TYPE_CHECKING

from learnblock.devices.device import Device
from learnblock.devices.values import clamped, number, whole
from learnblock.errors import DeviceValueError, nearest
from learnblock.wheels import Drivetrain

if TYPE_CHECKING:
    from learnblock.devices.sensors import Frame

Pose = tuple[float, float, float]

#: The longest text on a screen, in characters.
LONGEST_TEXT = 100


class Emotion(StrEnum):
    """The emotions that a robot's face can show."""

    FEAR = "fear"
    SURPRISE = "surprise"
    ANGER = "anger"
    SADNESS = "sadness"
    DISGUST = "disgust"
    JOY = "joy"
    NEUTRAL = "neutral"
    NONE = "none"


class Base(Device):
    """The wheels or other drive of the robot.

    Args:
        move: `move(adv, rot)` with adv in mm/s, forward positive, and rot in degrees/s, clockwise
            positive; both apply until the next command.
        read: returns the pose (x mm, y mm, heading in degrees) by odometry; without it, the client
            that gets the base reckons the pose from the commands.
        drivetrain: what its wheels can do, if known; a command beyond it is reckoned with what
            they do.
    """

    def __init__(
        self,
        move: Callable[[float, float], None],
        read: Callable[[], Pose] | None = None,
        drivetrain: Drivetrain | None = None,
    ) -> None:
        super().__init__(move=move, read=read)
        self.drivetrain = drivetrain
        #: Whether it measures its pose, rather than have it reckoned.
        self.has_odometry = read is not None
        #: The last command (adv, rot), as far as the wheels can follow it.
        self.speed: tuple[float, float] = (0.0, 0.0)

    def pose(self) -> Pose:
        """(x mm, y mm, heading in degrees from -180 to 180); y to the left of heading 0."""
        pose: Pose = self.functions["read"]()
        return pose

    def move(self, adv: float, rot: float) -> None:
        """Drive at `adv` mm/s, turning at `rot` degrees/s clockwise, until the next command."""
        speed = number("adv", adv), number("rot", rot)
        self.functions["move"](*speed)
        self.speed = self.reachable(*speed)

    def reachable(self, adv: float, rot: float = 0.0) -> tuple[float, float]:
        """The speed (adv, rot) at which the robot moves after a command, as far as is known."""
        return self.drivetrain.reachable(adv, rot) if self.drivetrain else (adv, rot)

    def stop(self) -> None:
        self.move(0, 0)


class JointMotor(Device):
    """A joint that moves to an angle, under a key such as ``CAMERA`` or ``ARM``.

    Args:
        move: `move(degrees)` starts moving; for a camera or an arm, 0 is level and up is positive.
        read: returns the current angle of the joint; None if it cannot be read.
    """

    def __init__(
        self, move: Callable[[float], None], read: Callable[[], float] | None = None
    ) -> None:
        super().__init__(move=move, read=read)
        #: The last command, in degrees; None before the first one.
        self.angle: float | None = None

    def move(self, degrees: float) -> None:
        self.angle = number("degrees", degrees)
        self.functions["move"](self.angle)

    def move_by(self, degrees: float) -> None:
        """Move from the angle of the last command, or before any from where the joint is."""
        start = self.angle
        if start is None:
            start = float(self.functions["read"]()) if "read" in self.functions else 0.0
        self.move(start + number("degrees", degrees))


class Display(Device):
    """A face: a screen or lights that show emotions.

    Args:
        show_emotion: shows the emotion with this name.
        show_image: shows a frame; None if the face cannot show images.
    """

    def __init__(
        self,
        show_emotion: Callable[[str], None],
        show_image: "Callable[[Frame], None] | None" = None,
    ) -> None:
        super().__init__(show_emotion=show_emotion, show_image=show_image)
        #: The last emotion shown.
        self.emotion = Emotion.NONE

    def show_emotion(self, emotion: Emotion | str) -> None:
        """Show an emotion or the emotion with this name."""
        expression = _emotion(emotion)
        self.functions["show_emotion"](expression.value)
        self.emotion = expression

    def show_image(self, frame: "Frame") -> bool:
        """Show a picture; return False if the face can only show emotions."""
        return self._do("show_image", frame)


class Screen(Device):
    """A screen that shows text.

    Args:
        show_text: shows a text instead of what was there, and an empty one clears the screen; None
            if the screen cannot show text.
    """

    def __init__(self, show_text: Callable[[str], None] | None = None) -> None:
        super().__init__(show_text=show_text)
        #: The text that was shown last.
        self.text = ""

    def show_text(self, text: str) -> bool:
        """Show a text, cut to `LONGEST_TEXT` characters; return False if the screen cannot."""
        self.text = text if len(text) <= LONGEST_TEXT else f"{text[: LONGEST_TEXT - 1]}…"
        return self._do("show_text", self.text)


class Pen(Device):
    """A pen that draws on the floor where the robot drives."""

    def __init__(
        self,
        set: Callable[[bool], None],  # noqa: A002 - as for an LED
        set_color: Callable[[int, int, int], None],
        set_width: Callable[[float], None],
        clear: Callable[[], None],
    ) -> None:
        super().__init__(set=set, set_color=set_color, set_width=set_width, clear=clear)

    def set(self, *, down: bool) -> None:
        """Put the pen down, or lift it."""
        self.functions["set"](bool(down))

    def set_color(self, red: int, green: int, blue: int) -> None:
        """Draw in another colour; red, green and blue from 0 to 255."""
        self.functions["set_color"](
            clamped("red", red, 255), clamped("green", green, 255), clamped("blue", blue, 255)
        )

    def set_width(self, width: float) -> None:
        """Draw strokes of another width, mm."""
        self.functions["set_width"](number("width", width))

    def clear(self) -> None:
        """Remove what it has drawn."""
        self.functions["clear"]()


class Led(Device):
    """An LED that is on or off; its key names its position on the robot."""

    def __init__(self, set: Callable[[bool], None]) -> None:  # noqa: A002 - the usual word
        super().__init__(set=set)

    def set(self, on: bool) -> None:  # noqa: FBT001 - an LED is either on or off
        self.functions["set"](bool(on))


class RGBLed(Device):
    """A lamp with a colour; red, green and blue from 0 to 255. Its key names its position."""

    def __init__(self, set_color: Callable[[int, int, int], None]) -> None:
        super().__init__(set_color=set_color)

    def set_color(self, red: int, green: int, blue: int) -> None:
        self.functions["set_color"](
            clamped("red", red, 255), clamped("green", green, 255), clamped("blue", blue, 255)
        )


class Speaker(Device):
    """A loudspeaker: `say(text)`, `play(name)` and `tone(hertz, milliseconds)`, if supported."""

    def __init__(
        self,
        say: Callable[[str], None] | None = None,
        play: Callable[[str], None] | None = None,
        tone: Callable[[float, float], None] | None = None,
    ) -> None:
        super().__init__(say=say, play=play, tone=tone)

    def say(self, text: str) -> bool:
        return self._do("say", str(text))

    def play(self, name: str) -> bool:
        return self._do("play", str(name))

    def tone(self, hertz: float, milliseconds: float) -> bool:
        return self._do("tone", number("hertz", hertz), number("milliseconds", milliseconds))


class Matrix(Device):
    """A matrix of 8 by 16 lamps; brightness from 0 to 7, column from 0 to 15."""

    def __init__(
        self,
        icon: Callable[[str, int], None],
        number: Callable[[float, int], None],
        text: Callable[[str, int, int], None],
    ) -> None:
        super().__init__(icon=icon, number=number, text=text)

    def icon(self, name: str, brightness: int) -> None:
        self.functions["icon"](str(name), clamped("brightness", brightness, 7))

    def number(self, value: float, brightness: int) -> None:
        self.functions["number"](number("value", value), clamped("brightness", brightness, 7))

    def text(self, text: str, brightness: int, column: int) -> None:
        self.functions["text"](
            str(text), clamped("brightness", brightness, 7), clamped("column", column, 15)
        )


class MP3(Device):
    """A music player: folders of numbered songs; volume from 0 to 100."""

    def __init__(
        self,
        select: Callable[[int, int], None],
        action: Callable[[str], None],
        volume: Callable[[int], None],
        equalizer: Callable[[str], None],
        loop: Callable[[str], None],
    ) -> None:
        super().__init__(
            select=select, action=action, volume=volume, equalizer=equalizer, loop=loop
        )

    def select(self, folder: int, song: int) -> bool:
        return self._do("select", whole("folder", folder), whole("song", song))

    def action(self, action: str) -> bool:
        return self._do("action", str(action))

    def volume(self, volume: int) -> bool:
        return self._do("volume", clamped("volume", volume, 100))

    def equalizer(self, mode: str) -> bool:
        return self._do("equalizer", str(mode))

    def loop(self, mode: str) -> bool:
        return self._do("loop", str(mode))


class Animator(Device):
    """Plays the built-in behaviours of a robot by name, such as Cozmo's ``Dances``."""

    def __init__(self, play: Callable[[str], None]) -> None:
        super().__init__(play=play)

    def play(self, name: str) -> None:
        self.functions["play"](str(name))


def _emotion(emotion: str) -> Emotion:
    if type(emotion) is Emotion:
        return emotion
    try:
        return Emotion(emotion)
    except ValueError:
        names = tuple(member.value for member in Emotion)
        suggestion = nearest(str(emotion), names)
        if suggestion is None:
            raise DeviceValueError(
                "device-unknown-emotion", emotion=repr(emotion), known=names
            ) from None
        raise DeviceValueError(
            "device-unknown-emotion-like", emotion=repr(emotion), suggestion=suggestion
        ) from None
