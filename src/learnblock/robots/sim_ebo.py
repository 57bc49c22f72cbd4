"""EBO's twin in the embedded simulator."""

from learnblock.robots.simulated import SimulatedRobot


class Robot(SimulatedRobot):
    """EBO, simulated."""

    description_name = "ebo"
