"""What a page shows of a lesson: no answers, no solutions, nothing of the teacher's."""

import random
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from itertools import count, islice
from typing import Literal

from learnblock.i18n import Phrase
from learnblock.language import Workspace
from learnblock.lessons import puzzles
from learnblock.lessons.checks import Collided, GoalReached, Happens, Never, Reaches, Size, Uses
from learnblock.lessons.describing import describe
from learnblock.lessons.drawing import drawn_part
from learnblock.lessons.judging import Verdict
from learnblock.lessons.lesson import Step
from learnblock.lessons.reading import OpenLesson
from learnblock.lessons.texts import MOST_DRAWINGS, drawn_blocks, plain
from learnblock.project.files.lesson_folder import PUZZLE, QUIZ, Progress, StepProgress
from learnblock.server import catalog, messages


def words(text: str | Mapping[str, str] | Phrase) -> messages.LessonWords:
    """What a pupil reads, in the form of messages."""
    if isinstance(text, Phrase):
        return messages.LessonWords(phrase=text)
    return messages.LessonWords(plain(text))


def goals(verdicts: Sequence[Verdict], done: StepProgress) -> tuple[messages.LessonGoal, ...]:
    """The checks of a step, with their verdicts."""
    return tuple(_goal(verdict, done) for verdict in verdicts)


def untried(verdicts: Sequence[Verdict]) -> tuple[Verdict, ...]:
    """Verdicts before the first run: what the program still lacks is open, not missed."""
    return tuple(
        replace(verdict, state="open", reason=None) if verdict.state == "failed" else verdict
        for verdict in verdicts
    )


def _goal(verdict: Verdict, done: StepProgress) -> messages.LessonGoal:
    ask, subject = _question(verdict)
    has_failed = verdict.state == "failed"
    miss = verdict.miss if has_failed else None
    return messages.LessonGoal(
        say=words(verdict.check.say or describe(verdict.check)),
        state=verdict.state,
        optional=verdict.check.optional,
        reason=verdict.explanation if has_failed else None,
        place=miss.place if miss else None,
        nearest=miss.nearest if miss else None,
        earned=f"check-{verdict.index}" in done.stars,
        ask=ask,
        subject=subject,
    )


def _question(verdict: Verdict) -> tuple[Literal["", "now", "goal", "bump"], str]:
    """The question about the run that leads to why a check failed: its kind and subject."""
    check = verdict.check
    if verdict.state != "failed" or isinstance(check, Uses | Size):
        # What is wrong is in the text of the program.
        return "", ""
    if isinstance(check, Never) and isinstance(check.what, Collided):
        return "bump", ""
    if isinstance(check, Reaches):
        return "goal", check.goals[0] if len(check.goals) == 1 else ""
    if isinstance(check, Happens) and isinstance(check.what, GoalReached):
        return "goal", check.what.name
    return "now", ""


def steps(opened: OpenLesson, progress: Progress) -> tuple[messages.LessonStep, ...]:
    """The steps of a lesson, with the stars earned."""
    return tuple(
        messages.LessonStep(
            title=plain(step.title),
            phase=step.phase,
            stars=len(names := tuple(catalog.star_names(step))),
            earned=len(set(names) & set(progress.of(number).stars)),
        )
        for number, step in enumerate(opened.lesson.step, 1)
    )


def quiz(step: Step, done: StepProgress) -> messages.LessonQuiz | None:
    """The question of a step, without what is right."""
    if step.quiz is None:
        return None
    choices = step.quiz.choices
    return messages.LessonQuiz(
        question=plain(step.quiz.question),
        choices=tuple(plain(choice.text) for choice in choices),
        several=sum(choice.right for choice in choices) > 1,
        solved=QUIZ in done.stars,
    )


def puzzle(
    opened: OpenLesson, step: Step, done: StepProgress
) -> tuple[messages.LessonPuzzle | None, tuple[str, ...]]:
    """The puzzle of a step, and its pieces in the right order."""
    if step.puzzle is None:
        return None, ()
    right, *_ = puzzles.right_orders(opened, step.puzzle)
    pieces = [*right, *(line.strip() for line in step.puzzle.distractors)]
    # The same for everyone and each time, so that a page that is reloaded shows the same.
    for seed in count():
        shuffled = random.Random(seed).sample(pieces, len(pieces))  # noqa: S311 - no secret
        if tuple(shuffled[: len(right)]) != right or len(set(pieces)) == 1:
            break
    return messages.LessonPuzzle(tuple(shuffled), PUZZLE in done.stars), right


def judged_puzzle(opened: OpenLesson, step: Step, given: Sequence[str]) -> messages.PuzzleJudged:
    """Judge the pieces of a step's puzzle in the order in which a pupil has put them."""
    assert step.puzzle is not None  # noqa: S101 - it is asked for a step with one
    judged = puzzles.judge(given, puzzles.right_orders(opened, step.puzzle))
    return messages.PuzzleJudged(judged.right, judged.good)


def drawings(step: Step, pieces: Iterable[str] = ()) -> dict[str, Workspace]:
    """The blocks of a step's texts and of the pieces of its puzzle, by their Block-Text."""
    texts = (step.text,) if isinstance(step.text, str) else step.text.values()
    return drawings_in(texts, pieces)


def drawings_in(texts: Iterable[str], pieces: Iterable[str] = ()) -> dict[str, Workspace]:
    """The blocks of Markdown and of the pieces of a puzzle, by their Block-Text."""
    fences = (fence.strip("\n") for text in texts for fence in drawn_blocks(text))
    wanted = islice(dict.fromkeys((*fences, *pieces)), MOST_DRAWINGS)
    drawn = ((source, drawn_part(source)) for source in wanted)
    return {source: workspace for source, workspace in drawn if workspace is not None}
