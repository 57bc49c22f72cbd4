"""Root's twin in the embedded simulator."""

from learnblock.client import skill_sets
from learnblock.robots.simulated import SimulatedRobot


class Robot(SimulatedRobot, skill_sets.SimRoot):
    """A Root Pro, simulated."""

    description_name = "root"
