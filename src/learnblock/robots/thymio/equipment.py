"""What a Thymio's lamps, loudspeaker and buttons are told and read through a link."""

from collections.abc import Iterable, Mapping

from learnblock.devices import Emotion
from learnblock.robots.thymio import units
from learnblock.robots.thymio.link import Link
from learnblock.robots.thymio.program import LEFT, PLAY, RIGHT, SOUND, TONE, TOP, Event

#: Its coloured lamps, by the slots that programs use.
SLOTS: Mapping[str, Event] = {"Up": TOP, "Left": LEFT, "Right": RIGHT}
#: The colour of all of them for each emotion.
EMOTIONS: Mapping[str, tuple[int, int, int]] = {
    Emotion.JOY: (0, 255, 0),
    Emotion.SADNESS: (0, 0, 255),
    Emotion.SURPRISE: (255, 166, 0),
    Emotion.DISGUST: (0, 162, 0),
    Emotion.ANGER: (255, 0, 0),
    Emotion.FEAR: (124, 0, 255),
    Emotion.NEUTRAL: (0, 0, 0),
    Emotion.NONE: (0, 0, 0),
}
#: Its arrows as those of a controller's left half.
ARROWS: Mapping[str, str] = {
    "lUp": "button.forward",
    "lLeft": "button.left",
    "lRight": "button.right",
    "lDown": "button.backward",
}
#: What a controller has and a Thymio lacks.
LACKING = ("rUp", "rLeft", "rRight", "rDown")


class Lamp:
    """One of its coloured lamps.

    Args:
        link: to the robot.
        event: by which the robot's program lights it.
    """

    def __init__(self, link: Link, event: Event) -> None:
        self._link, self._event = link, event
        self._shown: tuple[int, ...] | None = None

    def light(self, red: int, green: int, blue: int) -> None:
        """Give it a colour, each part 0 to 255; nothing is sent when it has that already."""
        self._link.check()
        levels = tuple(map(units.level, (red, green, blue)))
        # A program that asks a thousand times a second would keep the cable from all else.
        if levels != self._shown:
            self._link.tell(self._event, *levels)
            self._shown = levels


def show(lamps: Iterable[Lamp], emotion: str) -> None:
    """Show an emotion as the colour of these lamps."""
    for lamp in lamps:
        lamp.light(*EMOTIONS[emotion])


def tone(link: Link, hertz: float, milliseconds: float) -> None:
    """Sound a tone; 0 milliseconds end the present one."""
    link.tell(TONE, *units.tone(hertz, milliseconds))


def play(link: Link, name: str) -> None:
    """Play one of the robot's sounds by its name, or a file of its memory card by its number.

    Raises:
        DeviceValueError: it has no such sound.
    """
    if name.isdecimal():
        link.tell(PLAY, min(int(name), units.LARGEST))
    else:
        link.tell(SOUND, units.sound(name))


def buttons(link: Link) -> dict[str, bool]:
    """Which of a controller's buttons are pressed."""
    pressed = {button: link.read(variable) == (1,) for button, variable in ARROWS.items()}
    return pressed | dict.fromkeys(LACKING, False)
