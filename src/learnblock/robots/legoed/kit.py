"""The devices of LEGO Education that are one robot, each with a connection of its own."""

import math
import threading
from collections.abc import Callable
from contextlib import ExitStack

from learnblock.closing import Closing
from learnblock.robots.heartbeat import Heartbeat
from learnblock.robots.legoed import messages
from learnblock.robots.legoed.messages import KitReport, Product
from learnblock.robots.legoed.nearby import addresses
from learnblock.robots.legoed.part import KitPart
from learnblock.robots.legoed.settings import Settings
from learnblock.timing import MONOTONIC, SteadyClock

#: Seconds after which the wheels stop by themselves; a command is repeated ten times a second.
HORIZON = 0.4
#: The speed of the Single Motor in %.
ARM_SPEED = 50


# Why: docs/decisions.md, "LEGO Education's messages are the maker's, its connection ours"
class Kit(Closing):
    """A Double Motor, and what else has its connection card.

    No device stops its motors when the computer is gone. So each command to drive ends by itself:
    it turns the wheels by the degrees of `HORIZON`, and is repeated before they have turned so far.

    Args:
        settings: the robot's settings.
        on_base: called with each report of the Double Motor, in the thread of its connection.
        clock: the clock of its periods and limits.

    Raises:
        RobotConnectionError: a device can't be reached; the error says why.
    """

    def __init__(
        self,
        settings: Settings,
        on_base: Callable[[KitReport], None],
        clock: SteadyClock = MONOTONIC,
    ) -> None:
        self._full_speed = settings.full_speed
        self._driving = threading.Lock()
        self._wish = b""
        self._parts: dict[Product, KitPart] = {}
        with ExitStack() as stack:
            for product, address in addresses(settings).items():
                note = on_base if product is Product.DOUBLE_MOTOR else _ignore
                part = KitPart(product, address, settings.patience, note, clock)
                stack.callback(part.close)
                self._parts[product] = part
            self._base = self._parts[Product.DOUBLE_MOTOR]
            self._base.say(messages.brake_and_hurry())
            if Product.SINGLE_MOTOR in self._parts:
                self._parts[Product.SINGLE_MOTOR].say(messages.begin_arm(ARM_SPEED))
            self._heart = Heartbeat(self._beat, clock)
            stack.pop_all()

    @property
    def base(self) -> KitPart:
        """The Double Motor."""
        return self._base

    def has(self, product: Product) -> bool:
        """Whether a device belongs to the robot."""
        return product in self._parts

    def part(self, product: Product) -> KitPart:
        """A device that belongs to the robot."""
        return self._parts[product]

    def drive(self, left: float, right: float) -> None:
        """Turn the wheels until the next command: degrees/s, forward positive."""
        on_the_left, on_the_right = (
            round(100 * speed / self._full_speed) for speed in (left, right)
        )
        fastest = max(abs(on_the_left), abs(on_the_right))
        degrees = math.ceil(fastest / 100 * self._full_speed * HORIZON)
        with self._driving:
            self._wish = messages.drive(on_the_left, on_the_right, degrees) if fastest else b""
            self._base.say(self._wish or messages.stop())

    def check(self) -> None:
        """Check that every device is still there.

        Raises:
            RobotConnectionError: one is not.
        """
        self._heart.check()
        for part in self._parts.values():
            part.check()

    def close(self) -> None:
        """Stop the motors, and close the connections."""
        self._heart.stop()
        self._base.close(messages.stop(), messages.silence())
        for part in self._parts.values():
            part.close()

    def _beat(self) -> None:
        with self._driving:
            if self._wish:
                self._base.say(self._wish)


def _ignore(_: KitReport) -> None:
    """Take a report that is read when it is asked for."""
