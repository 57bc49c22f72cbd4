"""Where the statements of a program are in its views."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property

from learnblock.language.tree.extents import Extent, moved
from learnblock.project.document.notations import Notations
from learnblock.project.document.problems import owners
from learnblock.project.document.views import Notation, Place


@dataclass(frozen=True)
class Positions:
    """The positions of the statements that could be parsed, in the texts that are shown.

    Args:
        good: the last program that could be parsed.
        blocktext: the Block-Text that is shown, which may be newer.
        python: the Python that is shown, which may be newer.
    """

    good: Notations
    blocktext: str
    python: str

    def with_text(self, notation: Notation, text: str) -> "Positions":
        """The positions of the same statements in a newer text."""
        if notation == "blocktext":
            return replace(self, blocktext=text)
        return replace(self, python=text)

    @cached_property
    def places(self) -> tuple[Place, ...]:
        """Every statement in all three views."""
        places: dict[str, Place] = {}
        rows = zip(
            self.good.statement_blocks(),
            self._extents("blocktext"),
            self._extents("python"),
            strict=True,
        )
        for block, blocktext, python in rows:
            if block is not None:
                # A comment belongs to the block of the statement below it, which comes later.
                places[block] = Place(block, *blocktext, *python)
        return tuple(places.values())

    @cached_property
    def python_lines(self) -> Mapping[str, int]:
        """The first line of each block in the Python that is shown."""
        return {place.block: place.python for place in self.places if place.python}

    def block_at(self, notation: Notation, line: int) -> str | None:
        """The innermost block in a line of a text; lines count from 1."""
        owner = self._blocktext_owners if notation == "blocktext" else self._python_owners
        index = owner[line] if 0 < line < len(owner) else None
        return None if index is None else self.good.statement_blocks()[index]

    @cached_property
    def _blocktext_owners(self) -> list[int | None]:
        return owners(self._extents("blocktext"))

    @cached_property
    def _python_owners(self) -> list[int | None]:
        return owners(self._extents("python"))

    def _extents(self, notation: Notation) -> tuple[Extent, ...]:
        of_blocktext = notation == "blocktext"
        good = self.good.blocktext if of_blocktext else self.good.python
        text = self.blocktext if of_blocktext else self.python
        if text == good.text:
            return good.extents
        return moved(good.extents, good.text, text)
