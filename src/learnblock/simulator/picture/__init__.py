"""The picture of a run: the world from above, with the robot's path coloured by time."""

from learnblock.simulator.picture.scene import Scene, draw_png, draw_svg

__all__ = ["Scene", "draw_png", "draw_svg"]
