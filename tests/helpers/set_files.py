"""Block sets and tag names for the fuzzer."""

from pathlib import Path

import msgspec

from learnblock.blocks import block_sets
from learnblock.perception.tag_names import parse, write

SETS = Path(block_sets.__file__).parent / "sets"
DICTIONARIES = ('ball = 3\n"red door" = 12\n', 'name,tag\nball,3\n"a, b",12\n')


def read_set(file: Path) -> None:
    """Check that a set stays the same when it is written and read."""
    block_set = msgspec.structs.replace(block_sets.read(file), name="lesson")
    if block_sets.parse(block_sets.write(block_set), "lesson") != block_set:
        raise AssertionError("the set does not come back from its file")


def read_tags(text: str) -> None:
    """Check that tag names stay the same when they are written and read, in both formats."""
    for name in ("tags.toml", "tags.csv") if "=" in text else ("tags.csv",):
        numbers = parse(text, name)
        if parse(write(numbers), "tags.toml") != numbers:
            raise AssertionError("the dictionary does not come back from its file")
