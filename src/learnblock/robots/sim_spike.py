"""SPIKE's twin in the embedded simulator."""

from learnblock.client import skill_sets
from learnblock.robots.simulated import SimulatedRobot


class Robot(SimulatedRobot, skill_sets.SimSpike):
    """A SPIKE Prime driving base, simulated."""

    description_name = "spike"
