"""The people of drawn faces: the features that do not depend on emotions."""

from dataclasses import dataclass

import numpy as np

from learnblock.simulator.faces.easel import Colour

_SKINS: tuple[Colour, ...] = ((228, 184, 152), (241, 204, 177), (205, 158, 122), (178, 130, 98))
_HAIRS: tuple[Colour, ...] = ((58, 38, 28), (24, 20, 20), (104, 66, 36), (134, 84, 40))
_LIPS: tuple[Colour, ...] = ((176, 84, 80), (160, 74, 76), (188, 96, 88))
_SHIRTS: tuple[Colour, ...] = ((64, 104, 148), (150, 60, 60), (70, 120, 70), (90, 90, 96))
_BACKDROPS: tuple[Colour, ...] = (
    (196, 212, 222),
    (222, 214, 196),
    (206, 206, 206),
    (200, 218, 200),
)


@dataclass(frozen=True, slots=True)
class Person:
    """The features of one person's face; lengths are fractions of the picture's side.

    Args:
        width: half the width of the head.
        height: half the height of the head.
        eyes: the distance from the middle to the centre of an eye.
        eye_size: the size of the eyes, 1 being usual.
        brow: how thick a brow is.
        nose: how long the nose is, 1 being the usual length.
        mouth: how wide the mouth is, 1 being the usual width.
        chin: the distance of the mouth below its usual position.
        lips: how thick the lips are, 1 being usual.
        line: how thick lines are drawn, 1 being usual.
        vigour: how strongly feelings are shown, 1 being usual.
    """

    width: float = 0.275
    height: float = 0.365
    eyes: float = 0.12
    eye_size: float = 1.0
    brow: float = 0.028
    nose: float = 1.0
    mouth: float = 1.0
    chin: float = 0.0
    lips: float = 1.0
    line: float = 1.0
    vigour: float = 1.0
    skin: Colour = _SKINS[0]
    hair: Colour = _HAIRS[0]
    lip: Colour = _LIPS[0]
    shirt: Colour = _SHIRTS[0]
    backdrop: Colour = _BACKDROPS[0]

    @classmethod
    def number(cls, number: int) -> "Person":
        """The person with this number: 0 is the standard one, all others are variations of it."""
        if number == 0:
            return cls()
        chance = np.random.default_rng(number)

        def about(value: float, part: float) -> float:
            return float(value * chance.uniform(1 - part, 1 + part))

        def one_of(colours: tuple[Colour, ...]) -> Colour:
            return colours[int(chance.integers(len(colours)))]

        return cls(
            width=about(0.275, 0.07),
            height=about(0.365, 0.05),
            eyes=about(0.12, 0.08),
            eye_size=about(1, 0.12),
            brow=about(0.028, 0.25),
            nose=about(1, 0.1),
            mouth=about(1, 0.1),
            chin=float(chance.uniform(-0.012, 0.012)),
            lips=about(1, 0.25),
            line=about(1, 0.3),
            vigour=about(1, 0.15),
            skin=one_of(_SKINS),
            hair=one_of(_HAIRS),
            lip=one_of(_LIPS),
            shirt=one_of(_SHIRTS),
            backdrop=one_of(_BACKDROPS),
        )

    @property
    def shadow(self) -> Colour:
        """The colour of the skin's folds."""
        red, green, blue = self.skin
        return round(0.526 * red), round(0.391 * green), round(0.368 * blue)

    @property
    def light(self) -> Colour:
        """The colour of the skin where light falls on it."""
        red, green, blue = self.skin
        return (
            min(255, round(1.12 * red)),
            min(255, round(1.24 * green)),
            min(255, round(1.35 * blue)),
        )
