"""EV3's twin in the embedded simulator."""

from learnblock.client import skill_sets
from learnblock.robots.simulated import SimulatedRobot


class Robot(SimulatedRobot, skill_sets.SimEv3):
    """EV3, simulated."""

    description_name = "ev3"
