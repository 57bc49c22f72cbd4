"""Create 3's twin in the embedded simulator."""

from learnblock.client import skill_sets
from learnblock.robots.simulated import SimulatedRobot


class Robot(SimulatedRobot, skill_sets.SimCreate3):
    """A Create 3, simulated."""

    description_name = "create3"
