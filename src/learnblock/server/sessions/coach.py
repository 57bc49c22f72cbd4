"""Guides the pages of a project through its lesson."""

import dataclasses
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Protocol

from anyio import to_thread

from learnblock.blocks.block_sets import BlockSet
from learnblock.errors import LearnBlockError
from learnblock.lessons import trying
from learnblock.lessons.expert import Experts
from learnblock.lessons.judging import Verdict, judge
from learnblock.lessons.lesson import Step
from learnblock.lessons.reading import OpenLesson
from learnblock.lessons.texts import plain
from learnblock.project.files.lesson_folder import EVERYWHERE, GOALS, LessonFolder, Progress
from learnblock.project.files.packing import packed
from learnblock.project.files.project import Project
from learnblock.project.files.unpacking import tags_used
from learnblock.runtime.trace_sinks import LineSink
from learnblock.server import messages
from learnblock.server.runs.viewers import Viewer, Viewers
from learnblock.server.sessions import lesson_stage as stage
from learnblock.server.sessions import lesson_view as view
from learnblock.server.sessions.hint_series import HintSeries
from learnblock.server.sessions.kept_progress import KeptProgress
from learnblock.server.sessions.lesson_trials import LessonCheck
from learnblock.server.sessions.parts import Parts
from learnblock.server.sessions.project_robots import ProjectRobots
from learnblock.server.sessions.run_judge import Looked, RunJudge, world_of
from learnblock.server.sessions.runs import Runs
from learnblock.server.sessions.step_questions import StepQuestions

if TYPE_CHECKING:
    from learnblock.lessons.hints import Hint


class TaughtProject(Protocol):
    """An open project that follows a lesson."""

    @property
    def name(self) -> str:
        """Its name."""

    @property
    def project(self) -> Project:
        """The project in the form that is saved."""

    @property
    def parts(self) -> Parts:
        """Its programs with their robots, the pupil's first."""

    @property
    def variant(self) -> int:
        """The number of its world's variant."""

    @property
    def viewers(self) -> Viewers:
        """The pages that show it."""

    @property
    def robots(self) -> ProjectRobots:
        """Its robots in their world."""

    @property
    def runs(self) -> Runs:
        """The runs of its programs."""

    async def restore(self, earlier: Project) -> None:
        """Restore earlier programs, with the current world."""

    def show_blocks(self, block_set: BlockSet) -> None:
        """Show the blocks of a set in the palette."""


class Coach:
    """A project's lesson: its step, and the reports to its pages about their program.

    Its methods run in the event loop; a caller that changes something must hold the project's
    `turn`.

    Args:
        pupil: the project.
        opened: the lesson, without the teacher's part.
        progress: the progress of the project.
        keep: returns where the progress is kept, by the name of the project.
    """

    def __init__(
        self,
        pupil: TaughtProject,
        opened: OpenLesson,
        progress: Progress,
        keep: Callable[[str], LessonFolder],
    ) -> None:
        self._pupil = pupil
        self._opened = opened
        self._progress = KeptProgress(opened, progress, lambda: keep(pupil.name))
        self._questions = StepQuestions(opened, self._progress)
        self._experts = Experts(opened)
        self._looked: Looked | None = None
        self._hints = HintSeries()
        self._judge: RunJudge | None = None
        self._check = LessonCheck(pupil.viewers.send)

    @property
    def number(self) -> int:
        """The number of the current step, from 1."""
        return self._progress.number

    @property
    def step(self) -> Step:
        """The current step."""
        return self._progress.step

    # Pages.

    def join(self, page: Viewer) -> None:
        """Send a page the current step."""
        page.send(self._shown())
        if self._check.progress.attempts:
            page.send(self._check.progress)
        if self._hints.given:
            page.send(self._hints_now())

    async def close(self) -> None:
        """Stop judging and checking."""
        self._check.stop()
        if self._judge:
            self._judge.ended()
            await self._judge.wait()
        await self._check.wait()

    # Steps.

    async def show_step(self, number: int) -> None:
        """Go to a step.

        Raises:
            LearnBlockError: there is no such step, or a program runs.
        """
        self._opened.step(number)
        self._pupil.runs.require_rest()
        before, after = self._opened.group(self.number), self._opened.group(number)
        folder = self._progress.folder
        if before != after:
            await to_thread.run_sync(folder.keep_program, before, self._pupil.project)
        self._forget()
        self._progress.go_to(number)
        left = await to_thread.run_sync(folder.program, after) if before != after else None
        await self._set_the_stage(left, fresh=before != after)
        await self._look()
        self._tell()

    async def restart_step(self) -> None:
        """Begin with the first program of the step again.

        Raises:
            LearnBlockError: a program runs.
        """
        self._pupil.runs.require_rest()
        self._forget()
        await self._set_the_stage(None, fresh=True)
        await self._look()
        self._tell()

    async def begin(self) -> None:
        """Set up the first step of a new project."""
        self._show_blocks()
        await self._progress.save()
        await self._look()
        self._tell()

    async def resume(self) -> None:
        """Look at the program of a project that has been opened again."""
        await self._look()

    async def show_variant(self, robot: str, variant: int) -> None:
        """Choose a robot of the step, and a variant of its world.

        Raises:
            LearnBlockError: the step does not support this robot, or a program runs.
        """
        if robot not in self._opened.robots(self.number):
            raise LearnBlockError("server-lesson-other-robot", robot=robot)
        self._pupil.runs.require_rest()
        world = await to_thread.run_sync(stage.world_here, self._opened, self.number, robot)
        first = self._pupil.parts.first
        if first.robot.name != robot:
            await self._pupil.robots.choose(first, robot)
        await self._pupil.robots.choose_world(world, variant)

    async def _set_the_stage(self, left: Project | None, *, fresh: bool) -> None:
        """Choose the world, robots, program and blocks of the current step."""
        first = self._pupil.parts.first
        start = await to_thread.run_sync(
            stage.beginning, self._opened, self.number, first.name, first.robot.name
        )
        names = {part.name for part in start.parts[1:]}
        for part in self._pupil.parts:
            if part is not first and part.name not in names:
                await self._pupil.robots.close(part.name)
        if first.robot.name not in self._opened.robots(self.number):
            await self._pupil.robots.choose(first, start.robot)
        await self._pupil.robots.choose_world(start.world)
        if fresh or len(self._pupil.parts) < len(start.parts):
            before = left or (start if fresh else self._pupil.project)
            mine = dataclasses.replace(before.parts[0], name=self._pupil.parts.first.name)
            wanted = [mine, *start.parts[1:]]
            await self._pupil.restore(start.with_parts(wanted))
        self._show_blocks()
        await self._progress.save()

    def _show_blocks(self) -> None:
        if blocks := stage.blocks_of(self._opened, self.number):
            self._pupil.show_blocks(blocks)

    # Runs.

    def watch(self) -> tuple[LineSink, float]:
        """Begin to judge a run that is about to start: what takes its lines, and its limit in s."""
        self._forget_run()
        self._judge = RunJudge(
            self._opened, self.number, self._pupil.parts, self._experts, self._told
        )
        return self._judge.lines, self.step.seconds

    def ended(self) -> None:
        """Judge the run, whose programs have all ended."""
        if self._judge:
            self._judge.ended()

    async def _told(self, looked: Looked, *, live: bool) -> None:
        """Send the pages the results of the checks; after the run, its stars are earned."""
        self._looked = looked
        if not live:
            self._progress.count_run()
        earned = 0 if live else await self._progress.earn(stars_of(looked.verdicts))
        self._pupil.viewers.send(
            messages.LessonGoals(
                view.goals(looked.verdicts, self._progress.done),
                live=live,
                done=not live and GOALS in stars_of(looked.verdicts),
                earned=earned,
                steps=view.steps(self._opened, self._progress.whole),
            )
        )

    async def _look(self) -> None:
        """Judge how the program is built, before its run."""
        tree = self._pupil.parts.first.document.good.tree
        verdicts = await to_thread.run_sync(judge, self.step, tree, None, None)
        self._looked = Looked(tree, verdicts)

    # All variants and robots.

    async def check(self) -> None:
        """Begin to check the program on all variants and robots.

        Raises:
            LearnBlockError: the program has errors, or a check is running.
        """
        self._pupil.parts.first.document.require_no_errors()
        number = self.number
        attempts = trying.attempts(self._opened, number)

        async def passed() -> None:
            if number == self.number:
                await self._progress.earn((GOALS, EVERYWHERE))
                self._tell()

        program = await to_thread.run_sync(_given, self._pupil.project)
        self._check.start(self._opened, number, program, attempts, passed)

    @property
    def checking(self) -> bool:
        """Whether the program is being checked on all variants and robots."""
        return self._check.progress.running

    def stop_checking(self) -> None:
        """Stop checking."""
        self._check.stop()

    async def work(self) -> messages.GivenWork:
        """What the pupil hands in.

        Raises:
            LearnBlockError: the step has no checks.
        """
        if not self.step.check:
            raise LearnBlockError("server-lesson-no-checks")
        program = await to_thread.run_sync(_given, self._pupil.project)
        runs = self._progress.done.runs
        return messages.GivenWork(self._opened.name, self.number, program, runs)

    # Hints.

    async def take_hint(self) -> None:
        """Give the next level of the last hint, or the next hint.

        Raises:
            LearnBlockError: there is none left.
        """
        looked = self._looked
        if looked is None:
            raise LearnBlockError("server-lesson-no-hint")
        if not self._hints.hints:
            self._hints = HintSeries(await to_thread.run_sync(self._hinted, looked))
        if not self._hints.has_more:
            raise LearnBlockError("server-lesson-no-hint")
        self._hints = self._hints.longer()
        await self._progress.count_hint()
        self._pupil.viewers.send(self._hints_now())

    def _hinted(self, looked: Looked) -> "tuple[Hint, ...]":
        from learnblock.lessons.hints import Elsewhere, hints  # noqa: PLC0415 - few runs need one

        seen = (looked.tree, looked.verdicts, looked.evidence)
        usual = self._opened.robots(self.number)[0]
        elsewhere = Elsewhere(
            is_variant=self._pupil.variant > 0,
            is_other_robot=self._pupil.parts.first.robot.name != usual,
            passes_usually=GOALS in self._progress.done.stars,
        )
        world = world_of(self._opened, self.number)
        return hints(self.step, *seen, world=world, elsewhere=elsewhere)

    def _hints_now(self) -> messages.LessonHints:
        given = tuple(self._hints.shown())
        return messages.LessonHints(given, self._hints.has_more, self._progress.done.hints)

    # Questions.

    async def answer_quiz(self, choices: Sequence[int]) -> messages.QuizJudged:
        """Judge an answer.

        Raises:
            LearnBlockError: the step has no question, or no such answers.
        """
        judged = await self._questions.answer_quiz(choices)
        self._tell_steps()
        return judged

    async def answer_puzzle(self, order: Sequence[int]) -> messages.PuzzleJudged:
        """Judge the order of the puzzle's pieces.

        Raises:
            LearnBlockError: the step has no puzzle, or no such pieces.
        """
        judged = await self._questions.answer_puzzle(order)
        self._tell_steps()
        return judged

    # Helpers.

    def _tell(self) -> None:
        self._pupil.viewers.send(self._shown())

    def _tell_steps(self) -> None:
        """Send the pages the earned stars."""
        steps = view.steps(self._opened, self._progress.whole)
        self._pupil.viewers.send(
            messages.LessonGoals(view.goals(self._verdicts, self._progress.done), steps=steps)
        )

    @property
    def _verdicts(self) -> tuple[Verdict, ...]:
        """What pages show of the checks."""
        if self._looked is None:
            return ()
        has_run = self._looked.evidence is not None
        return self._looked.verdicts if has_run else view.untried(self._looked.verdicts)

    def _shown(self) -> messages.LessonShown:
        step, done = self.step, self._progress.done
        puzzle, _ = view.puzzle(self._opened, step, done)
        return messages.LessonShown(
            name=self._opened.name,
            title=plain(self._opened.lesson.title),
            level=self._opened.lesson.level,
            steps=view.steps(self._opened, self._progress.whole),
            step=self.number,
            text=plain(step.text),
            drawings=view.drawings(step, puzzle.pieces if puzzle else ()),
            goals=view.goals(self._verdicts, done),
            attempts=len(trying.attempts(self._opened, self.number)) if step.check else 0,
            everywhere=EVERYWHERE in done.stars,
            hints=done.hints,
            quiz=view.quiz(step, done),
            puzzle=puzzle,
            restarts=any(earlier.program for earlier in self._opened.lesson.step[: self.number]),
        )

    def _forget(self) -> None:
        """Forget the last run, which was in another step."""
        self._forget_run()
        self._check.forget()
        self._looked = None

    def _forget_run(self) -> None:
        """Forget the last run, except for what was seen of it."""
        self._check.stop()
        if self._judge:
            self._judge.forget()
        self._hints = HintSeries()


def stars_of(verdicts: Sequence[Verdict]) -> tuple[str, ...]:
    """The stars that a run has earned."""
    required = [verdict for verdict in verdicts if not verdict.check.optional]
    extra = (verdict for verdict in verdicts if verdict.check.optional and verdict.state == "met")
    stars = tuple(f"check-{verdict.index}" for verdict in extra)
    if required and all(verdict.state == "met" for verdict in required):
        return GOALS, *stars
    return stars


def _given(project: Project) -> messages.GivenProgram:
    """The program of a project with the tags that it uses, for where the user's are not known."""
    part, tags = project.parts[0], tags_used(packed(project, home=""))
    return messages.GivenProgram(part.text, part.is_python, dict(tags))
