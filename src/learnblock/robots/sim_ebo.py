"""EBO's twin in the embedded simulator."""

from learnblock.client import skill_sets
from learnblock.robots.simulated import SimulatedRobot


class Robot(SimulatedRobot, skill_sets.SimEbo):
    """EBO, simulated."""

    description_name = "ebo"
