"""The shared part of robots that run RoboComp's components, EBO and RCIS."""

from learnblock.robots.robocomp.component import Component
from learnblock.robots.robocomp.robot import RoboCompRobot, RoboCompSettings
from learnblock.robots.robocomp.units import by_side, in_range, pose_of

__all__ = ["Component", "RoboCompRobot", "RoboCompSettings", "by_side", "in_range", "pose_of"]
