"""Put a comment at every place of many programs, and count what the conversions do to it.

Run it with ``python benchmarks/comments.py``: each place of the examples alone, those of files of
the standard library (``--files 100``) all at once and far apart, which takes 15 minutes. It ends
with 1 if any comment was lost, doubled or changed, or if a second round changed anything;
``--verbose`` names them.
"""

import argparse
import sys
import time
from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "helpers"))

from comment_places import (
    EXAMPLES,
    HEAD,
    Place,
    apart,
    block_text_places,
    fate,
    library_files,
    python_places,
)
from learnblock.language import Program, from_python, parse, to_python

#: How far comments are from each other, so that few share a statement.
DISTANCE = 40

Reader = Callable[[str], Program]
Tried = tuple[str, str, list[Place], Reader]


def examples_in_python() -> Iterator[Tried]:
    for path in EXAMPLES:
        python = to_python(parse(path.read_text("utf-8"))).text
        for place in python_places(python):
            yield path.stem, python, [place], from_python


def examples_in_block_text() -> Iterator[Tried]:
    for path in EXAMPLES:
        text = path.read_text("utf-8")
        for place in block_text_places(text):
            yield path.stem, text, [place], parse


def whole_files(count: int) -> Iterator[Tried]:
    for path in library_files(count):
        text = path.read_text("utf-8")
        yield path.stem, text, python_places(text), from_python


def programs(count: int, distance: int) -> Iterator[Tried]:
    for path in library_files(count):
        text = HEAD + path.read_text("utf-8")
        for places in apart(python_places(text), distance):
            yield path.stem, text, places, from_python


def report(title: str, tried: Iterable[Tried], *, verbose: bool) -> int:
    """Print what became of the comments, and return the number of faults."""
    start = time.perf_counter()
    found: Counter[str] = Counter()
    for name, text, places, read in tried:
        lost, doubled, changed, unstable = fate(text, places, read)
        found["places"] += len(places)
        faults = {"lost": lost, "doubled": doubled, "changed": changed, "unstable": unstable}
        for kind, ones in faults.items():
            found[kind] += len(ones)
            if ones and verbose:
                print(f"  {name}: {kind}: {ones}")
    seconds = time.perf_counter() - start
    kinds = ("places", "lost", "doubled", "changed", "unstable")
    print(title.ljust(34), *(f"{found[kind]:>9,}" for kind in kinds), f"{seconds:>8.1f}")
    return found.total() - found["places"]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--files", type=int, default=100, help="files of the standard library")
    parser.add_argument("--verbose", action="store_true")
    given = parser.parse_args()
    print(f"{'':34}    places      lost   doubled   changed  unstable  seconds")
    parts = {
        "examples in Python, one by one": examples_in_python(),
        "examples in Block-Text, one by one": examples_in_block_text(),
        "library as it is, all at once": whole_files(given.files),
        "library as programs, all at once": programs(given.files, 1),
        "library as programs, far apart": programs(given.files, DISTANCE),
    }
    faults = [report(title, tried, verbose=given.verbose) for title, tried in parts.items()]
    sys.exit(any(faults))


if __name__ == "__main__":
    main()
