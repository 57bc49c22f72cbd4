"""The game of a world, or of a real robot, as the page shows it."""

from typing import TYPE_CHECKING

from learnblock.client.game import Game, OwnPlay
from learnblock.monitor.monitor import GameNow, PlayerNow

if TYPE_CHECKING:
    from learnblock.simulator.game.game import WorldGame

#: Decimals of a place in mm: less than a pixel.
_DECIMALS = 1
#: Why a game is won by one of its robots; by all goals, all of them win it.
_BY_ONE = ("program", "zone", "winning-goal")


def game_now(game: "WorldGame", time: float) -> GameNow | None:
    """The state of a game at a time in s; None if the world and its programs have no game."""
    scores = game.scores
    counts = game.has_things or game.has_rules or scores.counts
    if not counts and not scores.in_use and not game.teams:
        return None
    teams = game.teams.robots
    # In the order of the world, as programs may join its game in another one.
    players = [name for name in teams if name in scores.players]
    standings = {name: scores.standing(name, time) for name in players}
    left = next((standing.time_left for standing in standings.values()), None)
    result = scores.result
    return GameNow(
        tuple(
            PlayerNow(name, standing.score, standing.lives, teams[name])
            for name, standing in standings.items()
        ),
        time_left=left,
        things=tuple(_place(*thing.place) if thing.is_there else None for thing in game.lying),
        doors=tuple(door.is_open for door in game.doors),
        won=result.won if result else None,
        reason=(result.thing or result.reason) if result else "",
        winner=result.player if result and result.won and result.reason in _BY_ONE else "",
        team=result.team if result else "",
        counts=counts,
    )


def own_game(game: Game) -> GameNow | None:
    """The state of the game of a robot without a world; None while it has counted nothing."""
    seen = game.play.seen if isinstance(game.play, OwnPlay) else None
    if seen is None:
        return None
    result = game.play.result
    return GameNow(
        (PlayerNow("robot", seen.score, seen.lives),),
        time_left=seen.time_left,
        won=result.won if result else None,
    )


def _place(x: float, y: float) -> tuple[float, float]:
    return round(x, _DECIMALS), round(y, _DECIMALS)
