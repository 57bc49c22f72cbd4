"""The game of the child's robot, which its host keeps."""

from collections.abc import Iterable

from learnblock.client.clock import Clock
from learnblock.runtime.messages import AskGame, ChangeGame, CollectNews
from learnblock.runtime.wire import Wire
from learnblock.scores import Change, GameResult, Tally


class HostsPlay:
    """A game that is kept at the other end of the wire.

    Args:
        wire: the wire to the host.
        clock: the robot's time.
    """

    #: The host ends the program of a game that has ended.
    result: GameResult | None = None

    def __init__(self, wire: Wire, clock: Clock) -> None:
        self._wire = wire
        self._clock = clock
        self._instant: int | None = None

    def standing(self) -> Tally:
        """The player's score and lives, and the time that is left."""
        return Tally(*self._wire.ask(AskGame()))

    def change(self, change: Change, amount: float) -> None:
        """Do what the program has said; where no time passes, with the next request."""
        (self._wire.note if self._wire.lockstep else self._wire.send)(ChangeGame(change, amount))

    def collect(self) -> Iterable[str]:
        """What has arrived; within one instant of a simulated world nothing new arrives."""
        instant = self._clock.instant
        if instant is not None and instant == self._instant:
            return ()
        self._instant = instant
        news: list[str] = self._wire.ask(CollectNews())
        return news
