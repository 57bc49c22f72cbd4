"""Faults planted into examples and solutions of lessons, and the questions about them."""

import tomllib
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from learnblock.errors import LearnBlockError
from learnblock.why.answers import answer
from learnblock.why.history import EventHistory
from learnblock.why.parser import parse
from learnblock.why.sentences import FIRST
from logged_runs import logged_text
from places import ROOT

#: The ways of asking: as the list of questions writes it, and in plain sentences.
WAYS = ("short", "en", "es")


@dataclass(frozen=True)
class Planted:
    """A program with a planted fault.

    Args:
        source: the file of the program, relative to the repository.
        lines: the wrong ones, in the changed program.
    """

    name: str
    source: str
    old: str
    new: str
    lines: list[int]
    robot: str
    world: str
    seconds: float
    short: str
    en: str
    es: str

    @property
    def program(self) -> str:
        """The program with its fault."""
        text = (ROOT / self.source).read_text("utf-8")
        assert self.old in text, f"{self.source} has changed: {self.name}"
        return text.replace(self.old, self.new, 1)

    def history(self, folder: Path) -> EventHistory:
        """What the program did."""
        is_file = self.world.endswith(".toml")
        world = str(ROOT / self.world) if is_file else self.world
        return logged_text(
            folder, self.program, self.robot, world=world, seconds=self.seconds, seed=0
        ).history


@dataclass(frozen=True)
class Tried:
    """A way of asking, and the lines of the answer's first sentences."""

    fault: Planted
    way: str
    #: Whether the question was understood.
    is_understood: bool
    lines: tuple[int, ...]

    @property
    def is_found(self) -> bool:
        return any(line in self.fault.lines for line in self.lines)


def planted_faults() -> list[Planted]:
    """Read the planted faults."""
    path = ROOT / "tests/cases/why/planted.toml"
    return [Planted(**fault) for fault in tomllib.loads(path.read_text("utf-8"))["fault"]]


def tries(fault: Planted, folder: Path) -> Iterator[Tried]:
    """Ask about a fault in each way."""
    history = fault.history(folder)
    for way in WAYS:
        try:
            question = parse(getattr(fault, way), history)
        except LearnBlockError:
            yield Tried(fault, way, is_understood=False, lines=())
            continue
        sentences = answer(history, question).sentences[:FIRST]
        yield Tried(
            fault, way, is_understood=True, lines=tuple(sentence.line for sentence in sentences)
        )
