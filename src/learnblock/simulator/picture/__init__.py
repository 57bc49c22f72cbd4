"""The picture of a run: the world from above, with the robots' paths coloured by time."""

from learnblock.simulator.picture.scene import Drive, Scene, draw_png, draw_svg

__all__ = ["Drive", "Scene", "draw_png", "draw_svg"]
