"""The game of a world, or of a real robot, as the page shows it."""

from typing import TYPE_CHECKING

from learnblock.client.game import Game, OwnPlay
from learnblock.monitor.monitor import GameNow, PlayerNow

if TYPE_CHECKING:
    from learnblock.simulator.game.game import WorldGame

#: Decimals of a place in mm: less than a pixel.
_DECIMALS = 1


def game_now(game: "WorldGame", time: float) -> GameNow | None:
    """The state of a game at a time in s; None if the world and its programs have no game."""
    scores = game.scores
    if not game.has_things and not game.has_rules and not scores.in_use:
        return None
    standings = {name: scores.standing(name, time) for name in scores.players}
    left = next((standing.time_left for standing in standings.values()), None)
    result = scores.result
    return GameNow(
        tuple(
            PlayerNow(name, standing.score, standing.lives) for name, standing in standings.items()
        ),
        time_left=left,
        things=tuple(_place(*thing.place) if thing.is_there else None for thing in game.lying),
        doors=tuple(door.is_open for door in game.doors),
        won=result.won if result else None,
        reason=(result.thing or result.reason) if result else "",
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
