"""The game of a world, as one of its robots plays it."""

from collections.abc import Iterable, Mapping
from typing import Any

from learnblock.robots.simulated.simulation import Simulation
from learnblock.scores import Change, GameResult, Tally


class WorldPlay:
    """The game of a world, for one of its robots.

    Args:
        simulation: the world.
        name: the robot.
    """

    def __init__(self, simulation: Simulation, name: str) -> None:
        self._simulation = simulation
        self._name = name
        with simulation.lock:
            simulation.world.game.join(name, simulation.world.time)

    @property
    def result(self) -> GameResult | None:
        """How the game ended; None while it goes on."""
        return self._simulation.world.game.scores.result

    def standing(self) -> Tally:
        """The robot's score and lives, and the time that is left."""
        world = self._simulation.world
        return world.game.scores.standing(self._name, world.time)

    def change(self, change: Change, amount: float) -> None:
        """Do what the robot's program has said."""
        world = self._simulation.world
        world.game.scores.change(self._name, change, amount, world.time)
        # At once: the trace has it in its place among the steps of this moment.
        self._simulation.report_game()

    def collect(self) -> Iterable[str]:
        """Take the news for the robot's program."""
        return self._simulation.world.game.scores.collect(self._name)


def repeat_game(simulation: Simulation, name: str, line: Mapping[str, Any]) -> None:
    """Repeat what a program has done to its game, from a line of its trace.

    Args:
        simulation: the world.
        name: the robot.
        line: one with the key ``game``; what things have done happens by itself.
    """
    scores, time = simulation.world.game.scores, simulation.time()
    match line:
        case {"winner": _}:
            return
        case {"thing": "program", "game": "won" | "lost" as end}:
            scores.change(name, "win" if end == "won" else "lose", 0, time)
        case {"thing": _}:
            return
        case {"game": "score", "score": int() | float() as score}:
            scores.change(name, "set-score", score, time)
        case {"game": "lives", "lost": int() as lost}:
            scores.change(name, "change-lives", -lost, time)
        case {"game": "lives", "lives": int() as lives}:
            scores.change(name, "set-lives", lives, time)
        case {"game": "countdown", "seconds": int() | float() as seconds}:
            scores.change(name, "countdown", seconds, time)
