"""What robots see, whatever their camera is: who looks at its pictures, and whether they may.

Detectors themselves, pictures in and detections out, are `learnblock.perception`.
"""

from learnblock.vision.looking import Vision
from learnblock.vision.settings import TABLE, WHY_EMOTIONS_ARE_OFF, PerceptionSettings

__all__ = ["TABLE", "WHY_EMOTIONS_ARE_OFF", "PerceptionSettings", "Vision"]
