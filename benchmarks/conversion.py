"""Measure the time to convert Block-Text to Python, compared with the paper's own tool.

Run it with ``python benchmarks/conversion.py``. Each time is the best of several runs.
"""

import time
from collections.abc import Callable
from pathlib import Path

from learnblock.language import check, format, from_python, parse, to_python  # noqa: A004
from learnblock.language.tree.nodes import Comment
from learnblock.language.tree.traversal import statements

CASES = Path(__file__).parent.parent / "tests" / "cases"
LINES = (
    "x = x + 2 * (y - 1)",
    "function.move_straight(advSpeed=x)",
    "if x > 3 and not function.is_any_tag():",
    "y += 1",
    "end",
    "while y < 4:",
    "function.turn(90)",
    "end",
)
STATEMENTS = 6


def synthetic(count: int) -> str:
    """Return a program of `count` statements."""
    return "x = 0\ny = 0\n" + ("\n".join(LINES) + "\n") * ((count - 2) // STATEMENTS)


def milliseconds(work: Callable[[], object], runs: int) -> float:
    best = float("inf")
    for _ in range(runs):
        start = time.perf_counter()
        work()
        best = min(best, time.perf_counter() - start)
    return best * 1000


def case(name: str) -> str:
    return (CASES / name / "program.bt").read_text(encoding="utf-8")


# The last number is the time in ms in which the paper's tool parses and generates on a similar
# machine.
PROGRAMS = (
    ("listing 4", case("square_trajectory"), 16.0),
    ("listings 7 and 8", case("reaction_to_tags"), 50.0),
    ("200 statements", synthetic(200), 730.0),
    ("1,000 statements", synthetic(1000), 3600.0),
    ("2,000 statements", synthetic(2000), 7600.0),
)


def report(name: str, text: str, original: float) -> None:
    program = parse(text)
    main = program.main.body if program.main else ()
    count = sum(not isinstance(node, Comment) for node in statements(program.items + main))
    python = to_python(program).text
    runs = 7 if count > 100 else 500
    ours = milliseconds(lambda: to_python(parse(text)), runs)
    print(
        f"{name:17} {count:5} {ours:9.3f} {ours / count * 1000:9.1f} {original / ours:8.0f}x"
        f" {milliseconds(lambda: format(program), runs):9.3f}"
        f" {milliseconds(lambda: check(program, {}), runs):9.3f}"
        f" {milliseconds(lambda: from_python(python), runs):11.3f}"
    )


def main() -> None:
    print(f"{'':17} state-  parse and  us/state-  faster")
    print(f"{'':17} ments  generate ms    ment            format ms  check ms  from python")
    for name, text, original in PROGRAMS:
        report(name, text, original)


if __name__ == "__main__":
    main()
