"""The game that a robot plays: its score, its lives, and what it has collected."""

from collections.abc import Callable, Iterable
from contextlib import AbstractContextManager
from typing import Protocol

from learnblock.client.mailbox import Mailbox
from learnblock.client.observers import Witness
from learnblock.scores import TIME_UP, Change, GameResult, Scores, Tally

#: The only player of a game without a world.
_ALONE = "robot"


class Play(Protocol):
    """Where a game is kept, for one of its players."""

    @property
    def result(self) -> GameResult | None:
        """How the game ended; None while it goes on."""

    def standing(self) -> Tally:
        """The player's score and lives, and the time that is left."""

    def change(self, change: Change, amount: float) -> None:
        """Do what the player's program has said."""

    def collect(self) -> Iterable[str]:
        """Take the news for the player's program, oldest first."""


class OwnPlay:
    """The game of a robot that has no world, in which a person collects things by hand.

    Args:
        time: returns the robot's time in seconds.
    """

    def __init__(self, time: Callable[[], float]) -> None:
        self._time = time
        #: Receives the events of the game.
        self.witness: Witness | None = None
        self._scores = Scores()

    @property
    def result(self) -> GameResult | None:
        return self._scores.result

    @property
    def seen(self) -> Tally | None:
        """Score, lives and time for the page; None while the program has counted nothing."""
        return self._scores.standing(_ALONE, self._time()) if self._scores.in_use else None

    def standing(self) -> Tally:
        self._look()
        return self._scores.standing(_ALONE, self._time())

    def change(self, change: Change, amount: float) -> None:
        self._look()
        self._scores.change(_ALONE, change, amount, self._time())
        self._tell()

    def collect(self) -> Iterable[str]:
        self._look()
        return self._scores.collect(_ALONE)

    def _look(self) -> None:
        self._scores.join(_ALONE)
        self._scores.look(self._time())
        self._tell()

    def _tell(self) -> None:
        for event in self._scores.take_events():
            if self.witness:
                self.witness.game(event)


class Game:
    """A robot's game, as its program sees it.

    Args:
        play: where the game is kept.
    """

    def __init__(self, play: Play) -> None:
        self.play = play
        self._news = Mailbox(collect=lambda: ((news, None) for news in play.collect()))

    @property
    def standing(self) -> Tally:
        """Score, lives and the time that is left."""
        return Tally(*self.play.standing())

    def change(self, change: Change, amount: float = 0) -> None:
        """Change the score, the lives or the countdown, or end the game."""
        self.play.change(change, amount)

    def has_collected(self, kind: str) -> bool:
        """Whether the robot has collected a thing of a kind; each is answered with yes once."""
        return self._news.take(kind)

    def is_time_up(self) -> bool:
        """Whether the countdown has ended; answered with yes once for each countdown."""
        return self._news.take(TIME_UP)

    def snapshot(self) -> AbstractContextManager[None]:
        """Give the same answers while the context is open, however often asked."""
        return self._news.snapshot()
