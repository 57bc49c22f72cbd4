"""Thymio's twin in the embedded simulator."""

from learnblock.client import skill_sets
from learnblock.robots.simulated import SimulatedRobot


class Robot(SimulatedRobot, skill_sets.SimThymio):
    """Thymio, simulated."""

    description_name = "thymio"
