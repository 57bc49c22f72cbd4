"""RoboComp's components that search pictures: ours for other programs, and theirs for us.

Two are the paper's: Apriltag, which finds tags, and EmotionRecognition, which finds faces and their
emotions. Their interfaces are the same in every `learnblock.ice.robocomp.Layout`, but the number
that a picture's `width` means differs (`PixelOrder`).
"""

from learnblock.perception.robocomp.asking import Asked, AskedEmotions, AskedTags
from learnblock.perception.robocomp.pictures import PixelOrder
from learnblock.perception.robocomp.serving import COMPONENTS, serve

__all__ = ["COMPONENTS", "Asked", "AskedEmotions", "AskedTags", "PixelOrder", "serve"]
