"""Robots of the embedded simulator: the twins, which run wherever LearnBlock is installed."""

from learnblock.robots.simulated.drawing import draw
from learnblock.robots.simulated.options import pace_factor
from learnblock.robots.simulated.play import repeat_game
from learnblock.robots.simulated.robot import SimulatedRobot, goal_of
from learnblock.robots.simulated.simulation import STEPS_PER_POSE, Simulation
from learnblock.robots.simulated.worlds import (
    check_file_name,
    find_world,
    known_worlds,
    own_worlds,
    world_of_data,
    worlds,
)

__all__ = [
    "STEPS_PER_POSE",
    "SimulatedRobot",
    "Simulation",
    "check_file_name",
    "draw",
    "find_world",
    "goal_of",
    "known_worlds",
    "own_worlds",
    "pace_factor",
    "repeat_game",
    "world_of_data",
    "worlds",
]
