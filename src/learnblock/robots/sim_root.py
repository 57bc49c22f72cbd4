"""Root's twin in the embedded simulator."""

from learnblock.robots.simulated import SimulatedRobot


class Robot(SimulatedRobot):
    """A Root Pro, simulated."""

    description_name = "root"
