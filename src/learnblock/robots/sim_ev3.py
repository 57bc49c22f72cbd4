"""EV3's twin in the embedded simulator."""

from learnblock.robots.simulated import SimulatedRobot


class Robot(SimulatedRobot):
    """EV3, simulated."""

    description_name = "ev3"
