"""The picture of a run: the world from above, with the robots' paths coloured by time."""

from learnblock.simulator.picture.scene import DrivenRun, PictureScene, draw_png, draw_svg

__all__ = ["DrivenRun", "PictureScene", "draw_png", "draw_svg"]
