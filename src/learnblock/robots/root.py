"""iRobot's Root, by Bluetooth."""

from contextlib import suppress

from learnblock.client import skill_sets
from learnblock.devices import GroundSensors, LightSensor, Pen
from learnblock.errors import LearnBlockError, RobotConnectionError
from learnblock.robots.irobot import IRobot, messages, strip
from learnblock.robots.irobot.link import PacketLink
from learnblock.robots.irobot.packets import Packet
from learnblock.wheels import Drivetrain

__all__ = ["Robot"]

#: Robots with an older protocol don't know where they are.
_KNOWS_ITS_POSE = (1, 2)
#: Seconds for the marker to go up or down, and to go up at the end.
MARKER, LIFTING = 3.0, 1.0
#: The colour sensors of each side, of 32 from left to right; those outside would see a line too
#: late.
_SIDES = {"left": slice(6, 14), "central": slice(14, 18), "right": slice(18, 26)}


class Robot(IRobot, skill_sets.Root):
    """A Root: the Pro has a colour strip and a cliff sensor, the Lite has neither."""

    model = "root"
    # One lithium cell.
    battery_range = (3.4, 4.2)
    motors = Drivetrain(track=103.0, maximum_speed=100.0)
    is_root = True
    kinds = ("GroundSensors", "LightSensor", "Pen")
    #: Whether its marker is down.
    _is_drawing = False

    @classmethod
    def abilities(cls) -> frozenset[str]:
        return frozenset({"GroundSensors:line", "Speaker:tone"})

    def disconnect(self) -> None:
        if self._is_drawing and self._link:
            # Not if the connection is broken.
            with suppress(LearnBlockError):
                self._link.probe(messages.marker(down=False), LIFTING)
        super().disconnect()

    def prepare(self, link: PacketLink) -> None:
        self._is_at_edge = False
        #: What its strip sees; empty until that changes or is asked for.
        self._colours: list[int] = []
        version = messages.protocol(link.ask(messages.versions(messages.MAIN_BOARD)))
        is_placed = version >= _KNOWS_ITS_POSE
        questions = (messages.POSITION, messages.LIGHT) if is_placed else (messages.LIGHT,)
        link.watch(questions)
        self.add_base(link, messages.root_pose if is_placed else None)
        if link.probe(messages.versions(messages.COLOUR_BOARD)) is not None:
            self.add(GroundSensors(self._ground))
        self.add(LightSensor(lambda: messages.brightness(self.reading(messages.LIGHT))))
        # Its colour and width are those of the marker, and nothing wipes the paper.
        self.add(Pen(self._set_pen, lambda *_: None, lambda _: None, lambda: None))

    def note(self, event: Packet) -> None:
        super().note(event)
        if event[:2] == messages.COLOUR_EVENT:
            self._colours = messages.colours(event.payload)
        elif event[:2] == messages.CLIFF_EVENT:
            self._is_at_edge = bool(messages.state(event.payload))

    def _set_pen(self, down: bool) -> None:  # noqa: FBT001 - a pen is either down or up
        self._is_drawing = down
        if self._there.probe(messages.marker(down=down), MARKER) is None:
            raise RobotConnectionError("irobot-marker-stuck")

    def _ground(self) -> dict[str, float | None]:
        self._there.check()
        if not self._colours:
            seen = strip.first_look(self._there)
            # What it has reported meanwhile is newer.
            self._colours = self._colours or seen
        return {side: self._brightness(sensors) for side, sensors in _SIDES.items()}

    def _brightness(self, sensors: slice) -> float:
        if self._is_at_edge:
            return 0.0
        levels = [messages.brightness_of(colour) for colour in self._colours[sensors]]
        return round(sum(levels) / len(levels), 1)
