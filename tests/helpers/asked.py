"""Questions about runs, and what is answered, in tests."""

from pathlib import Path
from typing import Any

from learnblock.why.answers import answer
from learnblock.why.history import EventHistory
from learnblock.why.parser import parse
from learnblock.why.sentences import Explanation
from logged_runs import logged_text


def run_of(folder: Path, program: str, robot: str = "sim-ebo", **options: Any) -> EventHistory:
    """What a program in Block-Text did."""
    options = {"world": "empty", "seconds": 12, "seed": 0, **options}
    return logged_text(folder, program, robot, **options).history


def answered(history: EventHistory, question: str) -> Explanation:
    """The answer to a question in words."""
    return answer(history, parse(question, history))


def told(explanation: Explanation) -> list[tuple[str, int]]:
    """The codes and lines of an answer's first sentences."""
    return [(sentence.phrase.code, sentence.line) for sentence in explanation.sentences]
