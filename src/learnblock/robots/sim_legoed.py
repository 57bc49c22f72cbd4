"""The twin of LEGO Education's Double Motor in the embedded simulator."""

from learnblock.client import skill_sets
from learnblock.robots.simulated import SimulatedRobot


class Robot(SimulatedRobot, skill_sets.SimLegoed):
    """A car with a Double Motor, a Color Sensor and a Single Motor, simulated."""

    description_name = "legoed"
