"""The commands to the wheels: which movement each of them makes, and in which skill."""

from bisect import bisect_left

from learnblock.why.history import EventHistory
from learnblock.why.slices import Slices
from learnblock.why.wording import STAND, movement


class WheelCommands:
    """The commands to the wheels of one run; each is the index of its event.

    Args:
        slices: of the run.
    """

    def __init__(self, slices: Slices) -> None:
        self._history: EventHistory = slices.history
        #: All of them, in order.
        self.all = slices.of_base

    def last(self, until: int) -> int:
        """The last one up to an event, which is in force there; -1 if there was none."""
        return self._history.last_of(self.all, until)

    def speeds(self, command: int) -> tuple[float, float]:
        """The mm/s forward and the degrees/s to the right that a command sets."""
        advance, rotation = self._history.arguments(command)[:2]
        return advance, rotation

    def movement(self, command: int) -> str:
        """The name of the movement that a command makes."""
        return movement(*self.speeds(command))

    def names(self, command: int) -> tuple[str, ...]:
        """The names of a movement; a question need not tell turning on the spot from a curve."""
        name = self.movement(command)
        return (name, name.replace("curve", "spin"), *(("",) if "-" in name else ()))

    def is_main(self, command: int) -> bool:
        """Whether a command is the purpose of its skill: a turn begins and ends with a stop."""
        use = self._history.own_use(command)
        if use is None or self.movement(command) != STAND:
            return True
        end = use.ended if use.ended >= 0 else len(self._history.events)
        own = self.all[bisect_left(self.all, use.begun) : bisect_left(self.all, end)]
        return all(self.movement(other) == STAND for other in own)

    def first_alike(self, command: int) -> int:
        """The first of the commands of one skill that made the same movement without a break."""
        use, name = self._history.own_use(command), self.movement(command)
        for index in reversed(self.all[: bisect_left(self.all, command)]):
            is_same_use = use is not None and self._history.own_use(index) is use
            if not is_same_use or self.movement(index) != name:
                return command
            command = index
        return command
