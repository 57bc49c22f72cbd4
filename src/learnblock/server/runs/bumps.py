"""The bumps of a robot that are worth a line: not each touch of a wall that it slides along."""

import math
from collections.abc import Iterator, Sequence

from learnblock.runtime.trace import Collision
from learnblock.server import messages
from learnblock.why.wording import thing_phrase

#: Seconds of the robot's time without a touch after which a thing counts as bumped into again.
APART = 1.0


class Bumps:
    """What a robot has bumped into in a run."""

    def __init__(self) -> None:
        self._seen = 0
        #: When it last touched each thing, in seconds of the robot's time.
        self._touched: dict[str, float] = {}

    def news(self, collisions: Sequence[Collision]) -> Iterator[messages.Bumped]:
        """The bumps since the last call.

        Args:
            collisions: all of the run so far.
        """
        new, self._seen = collisions[self._seen :], len(collisions)
        for one in new:
            before, self._touched[one.thing] = self._touched.get(one.thing, -math.inf), one.time
            if one.time - before >= APART:
                yield messages.Bumped(one.time, thing_phrase(one.thing))
