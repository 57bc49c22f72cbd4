"""SPIKE's twin in the embedded simulator."""

from learnblock.robots.simulated import SimulatedRobot


class Robot(SimulatedRobot):
    """A SPIKE Prime driving base, simulated."""

    description_name = "spike"
