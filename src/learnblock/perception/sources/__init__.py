"""The pictures of any camera: where they come from, and which detectors may search them.

The detectors themselves are in `learnblock.perception`.
"""

from learnblock.perception.settings import TABLE, WHY_EMOTIONS_ARE_OFF, PerceptionSettings
from learnblock.perception.sources.looking import Vision

__all__ = ["TABLE", "WHY_EMOTIONS_ARE_OFF", "PerceptionSettings", "Vision"]
