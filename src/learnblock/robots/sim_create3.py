"""Create 3's twin in the embedded simulator."""

from learnblock.robots.simulated import SimulatedRobot


class Robot(SimulatedRobot):
    """A Create 3, simulated."""

    description_name = "create3"
