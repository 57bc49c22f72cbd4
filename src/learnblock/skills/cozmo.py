"""Cozmo's behaviours; on other robots they have no effect."""

from typing import TYPE_CHECKING

from learnblock.devices import Animator

if TYPE_CHECKING:
    from learnblock.client import Client


def cozmoBored(robot: "Client") -> None:
    """Be bored: look around and sigh."""
    _play(robot, "Bored")


def cozmoCat(robot: "Client") -> None:
    """Be a cat."""
    _play(robot, "Cat")


def cozmoDances(robot: "Client") -> None:
    """Dance."""
    _play(robot, "Dances")


def cozmoDog(robot: "Client") -> None:
    """Be a dog."""
    _play(robot, "Dog")


def cozmoDuck(robot: "Client") -> None:
    """Be a duck."""
    _play(robot, "Duck")


def cozmoElephant(robot: "Client") -> None:
    """Be an elephant."""
    _play(robot, "Elephant")


def cozmoIdle(robot: "Client") -> None:
    """Look around and move a little while waiting."""
    _play(robot, "Idle")


def cozmoSheep(robot: "Client") -> None:
    """Be a sheep."""
    _play(robot, "Sheep")


def cozmoSleep(robot: "Client") -> None:
    """Fall asleep."""
    _play(robot, "Sleep")


def cozmoSneezes(robot: "Client") -> None:
    """Sneeze."""
    _play(robot, "Sneezes")


def cozmoVampire(robot: "Client") -> None:
    """Be a vampire."""
    _play(robot, "Vampire")


def cozmoZombie(robot: "Client") -> None:
    """Be a zombie."""
    _play(robot, "Zombie")


def _play(robot: "Client", name: str) -> None:
    animator = robot.device(Animator)
    if animator is not None:
        animator.play(name)
