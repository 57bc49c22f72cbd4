"""What counts in a game: the score and the lives of each player, a countdown, and the end.

A simulated world keeps it for all its robots; a robot without a world keeps its own.
"""

import math
from collections import Counter, deque
from dataclasses import dataclass, replace
from typing import Literal, NamedTuple

#: Lives of a player in a game that has not said how many, as in MakeCode Arcade.
USUAL_LIVES = 3
#: The largest score and number of lives, on either side of 0.
LARGEST = 1_000_000_000
#: Decimals of a score, so that ten times 0.1 is 1.
_DECIMALS = 3
#: The most news that wait for a program; when one more arrives, the oldest is lost.
MOST_WAITING = 1000
#: The most events that wait to be taken.
_EVENTS_KEPT = 10_000

#: What a program may do to a game.
Change = Literal[
    "change-score", "set-score", "change-lives", "set-lives", "countdown", "win", "lose"
]
EventKind = Literal[
    "score",
    "lives",
    "collected",
    "entered",
    "left",
    "passed",
    "touched",
    "pressed",
    "opened",
    "closed",
    "countdown",
    "time-up",
    "won",
    "lost",
]
#: Why a game ended: its program or a zone said so, no lives or no time were left, a goal that wins
#: was reached, all goals were reached or one of them was missed.
Reason = Literal["program", "zone", "lives", "time", "winning-goal", "goals", "goal-failed"]
#: The news for a program when the countdown has ended.
TIME_UP = "time-up"
#: The news for each thing that is collected, beside the one with its kind.
ANYTHING = "anything"


class Tally(NamedTuple):
    """How a game stands for a player.

    Args:
        score: its score.
        lives: its lives; None as long as the game has none.
        time_left: seconds until the countdown ends, 0 after that; None without a countdown.
    """

    score: float = 0
    lives: int | None = None
    time_left: float | None = None


class GameResult(NamedTuple):
    """How a game ended.

    Args:
        won: whether it was won.
        player: the player that won it or ended it; "" for all of them.
        reason: why it ended.
        thing: what ended it, such as a zone or a goal; "" for nothing.
        time: when, in seconds.
        team: the team that won it; "" for none.
    """

    won: bool
    player: str
    reason: Reason
    thing: str
    time: float
    team: str = ""

    @classmethod
    def of(
        cls,
        time: float,
        reason: Reason,
        *,
        won: bool,
        player: str = "",
        thing: str = "",
        team: str = "",
    ) -> "GameResult":
        """The end of a game at a time in s."""
        return cls(won, player, reason, thing, time, team)


@dataclass(frozen=True, slots=True)
class GameEvent:
    """Something that happened in a game.

    Args:
        time: when, in seconds.
        kind: what.
        player: to whom; "" for all players.
        thing: the thing that caused it, or why the game ended; "" for the program.
        score: the player's score since then, if it has changed.
        lives: the player's lives since then, if they have changed.
        lost: how many of them a program has taken, so that the run can be repeated.
        seconds: of a countdown.
        winner: the player that reached the goal that won the game, which all players hear of.
        team: the team that won it.
    """

    time: float
    kind: EventKind
    player: str = ""
    thing: str = ""
    score: float | None = None
    lives: int | None = None
    lost: int | None = None
    seconds: float | None = None
    winner: str | None = None
    team: str | None = None


class Counts:
    """What counts for one player.

    Args:
        lives: the lives with which it begins; None without any.
    """

    def __init__(self, lives: int | None) -> None:
        self.score: float = 0
        self.lives = lives
        self.lost_lives = 0
        #: How many things of each kind it has collected, and of any kind.
        self.collected: Counter[str] = Counter()
        self.news: deque[str] = deque(maxlen=MOST_WAITING)


class Scores:
    """The scores of a game.

    Args:
        lives: of each player; None for a game without lives, until a program speaks of them.
    """

    def __init__(self, lives: int | None = None) -> None:
        self._lives = lives
        self._players: dict[str, Counts] = {}
        #: When the countdown ends, in seconds; None without counts.
        self._ends_at: float | None = None
        self._is_time_up = False
        self.result: GameResult | None = None
        self._events: deque[GameEvent] = deque(maxlen=_EVENTS_KEPT)

    def join(self, player: str) -> None:
        """Add a player, unless it plays already."""
        if player not in self._players:
            self._players[player] = Counts(self._lives)

    def standing(self, player: str, time: float) -> Tally:
        """A player's score and lives, and the time that is left."""
        counts = self.of(player)
        left = None if self._ends_at is None else max(0.0, round(self._ends_at - time, _DECIMALS))
        return Tally(counts.score, counts.lives, left)

    def of(self, player: str) -> Counts:
        """What counts for a player so far; only `Scores` may change it."""
        return self._players.get(player) or Counts(self._lives)

    def plays(self, player: str) -> bool:
        """Whether a player is still in the game: it has joined it, and not lost all its lives."""
        counts = self._players.get(player)
        return self.result is None and counts is not None and counts.lives != 0

    @property
    def players(self) -> tuple[str, ...]:
        """The names of the players, in the order in which they have joined."""
        return tuple(self._players)

    @property
    def in_use(self) -> bool:
        """Whether a program has counted anything or begun a countdown, or the game has ended."""
        return self.counts or self.result is not None

    @property
    def counts(self) -> bool:
        """Whether there is a score, a life or a countdown to show."""
        changed = any(counts.score or counts.lives is not None for counts in self._players.values())
        return changed or self._ends_at is not None

    @property
    def counts_down(self) -> bool:
        """Whether a countdown goes on."""
        return self._ends_at is not None and not self._is_time_up

    def change(self, player: str, change: Change, amount: float, time: float) -> None:
        """Do what a player's program has said; an ended game stays as it is."""
        counts = self.of(player)
        match change:
            case "change-score":
                self.affect("score", player, time, points=amount)
            case "set-score":
                self.affect("score", player, time, points=amount - counts.score)
            case "change-lives":
                self.affect("lives", player, time, lives=round(amount))
            case "set-lives":
                # Not a loss, even of some: so the number before is forgotten.
                counts.lives = 0
                self.affect("lives", player, time, lives=max(0, round(amount)))
            case "countdown":
                self.start_countdown(amount, time, player=player)
            case "win" | "lose":
                self.end(GameResult.of(time, "program", won=change == "win", player=player))

    def affect(
        self,
        kind: EventKind,
        player: str,
        time: float,
        *,
        thing: str = "",
        points: float = 0,
        lives: int = 0,
    ) -> None:
        """Change what counts for a player; one without lives left ends the game if it is the last.

        Args:
            kind: what happened.
            player: to whom.
            time: when, in seconds.
            thing: the thing that caused it; "" for the player's program.
            points: what is added to its score.
            lives: how many lives it gains, or loses.
        """
        counts = self.of(player)
        if self.result or not (thing or points or lives):
            return
        counts.score = _tidy(counts.score + points)
        if lives:
            known = USUAL_LIVES if counts.lives is None else counts.lives
            counts.lives = min(max(0, known + lives), LARGEST)
            counts.lost_lives += max(0, known - counts.lives)
        score, left = counts.score if points else None, counts.lives if lives else None
        lost = -lives if lives < 0 and not thing else None
        self._events.append(GameEvent(time, kind, player, thing, score, left, lost))
        if all(counts.lives == 0 for counts in self._players.values()):
            self.end(GameResult.of(time, "lives", won=False, player=player, thing=thing))

    def note(self, event: GameEvent) -> None:
        """Note something that changes neither score nor lives."""
        self._events.append(event)

    def keep(self, player: str, kind: str) -> None:
        """Add a thing to those that a player has collected, and tell its program."""
        counts = self.of(player)
        counts.collected.update((kind, ANYTHING))
        counts.news.extend((kind, ANYTHING))

    def collect(self, player: str) -> list[str]:
        """Take the news for a player's program, oldest first."""
        news = self.of(player).news
        taken = [*news]
        news.clear()
        return taken

    def start_countdown(
        self, seconds: float, time: float, *, player: str = "", thing: str = ""
    ) -> None:
        """Begin a countdown, instead of the one before; a player's program or a thing begins it."""
        if self.result:
            return
        lasts = round(min(max(0.0, seconds), LARGEST), _DECIMALS)
        self._ends_at = round(time + lasts, _DECIMALS)
        self._is_time_up = False
        self.note(GameEvent(time, "countdown", player, thing, seconds=lasts))

    def look(self, time: float) -> bool:
        """Whether the countdown has ended now; only once for each countdown."""
        if self._ends_at is None or self._is_time_up or self.result or time < self._ends_at:
            return False
        self._is_time_up = True
        self.note(GameEvent(time, "time-up"))
        for counts in self._players.values():
            counts.news.append(TIME_UP)
        return True

    def end(self, result: GameResult) -> None:
        """End the game; the first end counts."""
        if self.result:
            return
        self.result = result
        kind: EventKind = "won" if result.won else "lost"
        event = GameEvent(result.time, kind, result.player, result.thing or result.reason)
        if result.reason == "winning-goal":
            event = replace(event, player="", winner=result.player, team=result.team or None)
        self.note(event)

    @property
    def has_events(self) -> bool:
        """Whether there are events to take."""
        return bool(self._events)

    def take_events(self) -> list[GameEvent]:
        """The events since the last call, oldest first."""
        events = [*self._events]
        self._events.clear()
        return events

    @property
    def state(self) -> tuple[object, ...]:
        """All that counts, to compare two games."""
        players = tuple(
            (name, counts.score, counts.lives, counts.lost_lives, *counts.news)
            for name, counts in self._players.items()
        )
        return players, self._ends_at, self._is_time_up, self.result


def _tidy(score: float) -> float:
    """A score within its limits; whole ones are whole numbers."""
    if not math.isfinite(score):
        return 0
    rounded = round(min(max(-LARGEST, score), LARGEST), _DECIMALS)
    return int(rounded) if rounded == int(rounded) else rounded
