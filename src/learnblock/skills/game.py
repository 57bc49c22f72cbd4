"""What a game needs: score, lives, a countdown, and its end."""

from typing import TYPE_CHECKING, NoReturn

from learnblock.devices import number
from learnblock.scores import USUAL_LIVES
from learnblock.skills import screen

if TYPE_CHECKING:
    from learnblock.client import Client


def change_score(robot: "Client", points: float = 1) -> None:
    """Change the score of the game.

    Args:
        points: what is added to it; a negative number is taken away.
    """
    robot.game.change("change-score", number("points", points))


def set_score(robot: "Client", score: float = 0) -> None:
    """Set the score of the game.

    Args:
        score: the new score.
    """
    robot.game.change("set-score", number("score", score))


def get_score(robot: "Client") -> float:
    """The score of the game: what the world and the program have added to it."""
    _take_time(robot)
    return robot.game.standing.score


def show_score(robot: "Client") -> None:
    """Show the score on the robot's screen; a real robot without a screen prints it.

    In a world with a game, the page shows the score anyway.
    """
    screen.show_number(robot, robot.game.standing.score)


def change_lives(robot: "Client", lives: float = -1) -> None:
    """Change the number of lives; without any left, the game is over.

    A game that has not said how many there are begins with three.

    Args:
        lives: how many are added; a negative number is taken away.
    """
    robot.game.change("change-lives", number("lives", lives))


def set_lives(robot: "Client", lives: float = 3) -> None:
    """Set the number of lives.

    Args:
        lives: how many there are.
    """
    robot.game.change("set-lives", number("lives", lives))


def get_lives(robot: "Client") -> float:
    """The lives that are left."""
    _take_time(robot)
    lives = robot.game.standing.lives
    return USUAL_LIVES if lives is None else lives


def start_countdown(robot: "Client", seconds: float = 60) -> None:
    """Begin a countdown, instead of the one before. It belongs to all robots of the world.

    Args:
        seconds: how long it takes.
    """
    robot.game.change("countdown", number("seconds", seconds))


def get_time_left(robot: "Client") -> float:
    """The seconds until the countdown ends; 0 after that, and without a countdown."""
    robot.await_reading("game")
    return robot.game.standing.time_left or 0.0


def is_time_up(robot: "Client") -> bool:
    """Has the countdown ended? Answered with yes once for each countdown."""
    robot.await_reading("game")
    return robot.game.is_time_up()


def collected(robot: "Client", kind: str = "star") -> bool:
    """Has the robot collected such a thing? Each one is answered with yes once.

    On a real robot, and in a world without such things, nothing is collected.

    Args:
        kind: what it is, such as star, or anything.
    """
    robot.await_reading("game")
    return robot.game.has_collected(str(kind))


def win_game(robot: "Client") -> None:
    """Win the game, which ends the programs of all its robots."""
    robot.game.change("win")
    _leave(robot)


def game_over(robot: "Client") -> None:
    """End the game without winning it, and the programs of all its robots."""
    robot.game.change("lose")
    _leave(robot)


def _leave(robot: "Client") -> NoReturn:
    """End the program; that of a world is ended by the world, while it waits."""
    robot.clock.sleep(robot.period)
    raise SystemExit


def _take_time(robot: "Client") -> None:
    """A program that only asks must let time pass, or nothing could change."""
    if not robot.readings.frozen:
        robot.clock.charge()
