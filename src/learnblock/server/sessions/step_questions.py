"""The questions of a lesson's step, the quiz and the puzzle, and the answers to them."""

from collections.abc import Sequence

from learnblock.errors import LearnBlockError
from learnblock.lessons.opened import OpenLesson
from learnblock.lessons.texts import plain
from learnblock.project.files.lesson_folder import PUZZLE, QUIZ
from learnblock.server import messages
from learnblock.server.sessions import lesson_view as view
from learnblock.server.sessions.kept_progress import KeptProgress


class StepQuestions:
    """Judges answers to the questions of the current step.

    Args:
        opened: the lesson.
        progress: counts the answers, and has the current step.
    """

    def __init__(self, opened: OpenLesson, progress: KeptProgress) -> None:
        self._opened = opened
        self._progress = progress

    async def answer_quiz(self, choices: Sequence[int]) -> messages.QuizJudged:
        """Judge an answer.

        Raises:
            LearnBlockError: the step has no question, or no such answers.
        """
        quiz = self._progress.step.quiz
        if quiz is None or any(index >= len(quiz.choices) for index in choices):
            raise LearnBlockError("server-lesson-no-question")
        chosen = set(choices)
        right = chosen == {index for index, choice in enumerate(quiz.choices) if choice.right}
        because = {
            str(index): plain(choice.because)
            for index, choice in enumerate(quiz.choices)
            if index in chosen and choice.because is not None
        }
        self._progress.choose([*chosen])
        await self._progress.count_try(QUIZ, right=right)
        return messages.QuizJudged(right, because)

    async def answer_puzzle(self, order: Sequence[int]) -> messages.PuzzleJudged:
        """Judge the order of the puzzle's pieces.

        Raises:
            LearnBlockError: the step has no puzzle, or no such pieces.
        """
        step = self._progress.step
        puzzle, _ = view.puzzle(self._opened, step, self._progress.done)
        if puzzle is None or any(index >= len(puzzle.pieces) for index in order):
            raise LearnBlockError("server-lesson-no-question")
        judged = view.judged_puzzle(self._opened, step, [puzzle.pieces[index] for index in order])
        await self._progress.count_try(PUZZLE, right=judged.right)
        return judged
