"""iRobot's Create 3, by Bluetooth."""

from learnblock.client import skill_sets
from learnblock.devices import DistanceSensors, GroundSensors
from learnblock.robots.irobot import IRobot, messages
from learnblock.robots.irobot.link import PacketLink
from learnblock.robots.irobot.packets import Packet
from learnblock.wheels import Drivetrain

__all__ = ["Robot"]

#: The sides that list each of its seven proximity sensors, from left to right.
_SIDES = {"front": slice(2, 5), "left": slice(0, 2), "right": slice(5, 7)}
#: The cliff sensors of each side, as bits of their event.
_CLIFFS = {"left": 0x0C, "right": 0x03}


class Robot(IRobot, skill_sets.Create3):
    """A Create 3."""

    model = "create3"
    # Four lithium cells.
    battery_range = (13.0, 16.8)
    motors = Drivetrain(track=233.0, maximum_speed=306.0, acceleration=900.0)
    is_root = False
    kinds = ("DistanceSensors", "GroundSensors")

    @classmethod
    def abilities(cls) -> frozenset[str]:
        return frozenset({*(f"DistanceSensors:{side}" for side in _SIDES), "Speaker:tone"})

    def prepare(self, link: PacketLink) -> None:
        self._cliffs = 0
        link.watch((messages.POSITION, messages.PROXIMITY))
        self.add_base(link, messages.create3_pose)
        self.add(DistanceSensors(self._distances))
        self.add(GroundSensors(self._ground))

    def note(self, event: Packet) -> None:
        super().note(event)
        if event[:2] == messages.CLIFF_EVENT:
            self._cliffs = messages.state(event.payload)

    def _distances(self) -> dict[str, list[float]]:
        seen = messages.distances(self.reading(messages.PROXIMITY))
        return {**{side: seen[sensors] for side, sensors in _SIDES.items()}, "back": []}

    def _ground(self) -> dict[str, float | None]:
        self._there.check()
        sides = {side: 0.0 if self._cliffs & bits else 100.0 for side, bits in _CLIFFS.items()}
        return {"left": sides["left"], "central": None, "right": sides["right"]}
