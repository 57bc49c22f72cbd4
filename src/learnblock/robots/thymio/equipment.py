"""A Thymio's lamps, loudspeaker and buttons."""

from collections.abc import Iterable, Mapping

from learnblock.devices import Emotion
from learnblock.robots.thymio import units
from learnblock.robots.thymio.link import ThymioLink
from learnblock.robots.thymio.program import LEFT, PLAY, RIGHT, SOUND, TONE, TOP, Event

#: The coloured lamps, by their names in programs.
SLOTS: Mapping[str, Event] = {"Up": TOP, "Left": LEFT, "Right": RIGHT}
#: The colour of all lamps, by emotion.
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
#: The arrow buttons, as the left half of a controller.
ARROWS: Mapping[str, str] = {
    "lUp": "button.forward",
    "lLeft": "button.left",
    "lRight": "button.right",
    "lDown": "button.backward",
}
#: The buttons of a controller that a Thymio does not have.
LACKING = ("rUp", "rLeft", "rRight", "rDown")


class Lamp:
    """A coloured lamp.

    Args:
        link: the link to the robot.
        event: the event that sets its colour.
    """

    def __init__(self, link: ThymioLink, event: Event) -> None:
        self._link, self._event = link, event
        self._shown: tuple[int, ...] | None = None

    def light(self, red: int, green: int, blue: int) -> None:
        """Set its colour, by three values from 0 to 255; nothing is sent if it has it already."""
        self._link.check()
        levels = tuple(map(units.level, (red, green, blue)))
        # A program that sets it a thousand times per second would block the cable.
        if levels != self._shown:
            self._link.tell(self._event, *levels)
            self._shown = levels


def show(lamps: Iterable[Lamp], emotion: str) -> None:
    """Show an emotion as the colour of these lamps."""
    for lamp in lamps:
        lamp.light(*EMOTIONS[emotion])


def tone(link: ThymioLink, hertz: float, milliseconds: float) -> None:
    """Play a tone; 0 milliseconds stops the current one."""
    link.tell(TONE, *units.tone(hertz, milliseconds))


def play(link: ThymioLink, name: str) -> None:
    """Play one of the robot's sounds by name, or a file on its memory card by number.

    Raises:
        DeviceValueError: the robot has no such sound.
    """
    if name.isdecimal():
        link.tell(PLAY, min(int(name), units.LARGEST))
    else:
        link.tell(SOUND, units.sound(name))


def buttons(link: ThymioLink) -> dict[str, bool]:
    """The pressed buttons of a controller."""
    pressed = {button: link.read(variable) == (1,) for button, variable in ARROWS.items()}
    return pressed | dict.fromkeys(LACKING, False)
