"""Cozmo's twin in the embedded simulator."""

from learnblock.robots.simulated import SimulatedRobot


class Robot(SimulatedRobot):
    """Cozmo, simulated."""

    description_name = "cozmo"
