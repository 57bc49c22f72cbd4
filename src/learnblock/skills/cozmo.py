"""Cozmo's behaviours; on other robots they have no effect.

The program continues while Cozmo acts; a behaviour begins after those started before it.
"""

from typing import TYPE_CHECKING

from learnblock.devices import Animator

if TYPE_CHECKING:
    from learnblock.client import Client


def cozmoBored(robot: "Client") -> None:
    """Start acting bored; the program continues meanwhile."""
    _play(robot, "Bored")


def cozmoCat(robot: "Client") -> None:
    """Start acting like a cat; the program continues meanwhile."""
    _play(robot, "Cat")


def cozmoDances(robot: "Client") -> None:
    """Start dancing; the program continues meanwhile."""
    _play(robot, "Dances")


def cozmoDog(robot: "Client") -> None:
    """Start acting like a dog; the program continues meanwhile."""
    _play(robot, "Dog")


def cozmoDuck(robot: "Client") -> None:
    """Start acting like a duck; the program continues meanwhile."""
    _play(robot, "Duck")


def cozmoElephant(robot: "Client") -> None:
    """Start acting like an elephant; the program continues meanwhile."""
    _play(robot, "Elephant")


def cozmoIdle(robot: "Client") -> None:
    """Start looking around and moving a little; the program continues meanwhile."""
    _play(robot, "Idle")


def cozmoSheep(robot: "Client") -> None:
    """Start acting like a sheep; the program continues meanwhile."""
    _play(robot, "Sheep")


def cozmoSleep(robot: "Client") -> None:
    """Start falling asleep; the program continues meanwhile."""
    _play(robot, "Sleep")


def cozmoSneezes(robot: "Client") -> None:
    """Start sneezing; the program continues meanwhile."""
    _play(robot, "Sneezes")


def cozmoVampire(robot: "Client") -> None:
    """Start acting like a vampire; the program continues meanwhile."""
    _play(robot, "Vampire")


def cozmoZombie(robot: "Client") -> None:
    """Start acting like a zombie; the program continues meanwhile."""
    _play(robot, "Zombie")


def _play(robot: "Client", name: str) -> None:
    animator = robot.device(Animator)
    if animator is not None:
        animator.play(name)
