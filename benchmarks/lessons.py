"""Do a lesson's checks notice mistakes, accept other solutions, and lead to the right hint?

For every lesson: how many mutants of its solutions behave in another way, and how many of those
the checks catch; how many other correct programs they accept. Then how often the right hint comes
first, for the typical wrong programs of the lessons and for those in `tests/cases/hints`.

    benchmarks/lessons.py --lesson 1-03-square --mutants 60 --variations 100
    benchmarks/lessons.py --hints

Two programs behave alike if their traces are equal but for the lines that ran. A mutant that
behaves in another way may solve the task all the same: `tests/cases/mutants.toml` says which, and
why. They are counted on their own.
"""

import argparse
import sys
from collections.abc import Iterator, Sequence
from dataclasses import astuple, dataclass
from itertools import islice
from math import ceil
from pathlib import Path

from learnblock.lessons.checks import Size, Uses
from learnblock.lessons.judging import is_done
from learnblock.lessons.mutants import mutants
from learnblock.lessons.reading import OpenLesson, find_lesson, shipped
from learnblock.lessons.trying import JudgedRun, attempts
from learnblock.lessons.variations import variations

sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "helpers"))

from hint_cases import Case, hints_for, lesson_cases, own_cases
from lesson_tries import behaviour, tried, tried_until_failed
from right_programs import is_right


@dataclass
class Tally:
    """Mutants and variations of a step, of a lesson, or of all."""

    made: int = 0
    equal: int = 0
    #: Those that behave in another way and solve the task all the same.
    solving: int = 0
    caught: int = 0
    varied: int = 0
    accepted: int = 0
    #: Variations that lack the construct for which the step asks.
    without: int = 0

    def count_variation(self, done: Sequence[JudgedRun]) -> bool:
        """Count another solution; return whether it is not refused."""
        failed = [check for one in done for check in one.verdicts if check.state == "failed"]
        needed = [one.check for one in failed if not one.check.optional]
        if needed and all(isinstance(one, Uses | Size) for one in needed):
            self.without += 1
            return True
        self.varied += 1
        self.accepted += not needed
        return not needed

    def __add__(self, other: "Tally") -> "Tally":
        return Tally(*(one + two for one, two in zip(astuple(self), astuple(other), strict=True)))

    def __str__(self) -> str:
        wrong = self.made - self.equal - self.solving
        share = 100 * self.caught / wrong if wrong else 100
        return (
            f"mutants {self.made:4}  alike {self.equal:3}  also right {self.solving:3}  "
            f"caught {self.caught:3} of {wrong:3} ({share:5.1f} %)  "
            f"variations accepted {self.accepted} of {self.varied}"
            + (f", {self.without} without what is asked for" if self.without else "")
        )


@dataclass(frozen=True)
class Samples:
    """How many programs a step is tried with, and which.

    Args:
        mutants: how many.
        variations: how many.
        seed: which ones.
        variants: of the world, at most; the step may have fewer.
        verbose: whether to name what went wrong.
    """

    mutants: int
    variations: int
    seed: int
    variants: int
    verbose: bool


def measure(opened: OpenLesson, step: int, options: Samples) -> Tally:
    """Try the mutants and variations of a step's solution."""
    solution = opened.solution(step)
    assert solution is not None  # noqa: S101 - the caller has looked
    count = min(opened.step(step).variants, options.variants)
    wanted = attempts(opened, step, robots=opened.robots(step)[:1], variants=count)
    [right] = tried(opened, step, [solution], wanted)
    tally = Tally()
    if not all(is_done(one.verdicts) for one in right):
        print(f"  step {step}: THE SOLUTION FAILS")
        return tally
    expected = [behaviour(one.trace) for one in right]
    made = list(islice(mutants(solution, options.seed), options.mutants))
    results = tried_until_failed(opened, step, [one.source for one in made], right)
    for mutant, done in zip(made, results, strict=True):
        tally.made += 1
        if [behaviour(one.trace) for one in done] == expected:
            tally.equal += 1
        elif not all(is_done(one.verdicts) for one in done):
            tally.caught += 1
        elif is_right("mutants", opened.name, step, mutant.what):
            tally.solving += 1
        elif options.verbose:
            print(f"  step {step}: not caught: {mutant.what}")
    others = list(islice(variations(solution, options.seed), options.variations))
    results = tried(opened, step, [one.source for one in others], wanted)
    for variation, done in zip(others, results, strict=True):
        if not tally.count_variation(done) and options.verbose:
            print(f"  step {step}: refused: {variation.what}")
    return tally


def measure_lesson(opened: OpenLesson, options: argparse.Namespace) -> Tally:
    """Try the mutants and variations of a lesson, the same number for each of its solutions."""
    steps = [
        step
        for step in range(1, len(opened.lesson.step) + 1)
        if opened.solution(step) is not None and opened.step(step).check
    ]
    samples = Samples(
        ceil(options.mutants / len(steps)),
        ceil(options.variations / len(steps)),
        options.seed,
        options.variants,
        options.verbose,
    )
    total = Tally()
    for step in steps:
        tally = measure(opened, step, samples)
        if options.verbose:
            print(f"  step {step}: {tally}", flush=True)
        total += tally
    print(f"{opened.name:22} {total}", flush=True)
    return total


def measure_hints(cases: Iterator[Case], options: argparse.Namespace) -> tuple[int, int, int]:
    """How many wrong programs there are, how many right hints came first, or among two."""
    count = first = second = 0
    for case in cases:
        rules = [one.rule for one in hints_for(case)]
        count += 1
        first += any(rule in case.wanted for rule in rules[:1])
        second += any(rule in case.wanted for rule in rules[:2])
        if options.verbose and not set(rules[:1]) & set(case.wanted):
            print(f"  {case.name}: {', '.join(case.wanted)} wanted, got {', '.join(rules[:3])}")
    return count, first, second


def report_hints(name: str, found: tuple[int, int, int]) -> None:
    count, first, second = found
    if count:
        print(
            f"{name}: right hint first {first} of {count} ({100 * first / count:.1f} %), "
            f"among the first two {second} ({100 * second / count:.1f} %)"
        )


def main() -> None:
    options = _options()
    names = options.lesson or shipped()
    lessons = [find_lesson(name) for name in names]
    if not options.hints:
        total = sum((measure_lesson(opened, options) for opened in lessons), Tally())
        print(f"{'all':22} {total}")
    report_hints("lessons", measure_hints(_lesson_cases(lessons), options))
    if not options.lesson:
        report_hints("tests/cases/hints", measure_hints(own_cases(), options))


def _lesson_cases(lessons: Sequence[OpenLesson]) -> Iterator[Case]:
    for opened in lessons:
        yield from lesson_cases(opened)


def _options() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--lesson", action="append", help="a lesson; without it all")
    parser.add_argument("--mutants", type=int, default=40, help="of each lesson")
    parser.add_argument("--variations", type=int, default=10, help="of each lesson")
    parser.add_argument("--seed", type=int, default=0, help="of the sample")
    parser.add_argument("--variants", type=int, default=3, help="of the world, at most")
    parser.add_argument("--hints", action="store_true", help="measure only hints")
    parser.add_argument("--verbose", action="store_true", help="name what went wrong")
    return parser.parse_args()


if __name__ == "__main__":
    main()
