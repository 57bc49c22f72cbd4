"""RoboComp's components that look at pictures: ours for others, and those of others for us.

Two of the paper's: Apriltag, which finds tags, and EmotionRecognition, which finds faces and what
they express. Their interfaces are the same in every `learnblock.ice.robocomp.Layout`; what differs
is which number a picture's `width` carries (`Order`).
"""

from learnblock.components.asking import Asked, AskedEmotions, AskedTags
from learnblock.components.pictures import Order, PictureError
from learnblock.components.serving import COMPONENTS, serve

__all__ = ["COMPONENTS", "Asked", "AskedEmotions", "AskedTags", "Order", "PictureError", "serve"]
