"""The colours that the button of a device can show."""

from collections.abc import Mapping

#: Red, green and blue, 0 to 255, by LEGO's number.
COLOURS: Mapping[int, tuple[int, int, int]] = {
    1: (255, 0, 160),
    2: (128, 0, 255),
    3: (0, 0, 255),
    4: (0, 160, 255),
    5: (0, 255, 200),
    6: (0, 255, 0),
    7: (255, 255, 0),
    8: (255, 128, 0),
    9: (255, 0, 0),
    10: (255, 255, 255),
}
#: LEGO's number for no light.
DARK = -1


def nearest(colour: tuple[int, int, int]) -> tuple[int, int]:
    """LEGO's number of the colour that is most like one, and its intensity in %."""
    brightest = max(colour)
    if brightest == 0:
        return DARK, 0
    full = [255 * part / brightest for part in colour]

    def difference(number: int) -> float:
        pairs = zip(full, COLOURS[number], strict=True)
        return sum((ours - theirs) ** 2 for ours, theirs in pairs)

    return min(COLOURS, key=difference), max(1, round(100 * brightest / 255))
