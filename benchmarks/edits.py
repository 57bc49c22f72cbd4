"""Measure how long an edit in a program of 1,000 lines takes, in each notation, against a base.

Run it with ``python benchmarks/edits.py --base FOLDER``, where FOLDER has the sources of another
version (``git archive VERSION src | tar -x -C FOLDER``). Both take turns; each time is the best.
"""

import argparse
import json
import os
import subprocess
import sys
import time
from pathlib import Path

from learnblock.blocks.schema.loading import builtin
from learnblock.language import check, from_python, parse, to_python, to_workspace
from learnblock.language import format as format_program
from learnblock.language.workspace.blocks import Workspace

SOURCES = Path(__file__).parents[1] / "src"

#: The text of a program and its blocks before the edit; an edit aligns the new blocks with them.
Before = tuple[str, Workspace]
LINES = 1000
RUNS = 5
TURNS = 3

BLOCKTEXT = """\
x = x + 2 * (y - 1)
function.move_straight(advSpeed=x)
if x > 3 and not function.is_any_tag():
    y += 1
end
while y < 4:
    function.turn(90)
end
"""
PYTHON = """\
class Stack{n}:
    def __init__(self, items=()):
        self.items = list(items)

    def pop(self):
        try:
            return self.items.pop()
        except IndexError as error:
            return None


print([x * 2 for x in range(9) if x])
"""


def program(part: str, head: str = "") -> str:
    """A program of some 1,000 lines."""
    times = LINES // part.count("\n")
    return head + "".join(part.replace("{n}", str(number)) for number in range(times))


def edited(before: Before, notation: str) -> float:
    """Seconds of an edit in the middle of a text: to read it, write the others, and check it."""
    text, blocks = before
    lines = text.split("\n")
    place = next(n for n in range(len(lines) // 2, len(lines)) if "2" in lines[n])
    lines[place] = lines[place].replace("2", "3", 1)
    text = "\n".join(lines)
    start = time.perf_counter()
    program = from_python(text) if notation == "python" else parse(text)
    to_workspace(program, builtin(), blocks)
    python = to_python(program).text
    format_program(program)
    check(program, builtin(), python=python)
    return time.perf_counter() - start


def measured() -> dict[str, float]:
    """The best seconds of an edit, by what was edited."""
    blocktext, plain = program(BLOCKTEXT, "x = 0\ny = 0\n"), program(PYTHON)
    with_robot = to_python(parse(blocktext)).text
    edits = {
        "Block-Text": (blocktext, "blocktext"),
        "Python with a robot": (with_robot, "python"),
        "Python without a robot": (plain, "python"),
    }
    found = {}
    for name, (text, notation) in edits.items():
        tree = from_python(text) if notation == "python" else parse(text)
        before = text, to_workspace(tree, builtin()).workspace
        found[name] = min(edited(before, notation) for _ in range(RUNS))
    return found


def measured_with(sources: Path) -> dict[str, float]:
    """What another process measures with some sources."""
    environment = {**os.environ, "PYTHONPATH": str(sources)}
    command = [sys.executable, __file__, "--alone"]
    found = subprocess.run(command, env=environment, check=True, capture_output=True, text=True)
    times: dict[str, float] = json.loads(found.stdout)
    return times


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--base", type=Path, help="a folder with the sources of another version")
    parser.add_argument("--alone", action="store_true", help=argparse.SUPPRESS)
    given = parser.parse_args()
    if given.alone:
        print(json.dumps(measured()))
        return
    compared = [SOURCES, *([given.base / "src"] if given.base else [])]
    turns = [[measured_with(sources) for sources in compared] for _ in range(TURNS)]
    best = [
        {name: min(turn[which][name] for turn in turns) for name in turns[0][which]}
        for which in range(len(compared))
    ]
    for name, seconds in best[0].items():
        ratio = f"   {seconds / best[1][name]:.2f} of the base" if given.base else ""
        print(f"{name:26}{1000 * seconds:>8.0f} ms{ratio}")


if __name__ == "__main__":
    main()
