"""The expressions of faces."""

from dataclasses import dataclass, fields
from types import MappingProxyType


@dataclass(frozen=True, slots=True)
class Expression:
    """The expression of a face, in parts of its width, downwards positive.

    Args:
        brow_inner: the distance of the brow's inner end below its position at rest.
        brow_outer: the same for its outer end.
        eye: how far the eye is open, 1 at rest.
        mouth_width: half the width of the mouth.
        corners: the distance of the mouth's corners below its middle.
        gap: how far the lips are apart.
        sneer: how far the upper lip and the sides of the nose are raised.
        blush: how red the cheeks are, 0 to 1.
    """

    brow_inner: float = 0.0
    brow_outer: float = 0.0
    eye: float = 1.0
    mouth_width: float = 0.105
    corners: float = 0.0
    gap: float = 0.0
    sneer: float = 0.0
    blush: float = 0.15

    def times(self, vigour: float) -> "Expression":
        """The same expression, stronger or weaker: 1 leaves it unchanged, 0 is no expression."""
        rest = Expression()
        return Expression(
            **{
                field.name: getattr(rest, field.name)
                + vigour * (getattr(self, field.name) - getattr(rest, field.name))
                for field in fields(self)
            }
        )


EXPRESSIONS = MappingProxyType(
    {
        "fear": Expression(-0.04, 0.015, 1.35, 0.10, 0.02, 0.035, 0.0, 0.0),
        "surprise": Expression(-0.045, -0.04, 1.5, 0.06, 0.0, 0.10),
        "anger": Expression(0.065, -0.045, 0.75, 0.082, 0.04, 0.046, 0.008, 0.3),
        "sadness": Expression(-0.03, 0.025, 0.75, 0.095, 0.035, 0.0, 0.0, 0.1),
        "disgust": Expression(0.01, 0.0, 0.5, 0.075, 0.038, 0.036, 0.039, 0.3),
        "joy": Expression(-0.01, -0.015, 0.85, 0.13, -0.05, 0.045, 0.0, 0.45),
        "neutral": Expression(),
    }
)
