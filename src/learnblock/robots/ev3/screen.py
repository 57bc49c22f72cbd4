"""Text on the screen of a brick, laid out for the firmware's fonts."""

import textwrap
from dataclasses import dataclass
from itertools import chain

from learnblock.robots.plain_letters import in_ascii

#: The size of the screen in pixels.
WIDTH, HEIGHT = 178, 128


@dataclass(frozen=True, slots=True)
class Font:
    """A font of the firmware.

    Args:
        number: its number in commands.
        width: pixels of a letter.
        line: pixels from one line to the next.
    """

    number: int
    width: int
    line: int

    @property
    def columns(self) -> int:
        return WIDTH // self.width

    @property
    def rows(self) -> int:
        return HEIGHT // self.line


LARGE, NORMAL = Font(2, 16, 18), Font(0, 8, 11)


def laid_out(text: str) -> tuple[Font, tuple[str, ...]]:
    """The lines of a text, in the largest font in which it fits."""
    plain = in_ascii(text)
    for font in (LARGE, NORMAL):
        lines = tuple(
            chain.from_iterable(textwrap.wrap(line, font.columns) for line in plain.splitlines())
        )
        if len(lines) <= font.rows:
            return font, lines
    return NORMAL, lines[: NORMAL.rows]
