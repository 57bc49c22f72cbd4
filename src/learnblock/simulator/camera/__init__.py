"""A projective camera: it renders textured planar quads as an RGB picture.

World coordinates are mm: x east, y north, z up. Headings and pitches are degrees: a heading grows
clockwise seen from above, so forward is (cos h, -sin h), and a positive pitch points up. Pixel
(0, 0) is the top left one; integer pixel coordinates are pixel centres, and the optical axis meets
the picture in its middle, at ((width - 1) / 2, (height - 1) / 2).

On a plane 1/z is affine in pixel coordinates, so the depth test is exact for every pixel; the
texture comes through the plane's homography, from the level of its mip chain whose texels are
about as large as a pixel there.
"""

from learnblock.simulator.camera.lens import CameraModel, CameraPose
from learnblock.simulator.camera.mip_chain import MipChain
from learnblock.simulator.camera.rendering import CameraView, render
from learnblock.simulator.camera.surface import Surface
from learnblock.simulator.camera.vectors import Image

__all__ = ["CameraModel", "CameraPose", "CameraView", "Image", "MipChain", "Surface", "render"]
