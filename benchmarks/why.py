"""How often does an answer to "why?" name the line of a planted fault?

Each fault of `tests/cases/why/planted.toml` is asked about in three ways: as the list of questions
writes it, and in plain English and Spanish. An answer counts if one of its first four sentences
names the line.

    benchmarks/why.py --verbose
    benchmarks/why.py --fault "no event is started" --words
"""

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path
from tempfile import TemporaryDirectory

from learnblock.errors import LearnBlockError
from learnblock.why.answers import answer
from learnblock.why.parser import parse

sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "helpers"))

from planted_faults import WAYS, Planted, Tried, planted_faults, tries


def report(tried: Sequence[Tried]) -> None:
    """Print how often each way of asking found the line."""
    for way in WAYS:
        asked = [one for one in tried if one.way == way]
        found, understood = (
            sum(one.is_found for one in asked),
            sum(one.is_understood for one in asked),
        )
        print(
            f"{way:6} found {found} of {len(asked)} ({100 * found / len(asked):.1f} %), "
            f"understood {understood}"
        )


def print_words(fault: Planted, folder: Path) -> None:
    """Print the program, and the answers in words."""
    history = fault.history(folder)
    print("\n".join(f"{n:3} {line}" for n, line in enumerate(fault.program.splitlines(), 1)))
    for way in WAYS:
        text = getattr(fault, way)
        print(f"--- {text}")
        try:
            given = answer(history, parse(text, history))
        except LearnBlockError as error:
            print(error)
            continue
        for one, words in zip(given.sentences, given.words("en"), strict=True):
            print(f"  [{one.line}] {words}")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--fault", help="a part of the names of the faults to try")
    parser.add_argument("--verbose", action="store_true", help="list what was not found")
    parser.add_argument("--words", action="store_true", help="print programs and answers")
    options = parser.parse_args()
    tried = []
    with TemporaryDirectory() as folder:
        for fault in planted_faults():
            if options.fault and options.fault not in fault.name:
                continue
            if options.words:
                print(f"== {fault.name}: {fault.lines}")
                print_words(fault, Path(folder))
            else:
                tried.extend(tries(fault, Path(folder)))
    for one in tried if options.verbose else ():
        if not one.is_found:
            lines = one.lines if one.is_understood else "not understood"
            print(f"{one.fault.name:40} {one.way:6} {one.fault.lines} {lines}")
    if tried:
        report(tried)


if __name__ == "__main__":
    main()
