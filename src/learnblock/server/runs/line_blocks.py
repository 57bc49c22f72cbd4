"""The blocks of a program's lines."""

from collections.abc import Iterable, Sequence


class LineBlocks:
    """Which block each line of a program belongs to.

    Args:
        blocks: for each line of the program's Python, its block; None for a line without one.
    """

    def __init__(self, blocks: Sequence[str | None]) -> None:
        self._blocks = blocks

    def at(self, line: int) -> str | None:
        """The block of a line; None if it has none."""
        return self._blocks[line - 1] if 1 <= line <= len(self._blocks) else None

    def lines(self, block: str) -> frozenset[int]:
        """The lines of a block."""
        return frozenset(line for line, owner in enumerate(self._blocks, 1) if owner == block)

    def heads(self, lines: Iterable[int]) -> dict[int, str]:
        """The block of each line that is the first of its block; an `elif` is none.

        Args:
            lines: those that can be one.
        """
        heads: dict[str, int] = {}
        for line in sorted(set(lines)):
            if block := self.at(line):
                heads.setdefault(block, line)
        return {line: block for block, line in heads.items()}
