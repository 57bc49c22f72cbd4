"""Thymio's twin in the embedded simulator."""

from learnblock.robots.simulated import SimulatedRobot


class Robot(SimulatedRobot):
    """Thymio, simulated."""

    description_name = "thymio"
